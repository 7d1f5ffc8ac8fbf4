# SPDX-License-Identifier: GPL-2.0-or-later
"""What was identified: as text, as lines of a .prm, as numbers for JSON."""
import math

from .laws import MODES

DIGITS = "%.6g"


def number(value):
    """For JSON: None where it is not known or not finite."""
    return None if value is None or not math.isfinite(value) else float(value)


def parameter_lines(fit, interval):
    """The entries of a .prm."""
    lines = ["subsection Model", "  set Strains          = finite",
             "  set Hyperelastic law = " + fit.law.name,
             ("  set Largest stretch  = " + DIGITS) % interval[1], "end",
             "subsection Material",
             "  set Hyperelastic constants = " + ", ".join(
                 ("%s=" + DIGITS) % pair for pair in zip(fit.law.names, fit.constants))]
    if fit.bulk is None:
        lines.append("  # set Bulk modulus         = MPa, from a volumetric test")
    else:
        lines.append(("  set Bulk modulus           = " + DIGITS) % fit.bulk.modulus)
    return lines + ["end"]


def interval_text(value, half_width):
    return "%.4g to %.4g" % (value - half_width, value + half_width)


def constant_lines(fit):
    for i, (name, value) in enumerate(zip(fit.law.names, fit.constants)):
        line = ("  %-7s " + DIGITS + " %s") % (name, value, fit.law.unit(i))
        if fit.half_widths is not None:
            line = "%-28s %g %%: %s" % (line, 100. * fit.confidence,
                                        interval_text(value, fit.half_widths[i]))
        yield line.rstrip()
    yield "  shear modulus at rest %.5g MPa, Young's modulus %.5g MPa" \
        % (fit.law.shear_modulus(fit.constants),
           3. * fit.law.shear_modulus(fit.constants))


def figures_text(figures, where):
    r2 = "" if figures["r2"] is None else "R2 %.6f, " % figures["r2"]
    return "%sresidual rms %.4g, largest %.4g MPa at %.4g" \
        % (r2, figures["rms"], figures["largest"], where)


def test_lines(fit):
    for test, figures in zip(fit.tests, fit.figures):
        yield "  %-11s %s: %d points, stretch %.4g to %.4g%s" % (
            test.kind, test.name, figures["n"], test.stretch.min(),
            test.stretch.max(),
            "" if test.weight == 1. else ", weight %g" % test.weight)
        yield "              " + figures_text(figures, test.stretch[figures["at"]])


def bulk_lines(fit):
    bulk = fit.bulk
    yield "Bulk modulus %.6g MPa, %g %%: %s" % (
        bulk.modulus, 100. * fit.confidence,
        interval_text(bulk.modulus, bulk.half_width))
    for test in bulk.tests:
        yield "  volumetric  %s: %d points, J %.5g to %.5g" % (
            test.name, len(test.stretch), test.stretch.min(), test.stretch.max())
    if len(bulk.tests) == 1:
        yield "              " + figures_text(
            bulk.figures, bulk.tests[0].stretch[bulk.figures["at"]])


def parts_text(parts):
    return ", ".join("%.4g to %.4g" % part for part in parts)


def stability_lines(checked, interval):
    yield "Drucker stability, stretches %.4g to %.4g" % interval
    for mode in MODES:
        found = checked[mode]
        if found["to"] is None:
            yield "  %-11s the law has no stress there" % mode
            continue
        short = "" if found["to"] >= interval[1] * (1. - 1e-9) \
            else ", the law ends at %.4g" % found["to"]
        yield "  %-11s %s%s" % (mode, "unstable at " + parts_text(found["unstable"])
                                if found["unstable"] else "stable", short)


def warnings_of(fit, checked):
    """Sentences."""
    if fit.law.shear_modulus(fit.constants) <= 0.:
        yield "the shear modulus at rest is not positive; the program refuses that"
    if fit.confidence and fit.half_widths is None:
        yield ("the tests do not tell the constants of %s apart: add a test of "
               "another kind, or choose a law with fewer constants" % fit.law.name)
    for mode in MODES:
        for key, words in (("unstable", "not stable in Drucker's sense"),
                           ("declines", "the nominal stress declines")):
            if checked[mode][key]:
                yield "%s: %s, stretch %s" % (words, mode, parts_text(checked[mode][key]))


def range_lines(ranges):
    """ranges: [(name, [(percent, E)])]."""
    for name, values in ranges:
        yield "Lines through the origin, " + name
        for percent, modulus in values:
            yield "  up to %5g %%  E = %.4g MPa, mu = E/3 = %.4g MPa" \
                % (percent, modulus, modulus / 3.)


def text_of(fit, checked, interval, ranges):
    """What is printed."""
    how = "with the constants given" if fit.confidence is None else \
        "least squares of the %s errors" % ("relative" if fit.relative
                                            else "absolute")
    lines = ["%s, %s" % (fit.law.name, how), *constant_lines(fit), *test_lines(fit)]
    lines += [] if fit.bulk is None else bulk_lines(fit)
    lines += [*stability_lines(checked, interval), *range_lines(ranges)]
    lines += ["warning: " + text for text in warnings_of(fit, checked)]
    return "\n".join(lines + [""] + parameter_lines(fit, interval)) + "\n"


def ranges_of(ranges):
    return [{"of": name, "values": [{"strain_percent": percent, "E_MPa": modulus}
                                    for percent, modulus in values]}
            for name, values in ranges]


def constants_of(fit):
    for i, (name, value) in enumerate(zip(fit.law.names, fit.constants)):
        half = None if fit.half_widths is None else float(fit.half_widths[i])
        yield name, {"value": float(value), "unit": fit.law.unit(i) or "1",
                     "low": None if half is None else number(value - half),
                     "high": None if half is None else number(value + half)}


def json_of(fit, checked, interval, ranges):
    """Numbers and names only."""
    tests = [{"kind": test.kind, "file": test.path, "points": figures["n"],
              "weight": test.weight, "r2": figures["r2"],
              "rms_residual_MPa": figures["rms"],
              "largest_residual_MPa": figures["largest"],
              "stretch": test.stretch.tolist(), "stress_MPa": test.stress.tolist(),
              "fitted_MPa": fit.stress(test).tolist()}
             for test, figures in zip(fit.tests, fit.figures)]
    bulk = fit.bulk and {
        "value": fit.bulk.modulus, "low": fit.bulk.modulus - fit.bulk.half_width,
        "high": fit.bulk.modulus + fit.bulk.half_width, "unit": "MPa",
        "slope_MPa": fit.bulk.slope, "zero_at_volume_ratio": fit.bulk.zero,
        "r2": fit.bulk.figures["r2"]}
    return {"law": fit.law.name, "constants": dict(constants_of(fit)),
            "confidence": fit.confidence, "relative": fit.relative, "tests": tests,
            "shear_modulus_MPa": float(fit.law.shear_modulus(fit.constants)),
            "bulk_modulus": bulk, "stability": checked,
            "range_of_use": list(interval), "linear_ranges": ranges_of(ranges),
            "warnings": list(warnings_of(fit, checked)),
            "parameters": parameter_lines(fit, interval)}
