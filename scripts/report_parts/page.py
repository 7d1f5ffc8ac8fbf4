# SPDX-License-Identifier: GPL-2.0-or-later
"""The page: everything put together as one HTML text."""
import base64
import datetime
import html
import os
import re

from . import crack_path, curves, moments, pictures, safe, solids, vtu, words
from .results import Results

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} – mixed-cracks</title>
<style>
{style}
</style>
</head>
<body>
{body}
</body>
</html>
"""


CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f\ud800-\udfff]")


def escaped(text):
    return html.escape(CONTROL.sub("\ufffd", str(text)))


def element(tag, content, kind=""):
    return "<%s%s>%s</%s>" % (tag, " class=\"%s\"" % kind if kind else "", content, tag)


def note(text):
    return element("p", text, "note")


def table_of(rows, header=(), kind=""):
    """Rows of cells, all HTML."""
    lines = ["".join(element("th", name) for name in header)] if header else []
    lines += ["".join(element("td", cell) for cell in row) for row in rows]
    return element("table", "".join(element("tr", line) for line in lines), kind)


def aside(remarks):
    items = "".join(element("li", escaped(remark)) for remark in remarks)
    return "<aside><h2>Please note</h2><ul>%s</ul></aside>\n" % items if remarks else ""


def guarded(remarks, what, part, *arguments):
    """What the part returns. Files may hold what nobody foresaw: then a remark,
    and nothing in its place."""
    try:
        return part(*arguments)
    except Exception as error:  # the rest of the page is still worth having
        remarks.append("%s could not be made (%s)." % (what, safe.in_words(error)))
        return ""


def written(directory):
    """The page about the run in this directory, as text."""
    results = Results(directory)
    force = moments.Force(results)
    remarks = []
    remarks += guarded(remarks, "Some remarks", words.remarks_of, results, force)
    middle = (guarded(remarks, "The curve of the force", curve_section, results, force)
              + guarded(remarks, "The pictures", field_sections, results, force,
                        remarks)
              + guarded(remarks, "The curves of the energies", drawn_section, "Energies",
                        curves.energy_curves, results)
              + guarded(remarks, "The curves of the steps", drawn_section, "Steps",
                        curves.step_curves, results)
              + guarded(remarks, "The tables", table_section, results))
    # drawing may add remarks, so the head comes last
    figures = guarded(remarks, "The key figures", words.key_figures, results, force)
    return in_frame(words.title_of(results),
                    head(results, figures, remarks) + middle + foot(results))


def in_frame(title, body):
    """A whole page: the title is text, the body HTML."""
    style = safe.read_text(os.path.join(os.path.dirname(__file__), "page.css"))
    return PAGE.format(title=escaped(title), style=style, body=body)


def head(results, key_figures, remarks):
    figures = "".join(
        "<div><dt>%s</dt><dd>%s<small>%s</small></dd></div>"
        % tuple(escaped(part) for part in figure) for figure in key_figures)
    return "<header><p class=\"kind\">Phase-field fracture</p><h1>%s</h1>" \
        "<p>%s</p><dl class=\"key\">%s</dl></header>\n" \
        % (escaped(words.title_of(results)), escaped(words.case_in_words(results)),
           figures) + aside(remarks)


def curve_section(results, force):
    drawing = curves.force_curve(results, force)
    if drawing is None:
        return section("Force and displacement", note("No force has been written yet."))
    text = "Every dot is an accepted load step."
    thickness = results.number("Material/Thickness")
    if thickness is not None and not results.is_3d:
        text += " Forces are those of the specimen, %s thick." \
            % words.number(thickness, "mm")
    if force.separation is not None:
        text += " %s: %.2g\u00a0%% of the peak force is left." % (
            force.fall_in_words.capitalize(),
            100. * force.values[force.separation] / force.values[force.peak])
    return section("Force and displacement", drawing + note(text))


def why_no_fields(results):
    """What stands in place of the pictures."""
    if os.path.isfile(os.path.join(results.directory, "fields.xdmf")):
        return "The fields are in fields.xdmf, for ParaView. Pictures on this page " \
            "need VTU: <code>Output/Field format = VTU</code> or <code>both</code>."
    if results.parameter("Output/Field format") == "none":
        return "This run writes no fields (<code>Output/Field format = none</code>), " \
            "so there are no pictures."
    return "No fields have been written (fields.pvd names no file that exists)."


def field_sections(results, force, remarks):
    """Pictures of the phase field, and of mesh and deformed body."""
    collection = vtu.read_collection(results.directory)
    if not collection:
        return section("The crack", note(why_no_fields(results))
                       + path_part(results, None, remarks))
    times = [time for time, _ in collection]
    drawn = []
    for index, text in moments.chosen_moments(results, force, times):
        time, path = collection[index]
        try:
            fields = vtu.read_fields(path, ("phase_field", "displacement"))
            if "phase_field" not in fields.data:
                raise vtu.FieldError("%s holds no phase_field"
                                     % os.path.basename(path))
        except vtu.FieldError as error:
            remarks.append("A picture is missing: %s." % error)
            continue
        drawn.append((time, text, fields))
    if not drawn:
        return section("The crack", note("None of the files of fields could be drawn.")
                       + path_part(results, None, remarks))
    first, last = drawn[0][2], drawn[-1]
    if solids.is_solid(first):
        return solid_sections(results, force, drawn, remarks)
    figures = [(pictures.phase_field_picture(fields),
                caption(results, force, time, text)) for time, text, fields in drawn]
    text = note("Phase field φ on the undeformed body"
                + ("." if pictures.is_flat(first) else ", seen along z."))
    return section("The crack", text + row(figures, pictures.window_of(first.points))
                   + color_bar() + path_part(results, last[2], remarks), "long") \
        + body_section(results, drawn)


def solid_sections(results, force, drawn, remarks):
    """The same of a body in 3-d."""
    last = drawn[-1][2]
    region = solids.region_of(last)
    figures = [(solids.crack_picture(fields, region),
                caption(results, force, time, text)) for time, text, fields in drawn]
    text = solids.NOTE
    if solids.is_enlarged(last, region):
        text = text.replace("the edges of the undeformed body",
                            "a box of %s from the undeformed body"
                            % words.number((region[1] - region[0]).max(), "mm"))
    return section("The crack", row(figures, solids.common_window(
        [solids.corners_of(region)])) + note(text)
        + sheet_part(results, remarks), "long") \
        + sections_part(results, region, *drawn[-1]) + body_section(results, drawn)


def sections_part(results, region, time, text, fields):
    """Plane sections through a body in 3-d."""
    figures, windows = [], []
    for axis, position in solids.section_planes(fields):
        picture, window = solids.section_picture(fields, axis, position, region)
        figures.append((picture, "<b>%s = %s</b>%s to the right, %s upwards"
                        % (("xyz"[axis], words.number(position, "mm"))
                           + tuple("xyz"[i] for i in solids.section_axes(axis)))))
        windows.append(window)
    text = note("Phase field φ in three planes %s (%s)." % (
        escaped(text or "at " + words.number(time, "s")), place(results, time)))
    return section("Sections", text
                   + row_of_equal_height(figures, windows, 22.) + color_bar(), "long")


def path_part(results, fields, remarks):
    """The paths of the cracks: over the outline if there are fields, and as a table;
    in 3-d the table of their sheets."""
    if results.is_3d:
        return sheet_part(results, remarks)
    cracks = crack_path.cracks_at_end(results.directory, remarks)
    if not cracks:
        return note("No path is drawn: " + (
            "there is no crack_path.csv." if cracks is None else
            "crack_path.csv holds no crack."))
    text = ""
    if fields is not None:
        picture = pictures.path_picture(fields, cracks)
        low, high = pictures.window_of(fields.points)
        wide = (high - low)[0] > 1.2 * (high - low)[1]
        text = "<div style=\"flex: 0 0 %s\">%s</div>" % (
            "45%" if wide else "24%",
            figures_of([(picture, "<b>Path</b>disc: start, square: end", "100%")]))
    inside = "inside the body"  # an end without a name is a tip
    rows = [["<i style=\"background: %s\"></i>%d" % (pictures.path_color(i), crack.number),
             escaped(crack.start or inside), escaped(crack.end or inside),
             words.known(crack.length), words.known(crack.angle)]
            for i, crack in enumerate(cracks)]
    return element("div", text + table_of(rows, (
        "crack", "starts at", "ends at", "length (mm)", "kink angle (°)")), "paths")


def sheet_part(results, remarks):
    """The cracks in space as a table."""
    sheets = crack_path.rows_at_end(results.directory, crack_path.SHEETS, remarks)
    if not sheets:
        return note("No table of cracks: " + (
            "there is no crack_sheet.csv." if sheets is None else
            "crack_sheet.csv holds no crack."))

    def figures(row, *names):
        return [words.known(safe.finite(row.get(name))) for name in names]

    def normal(row):
        parts = [safe.finite(row.get("normal_" + axis)) for axis in "xyz"]
        return words.known(None) if None in parts else ", ".join(
            "%.2f" % (round(part, 2) + 0.) for part in parts)  # no -0.00

    rows = [[str(number), escaped(row.get("start") or "unknown"),
             escaped(row.get("joins") or "")]
            + figures(row, "area_mm2", "front_length_mm") + [normal(row)]
            + figures(row, "mean_tip_speed_mm_per_s", "largest_tip_speed_mm_per_s",
                      "mean_opening_angle_deg") for number, row in sheets]
    displacement = safe.finite(sheets[0][1].get("displacement_mm"))
    where = "" if displacement is None else " at " + words.number(displacement, "mm")
    return element("div", table_of(rows, (
        "crack", "starts at", "has come to", "area (mm²)", "front (mm)", "mean normal",
        "mean tip speed (mm/s)", "largest tip speed (mm/s)", "opening angle (°)")),
                   "paths") \
        + note("The cracks%s, when they have changed last. Front 0: none is left in the "
               "material." % where)


def body_section(results, drawn):
    """The mesh at the end, the body at the peak and at the end."""
    end_time, _, end_fields = drawn[-1]
    artist = solids if solids.is_solid(end_fields) else pictures
    bodies = []
    for time, text, fields in [d for d in drawn[:-1] if "peak" in d[1]] + [drawn[-1]]:
        scale = pictures.deformation_scale(
            fields, results.parameter("Model/Strains") == "finite") \
            if "displacement" in fields.data else None
        if scale is not None:
            bodies.append((time, text, fields, scale))
    figures = [(artist.mesh_picture(end_fields), "<b>Mesh</b>%s cells, %s"
                % (cells_at(results, end_time, end_fields),
                   escaped(place(results, end_time))))]
    windows = [artist.common_window([end_fields.points])]
    if bodies:
        windows += len(bodies) * [artist.common_window(
            [end_fields.points] + [pictures.deformed_points(fields, scale)
                                   for _, _, fields, scale in bodies])]
    window = windows[-1]
    for time, text, fields, scale in bodies:
        figures.append((artist.deformed_picture(fields, scale, window),
                        "<b>Deformed, %s</b>%s, %s"
                        % (escaped(text or "at " + words.number(time, "s")),
                           escaped(place(results, time)),
                           "true to scale" if scale == 1. else
                           "displacement × " + words.number(scale))))
    text = "Cells that reach φ below %s%s are left out of the deformed body." % (
        pictures.BROKEN, "" if artist is solids else
        ", or are stretched more than %g times," % pictures.TORN)
    return section("Mesh and deformation", row_of_equal_height(figures, windows)
                   + (note(text) if bodies else ""), "long")


def cells_at(results, time, fields):
    row_number, cells = step_at(results, time), results.column("cells")
    return words.number(len(fields.faces)) + " drawn" \
        if row_number is None or cells is None else words.number(cells[row_number])


def step_at(results, time):
    """Row of the statistics at that time, or None."""
    steps = results.column("time_s")
    if steps is None:
        return None
    index = int(abs(steps - time).argmin())
    return index if abs(steps[index] - time) <= 1e-6 * max(abs(time), 1e-9) else None


def place(results, time):
    """Where on the curve a moment lies."""
    index, x = step_at(results, time), results.column("displacement_mm")
    return "t = " + words.number(time, "s") if index is None or x is None \
        else words.number(x[index], "mm")


def caption(results, force, time, text):
    text = escaped(text[:1].upper() + text[1:]) or "At " + words.number(time, "s")
    line = place(results, time)
    index = step_at(results, time)
    if index is not None and force.values is not None:
        line += ", " + words.number(force.values[index], "N")
    return "<b>%s</b>%s" % (text, escaped(line))


def row(figures, window):
    """Figures side by side: as many columns as the shape of the body suits,
    and rows of equal length."""
    low, high = window
    aspect = (high - low)[0] / max((high - low)[1], 1e-300)
    limit = 6 if aspect < 0.8 else 4 if aspect < 1.2 else 3 if aspect < 1.8 else \
        2 if aspect < 4. else 1
    n_rows = -(-len(figures) // limit)
    # few figures do not grow over the whole page
    n_columns = max(-(-len(figures) // n_rows), min(limit, 4 if aspect < 1. else 3))
    width = "calc((100%% - %.2frem) / %d)" % (1.2 * (n_columns - 1) + 0.01, n_columns)
    return figures_of([(png, label, width) for png, label in figures])


def row_of_equal_height(figures, windows, highest=36.):
    """Figures of different shapes in one row, no higher than that many rem."""
    sizes = [high - low for low, high in windows]
    aspects = [size[0] / max(size[1], 1e-300) for size in sizes]
    gaps = 1.2 * (len(figures) - 1) + 0.01
    if sum(aspects) > 4.:  # wide bodies: one below the other
        return figures_of([(png, label, "100%") for png, label in figures])
    return figures_of(
        [(png, label, "min(calc((100%% - %.2frem) * %.4f), %.2frem)"
          % (gaps, aspect / sum(aspects), highest * aspect))
         for (png, label), aspect in zip(figures, aspects)])


def figures_of(figures):
    """[(png, caption, CSS width)] as HTML."""
    return element("div", "".join(
        "<figure style=\"width: %s\"><img alt=\"%s\" "
        "src=\"data:image/png;base64,%s\"><figcaption>%s</figcaption></figure>"
        % (width, re.sub("<[^>]*>", " ", label).strip(),
           base64.b64encode(png).decode("ascii"), label)
        for png, label, width in figures), "pictures")


def color_bar():
    return "<div class=\"bar\">φ = 0, broken <i style=\"background: " \
        "linear-gradient(to right, %s)\"></i> φ = 1, intact</div>" \
        % pictures.CSS_GRADIENT


def drawn_section(title, draw, results):
    drawing = draw(results)
    return "" if drawing is None else section(title, drawing)


def table(pairs):
    return table_of([map(escaped, pair) for pair in pairs])


def table_section(results):
    left = table(words.run_table(results)) if results.summary else \
        note("No summary yet.")
    chosen = [(path.split("/")[-1], value)
              for path, value in results.parameters.items() if value != ""
              and path.split("/")[0] in ("Model", "Material", "Boundary conditions")
              and path.count("/") == 1]
    right = table(chosen) if chosen else note("There is no parameters.prm.")
    text = "<div class=\"tables\"><div><h3>Result</h3>%s</div>" \
        "<div><h3>Model and material</h3>%s</div></div>" % (left, right)
    if results.parameters:
        groups = safe.grouped((path.rpartition("/") + (value,) for path, value
                               in results.parameters.items()), lambda parts: parts[0])
        text += "<details><summary>All parameters</summary><div>%s</div></details>" \
            % "".join("<section><h3>%s</h3>%s</section>"
                      % (escaped(group or "General"), table(row[2:] for row in rows))
                      for group, rows in groups.items())
    return section("The run", text, "long")


def section(title, content, kind=""):
    return element("section", element("h2", escaped(title)) + content, kind) + "\n"


def foot(results):
    program = " ".join(str(results.summary[name]) for name in
                       ("program", "version", "revision") if results.summary.get(name))
    return footer(program or "mixed-cracks", results.directory, "%H:%M")


def footer(program, directory, clock):
    return "<footer>%s. Page made on %s from %s.</footer>" % (
        escaped(program), datetime.datetime.now().strftime("%d %B %Y, " + clock),
        escaped(os.path.abspath(directory)))
