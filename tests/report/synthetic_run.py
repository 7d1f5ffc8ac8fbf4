# SPDX-License-Identifier: GPL-2.0-or-later
"""A made-up run in the formats of doc/output.md; Python's own library only."""
import base64
import json
import os
import struct
import zlib

COLUMNS = ("step,time_s,displacement_mm,force_x_N,force_y_N,elastic_energy_mJ,"
           "crack_energy_mJ,external_work_mJ,min_phase_field,"
           "max_phase_field_change,newton_iterations,linear_iterations,"
           "active_set_size,cells,dofs,wall_time_s,coupling_iterations")

PARAMETERS = """# a comment
subsection Geometry
  set Name = punctured strip
  subsection Punctured strip
    set Width        = 20
    set Height       = 28
    set Hole center  = 12, 18
    set Hole radius  = 4     # mm
    set Notch height = 12
    set Notch length = 1
  end
end
subsection Model
  set Formulation = mixed
  set Kinematics  = plane stress
  set Coupling    = %s
end
subsection Load stepping
  set Stop when force falls below = 0.15
end
"""


def write(path, text):
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def write_statistics(directory):
    """A linear rise to 160 N at 20 mm, then a fall to 10 N at 22 mm."""
    rows, work, before = [COLUMNS], 0., (0., 0.)
    for step in range(12):
        displacement = 2. * step
        broken = 1. if displacement > 20. else 0.
        force = 8. * displacement * (1. - broken) + 10. * broken
        work += 0.5 * (force + before[0]) * (displacement - before[1])
        before = (force, displacement)
        rows.append(",".join("%.10g" % value for value in (
            step, 0.3 * displacement, displacement, 0.1, force,
            0.5 * force * displacement, 34. + 700. * broken, work, 0., broken, 2,
            0, 7, 4, 50, 1.5 * step, 3)))
    write(os.path.join(directory, "statistics.csv"), "\n".join(rows) + "\n")


def write_summary(directory, **changes):
    summary = dict(program="mixed-cracks", version="0.1.0", ranks=2, cells=4,
                   dofs=50, steps=12, peak_force_N=160., separated=True, force_fell=True,
                   remaining_force_fraction=0.0625, exit_status=0,
                   outcome="through hole", exit_reason="force fell", wall_time_s=17.)
    summary.update(changes)
    write(os.path.join(directory, "summary.json"), json.dumps(summary))


PATH_COLUMNS = ("step,time_s,displacement_mm,crack,length_mm,kink_angle_deg,start,"
                "end,tip_x_mm,tip_y_mm,point,x_mm,y_mm,arc_length_mm")

SHEETS = """step,time_s,displacement_mm,crack,area_mm2,front_length_mm,start,joins,x_mm,\
y_mm,z_mm,normal_x,normal_y,normal_z,mean_tip_speed_mm_per_s,\
largest_tip_speed_mm_per_s,mean_opening_angle_deg
3,3,0.1,0,0.5,1.4,slit,slit to tip,0,0,0,0,1,0,0.5,0.7,3
7,7,0.2,0,0.75,1.5,slit,slit to back to tip,0,0,0,-1e-11,0.999,0,0.5,,4
# outcome: arrested; start: slit; joins: slit to back to tip
"""


def write_crack_path(directory, closed=True):
    """At step 10 one short crack; at step 11 it has run through, and another
    one has grown from within, whose kink angle is none."""
    rows = [PATH_COLUMNS]

    def crack(step, number, angle, start, end, points):
        length = points[-1][0] - points[0][0]
        for k, (x, y) in enumerate(points):
            rows.append("%d,%g,%g,%d,%g,%s,%s,%s,%g,%g,%d,%g,%g,%g" % (
                (step, 0.6 * step, 2. * step, number, length, angle, start, end)
                + points[-1] + (k, x, y, x - points[0][0])))

    crack(10, 0, "12.5", "notch", "", [(0., 1.), (0.375, 1.)])
    crack(11, 0, "12.5", "notch", "right", [(0., 1.), (1., 1.), (2., 1.)])
    crack(11, 1, "nan", "interior", "top", [(0.5, 1.5), (0.75, 2.)])
    if closed:
        rows.append("# outcome: through hole; start: notch")
    write(os.path.join(directory, "crack_path.csv"), "\n".join(rows) + "\n")


def encoded(code, values, compressed):
    raw = struct.pack("<%d%s" % (len(values), code), *values)
    if not compressed:
        return base64.b64encode(struct.pack("<I", len(raw)) + raw).decode()
    packed = zlib.compress(raw)
    header = struct.pack("<4I", 1, len(raw), len(raw), len(packed))
    return (base64.b64encode(header) + base64.b64encode(packed)).decode()


def vtu(left, phase_field, compressed):
    """Two unit squares above each other, points doubled as deal.II does."""
    points, cells, n_cells = [], [], 2
    for cell in range(n_cells):
        for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
            points += [left + x, cell + y, 0.]
        cells += range(4 * cell, 4 * cell + 4)
    n = 4 * n_cells

    def array(kind, code, name, values, components=1):
        return ('<DataArray type="%s" Name="%s" NumberOfComponents="%d" '
                'format="binary">\n%s\n</DataArray>\n'
                % (kind, name, components, encoded(code, values, compressed)))

    return ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="0.1" %s'
            'byte_order="LittleEndian"><UnstructuredGrid>'
            '<Piece NumberOfPoints="%d" NumberOfCells="%d">\n'
            % ('compressor="vtkZLibDataCompressor" ' if compressed else "", n, n_cells)
            + "<Points>" + array("Float32", "f", "points", points, 3) + "</Points>"
            + "<Cells>" + array("Int32", "i", "connectivity", cells)
            + array("Int32", "i", "offsets", [4, 8])
            + array("UInt8", "B", "types", [9, 9]) + "</Cells>"
            + "<PointData>" + array("Float32", "f", "displacement",
                                    [0., 0.1, 0.] * n, 3)
            + array("Float64", "d", "phase_field", [phase_field] * n)
            + "</PointData></Piece></UnstructuredGrid></VTKFile>\n")


def write_fields(directory, compressed=True):
    """Fields of two ranks before, at and after the peak."""
    os.mkdir(os.path.join(directory, "fields"))
    sets = []
    for number, (time, phase_field) in enumerate(((3., 1.), (6., 0.9), (6.6, 0.))):
        pieces = []
        for rank in range(2):
            pieces.append("step_%d.%d.vtu" % (number, rank))
            write(os.path.join(directory, "fields", pieces[-1]),
                  vtu(rank, phase_field, compressed))
        write(os.path.join(directory, "fields", "step_%d.pvtu" % number),
              '<?xml version="1.0"?>\n<VTKFile type="PUnstructuredGrid">'
              "<PUnstructuredGrid>%s</PUnstructuredGrid></VTKFile>\n"
              % "".join('<Piece Source="%s"/>' % piece for piece in pieces))
        sets.append('<DataSet timestep="%g" group="" part="0" '
                    'file="fields/step_%d.pvtu"/>' % (time, number))
    write(os.path.join(directory, "fields.pvd"),
          '<?xml version="1.0"?>\n<VTKFile type="Collection"><Collection>\n'
          + "\n".join(sets) + "\n</Collection></VTKFile>\n")


def write_run(directory, coupling="iterated"):
    write_statistics(directory)
    write_summary(directory)
    write(os.path.join(directory, "parameters.prm"), PARAMETERS % coupling)
    write_fields(directory)
    write_crack_path(directory)
