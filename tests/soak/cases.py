# SPDX-License-Identifier: GPL-2.0-or-later
"""The cases that are disturbed: coarse, but with all that is written out, and
with tolerances so tight that rounding stays below those of compare.py."""
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]

TIGHT = ["Model/Coupling tolerance=1e-8",
         "Model/Running crack tolerance=1e-8",
         "Model/Largest number of coupling iterations=4000",
         "Linear solver/Newton tolerance=1e-10"]

# torn apart, with an adaptive mesh
STRIP = (ROOT / "parameters" / "epdm" / "punctured_strip.prm", TIGHT + [
    "Geometry/Punctured strip/Cell size=2",
    "Mesh/Refined surroundings=", "Mesh/Adaptive levels=1",
    "Model/Length scale=2",
    "Load stepping/Largest step=0.3", "Load stepping/First step=0.3",
    "Load stepping/End time=4.8", "Load stepping/Stop when force falls below=0.15",
    "Output/Checkpoint every=2", "Output/Fields every=2",
    "Output/Crack volume=true",
    "Output/Displacement at points=left : 0.3, 20 ; right : 17, 13.37"])

# the first steps of it
STRIP_SHORT = (STRIP[0], [
    setting for setting in STRIP[1]
    if not setting.startswith("Load stepping/End time")] +
    ["Load stepping/End time=1.5"])

STRIP_3D = (ROOT / "tests" / "regression" / "strip_3d.prm", TIGHT + [
    "Mesh/Adaptation=predictor corrector", "Mesh/Adaptive levels=1",
    "Mesh/Refinement margin=0.1", "Output/Checkpoint every=1"])

CASES = {"strip": STRIP, "short strip": STRIP_SHORT, "strip 3d": STRIP_3D}


def arguments(case, directory, *options, settings=()):
    """Words behind the name of the program."""
    words = [str(case[0]), "--output", str(directory), *options]
    for setting in (*case[1], *settings):
        words += ["--set", setting]
    return words
