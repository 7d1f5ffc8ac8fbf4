# SPDX-License-Identifier: GPL-2.0-or-later
"""Bad inputs about finite strain, as in bad_inputs.py."""
from bad_inputs import entry, later, several, value

CONSTANTS = "Material/Hyperelastic constants"
FINITE = [("Model/Strains", "finite"), ("Model/Energy split", "none")]


def rubber(name, pairs, *says, **more):
    """Values that do not go together at finite strain; BASE has the pair
    lambda = 10, mu = 2.4."""
    settings = list(dict(FINITE, **dict(pairs)).items())
    return several("finite strain: " + name, settings, *says, **more)


def law(name, constants, *says, pairs=(), **more):
    """Constants of a law beside K = 1000 MPa."""
    more_pairs = ["%s=%s" % pair for pair in pairs]
    return rubber(", ".join([name, constants or "no constants"] + more_pairs), [
        ("Model/Hyperelastic law", name), (CONSTANTS, constants),
        ("Material/Lame lambda", ""), ("Material/Shear modulus", ""),
        ("Material/Bulk modulus", "1000")] + list(pairs), *says, **more)


YEOH = "C10=1.0129, C20=-0.01226, C30=0.001033"

CASES = [
    value("Model/Strains", "large", "'large'", "small", "finite"),
    value("Model/Hyperelastic law", "Mooney", "'Mooney'", "Mooney-Rivlin"),
    value("Model/Volumetric form", "isochoric", "'isochoric'", "coupled"),
    value("Model/Largest stretch", "1", "found '1'"),
    # what only one kind of strains has
    several("the default split at finite strain", [("Model/Strains", "finite")],
            "Model/Energy split", "found 'volumetric-deviatoric'", "Strains = finite",
            "none, volumetric, principal stretches"),
    entry("Model/Energy split", "volumetric", "Strains = small",
          "none, volumetric-deviatoric, spectral"),
    entry("Model/Energy split", "principal stretches", "Strains = small", "spectral"),
    entry("Model/Pressure law", "cubic", "Strains = small", "relaxed bulk"),
    rubber("degraded divergence", [("Model/Pressure law", "degraded divergence")],
           "Model/Pressure law", "found 'degraded divergence'", "Strains = finite",
           "relaxed bulk, cubic"),
    law("Yeoh", YEOH, "Model/Energy split", "principal stretches", "= Yeoh",
        "neo-Hooke, Ogden", pairs=[("Model/Energy split", "principal stretches")]),
    rubber("principal stretches without volume", [
        ("Model/Energy split", "principal stretches"),
        ("Model/Volumetric form", "isochoric, K/2 (J-1)^2")],
        "Model/Energy split", "Model/Volumetric form", "coupled"),
    rubber("a fluid", [("Fluid/Pressure", "1e-3")], "Fluid/Pressure", "'1e-3'",
           "Strains = finite", "0"),
    rubber("a pressure in plane stress", [("Boundary conditions/Pressure", "right : 1")],
           "Boundary conditions/Pressure", "plane stress", "plane strain", "normal"),
    # names of constants
    entry(CONSTANTS, "C10=1", "'C10=1'", "Strains = small", "nothing"),
    law("Yeoh", "", "Hyperelastic constants", "found nothing", "C10, C20, C30"),
    law("Yeoh", "C10=1, C20=0", "Hyperelastic constants", "found C10, C20",
        "C30 is missing"),
    law("Yeoh", "C10=1, C01=0.1", "unknown 'C01'", "C10, C20, C30"),
    law("Yeoh", "C10=1, C10=2", "C10 is given twice"),
    law("Yeoh", "C10", "'C10'", "name = value"),
    law("Yeoh", "C10=soft, C20=0, C30=0", "Hyperelastic constants: C10", "soft"),
    law("Ogden", "mu1=1, alpha1=2, mu2=1", "found mu1, alpha1, mu2", "alpha2 is missing"),
    law("Ogden", "mu2=1, alpha2=2", "mu1, alpha1 is missing"),
    law("Yeoh", YEOH, "exactly one of", "Bulk modulus", pairs=[
        ("Material/Shear modulus", "2")]),
    law("Yeoh", YEOH, "found nothing beside", "exactly one of", pairs=[
        ("Material/Bulk modulus", "")]),
    law("Yeoh", YEOH, "exactly one of", pairs=[("Material/Poisson ratio", "0.49")]),
    rubber("neo-Hooke by both", [(CONSTANTS, "mu=2.4")], "Lame lambda, Shear modulus",
           "constants mu", "neo-Hooke", "exactly one of"),
    # values of constants
    law("neo-Hooke", "mu=-1", "Hyperelastic constants", "mu"),
    law("Mooney-Rivlin", "C10=-1, C01=0.2", "Hyperelastic constants", "C10"),
    law("Yeoh", "C10=0, C20=0, C30=0", "Hyperelastic constants", "C10"),
    law("Yeoh", "C10=1, C20=-1, C30=0", "Hyperelastic constants", "C10", "C20"),
    law("Gent", "mu=1, Jm=0", "Hyperelastic constants", "Jm"),
    law("Gent", "mu=1, Jm=20", "Model/Largest stretch: found 5", "Jm = 20"),
    law("Ogden", "mu1=1, alpha1=0", "Hyperelastic constants", "alpha1"),
    law("Ogden", "mu1=1, alpha1=-2", "shear modulus"),
    law("Mooney-Rivlin", "C10=0.1, C01=0.4", "adds 1.6 MPa to lambda",
        "Bulk modulus", pairs=[("Material/Bulk modulus", "2")]),
    law("Yeoh", YEOH, "Material/Poisson ratio = 0.5", "smaller than 0.5", pairs=[
        ("Material/Bulk modulus", ""), ("Material/Poisson ratio", "0.5")]),
    later(law("Yeoh", "C10=1 - x, C20=0, C30=0", "C10", r"Found at \(")),
    law("Yeoh", YEOH, "Material/By material id: 0", "C10", pairs=[
        ("Material/By material id", "0 : C10 = -1")]),
]
