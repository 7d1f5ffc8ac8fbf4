# SPDX-License-Identifier: GPL-2.0-or-later
"""The same case with one change at a time; Python's own library only.

A variation is a list of settings on top of a case whose entries are known in full, as
mixed-cracks writes them to parameters.prm. Group names say what they tell about:

    mesh        grid lines mirrored, in x or y: how far the answer hangs on where the
                cells lie
    h/l         cells at the crack by 2/3 (where the geometry has a cell size) and half
    load steps  first, largest and onset step halved and doubled
    coupling    tolerance of the coupling times 1/10 and 10
    parameters  entries that are asked for, by a share up and down"""
import collections
import re

from report_parts.safe import finite

from .errors import StudyError

Variation = collections.namedtuple("Variation", "group name settings")

NUMERICS = ("mesh", "h/l", "load steps", "coupling")
STEPS = ("First step", "Largest step", "Onset step")
MIRRORED = "Mirrored mesh"  # last word of an entry of a geometry


def number_of(parameters, entry):
    """A number, or None where the entry is missing, empty or an expression."""
    return finite(parameters.get(entry))


def text_of(value):
    return "%.10g" % value


def scaled(parameters, entries, factor):
    """[(entry, value)] of those that have a value above 0."""
    return [(entry, text_of(factor * number_of(parameters, entry)))
            for entry in entries if number_of(parameters, entry)]


def geometry_entry(parameters, last):
    """The entry of the case's geometry with that last name, or None."""
    wanted = (parameters.get("Geometry/Name", "").lower(), last.lower())
    for entry in parameters:
        parts = entry.split("/")
        if len(parts) == 3 and parts[0] == "Geometry" \
                and (parts[1].lower(), parts[2].lower()) == wanted:
            return entry
    return None


def mirrored(parameters):
    """In x and in y, or as usual where the case itself has it mirrored."""
    entry = geometry_entry(parameters, MIRRORED)
    if entry is None:
        return []
    if parameters[entry] not in ("none", ""):
        return [Variation("mesh", "not_mirrored", [(entry, "none")])]
    return [Variation("mesh", "mirrored_in_" + axis, [(entry, axis)]) for axis in "xy"]


def with_more_levels(text, levels):
    """Of 'name : distance : levels ; ...', every number of levels increased."""
    def more(match):
        return match.group(1) + str(int(match.group(2)) + levels)
    return re.sub(r"(:[^:;]*:\s*)(\d+)", more, text)


def finer(parameters):
    found = []
    cell = geometry_entry(parameters, "Cell size")
    if cell and number_of(parameters, cell):
        found.append(Variation("h/l", "two_thirds",
                               scaled(parameters, [cell], 2. / 3.)))
    adaptive = "Mesh/Adaptive levels"
    used = adaptive if number_of(parameters, adaptive) else "Mesh/Global refinements"
    settings = [(used, text_of((number_of(parameters, used) or 0.) + 1.))]
    around = parameters.get("Mesh/Refined surroundings", "")
    if around and used == adaptive:
        settings.append(("Mesh/Refined surroundings", with_more_levels(around, 1)))
    return found + [Variation("h/l", "half", settings)]


def other_steps(parameters):
    entries = ["Load stepping/" + step for step in STEPS]
    return [Variation("load steps", name, scaled(parameters, entries, factor))
            for name, factor in (("half", 0.5), ("double", 2.))]


def other_tolerances(parameters):
    """None where nothing is iterated."""
    if parameters.get("Model/Coupling") != "iterated":
        return []
    return [Variation("coupling", name, scaled(
        parameters, ["Model/Coupling tolerance"], factor))
        for name, factor in (("tenth", 0.1), ("tenfold", 10.))]


def other_parameters(parameters, entries, share):
    found = []
    for entry in entries:
        if number_of(parameters, entry) is None:
            raise StudyError(
                "--parameters: '%s' %s" % (entry, "is '%s' and no number"
                                           % parameters[entry] if entry in parameters
                                           else "is no entry of the case"))
        found += [Variation(entry, word, [
            (entry, text_of((1. + sign * share) * number_of(parameters, entry)))])
            for sign, word in ((1., "plus"), (-1., "minus"))]
    return found


def variations_of(parameters, entries=(), share=0.1):
    """[Variation] of a case whose {"Subsection/Entry": value} are known in full; of
    parameters the group is the entry. Without those that change nothing."""
    found = mirrored(parameters) + finer(parameters) + other_steps(parameters) \
        + other_tolerances(parameters) + other_parameters(parameters, entries, share)
    return [variation for variation in found if variation.settings]


def title_of(group):
    """Of a parameter the entry without its subsection."""
    return group if group in NUMERICS else group.split("/")[-1]


def case_name(variation):
    """As a name of a case: letters, digits and _ only."""
    title = title_of(variation.group).replace("/", "_over_")
    return "%s_%s" % (re.sub(r"[^A-Za-z0-9]+", "_", title).strip("_"), variation.name)
