# SPDX-License-Identifier: GPL-2.0-or-later
"""Words for the quantities of statistics.csv and summary.json, made of their
names: "elastic_energy_mJ" is the elastic energy, in mJ. What the program adds
to its list (source/output/quantities_list.cc) has words without a line here."""

UNITS = {"mm": "mm", "mm2": "mm²", "mm3": "mm³", "N": "N", "MPa": "MPa", "mJ": "mJ", "s": "s"}
PROPER_NAMES = {"newton": "Newton"}


def words_and_unit(name):
    """("elastic energy", "mJ"); the unit is "" where there is none."""
    parts = str(name).split("_")
    unit = UNITS.get(parts[-1], "") if len(parts) > 1 else ""
    if unit:
        parts.pop()
    return " ".join(PROPER_NAMES.get(part, part) for part in parts), unit


def words(name):
    return words_and_unit(name)[0]


def label(name):
    """ "Elastic energy (mJ)" """
    text, unit = words_and_unit(name)
    return text[:1].upper() + text[1:] + (" (%s)" % unit if unit else "")
