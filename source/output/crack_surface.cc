// SPDX-License-Identifier: GPL-2.0-or-later
// The surface phi = 1/2 by marching cubes (Lorensen and Cline, Computer
// Graphics 21 (1987)), cell by cell, as triangles with three points of their
// own. It lies to both sides of the crack at the distance where its profile is
// 1/2: 0.52 l (Wu), 0.59 l (AT1), 0.69 l (AT2). At hanging nodes the surfaces
// of the cells need not meet.

#include <base/collective.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <output/crack_surface.h>
#include <output/disk.h>
#include <output/run_files.h>

#include <fstream>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    void
    write_triangles(std::ostream &out, const Triangles &triangles)
    {
      const std::size_t n     = triangles.size() / 3;
      const auto        array = [&out](const std::string &type_and_name) {
        out << "<DataArray type=" << type_and_name << " format=\"ascii\">\n";
      };
      out.precision(8);
      out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" "
             "version=\"0.1\">\n<PolyData>\n<Piece NumberOfPoints=\""
          << 3 * n << "\" NumberOfPolys=\"" << n << "\">\n<Points>\n";
      array("\"Float64\" NumberOfComponents=\"3\"");
      for (const Point<3> &corner : triangles)
        out << corner << '\n';
      out << "</DataArray>\n</Points>\n<Polys>\n";
      array("\"Int64\" Name=\"connectivity\"");
      for (std::size_t i = 0; i < 3 * n; ++i)
        out << i << (i % 3 == 2 ? '\n' : ' ');
      out << "</DataArray>\n";
      array("\"Int64\" Name=\"offsets\"");
      for (std::size_t i = 1; i <= n; ++i)
        out << 3 * i << '\n';
      out << "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    }
  } // namespace



  Triangles
  crack_surface(const Fields<3>             &fields,
                const LinearAlgebra::Vector &phase_field,
                const double                 level)
  {
    const GridTools::MarchingCubeAlgorithm<3, LinearAlgebra::Vector> cut(
      fields.mapping, fields.phase_field.get_fe());
    std::vector<Point<3>>            corners;
    std::vector<dealii::CellData<2>> faces;
    cut.process(fields.phase_field, phase_field, level, corners, faces);
    Triangles own;
    for (const dealii::CellData<2> &face : faces)
      for (const unsigned int corner : face.vertices)
        own.push_back(corners[corner]);

    Triangles all;
    for (const Triangles &part :
         Utilities::MPI::gather(fields.communicator(), own))
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }



  void
  write_crack_surface(
    const Fields<3>                                   &fields,
    const LinearAlgebra::Vector                       &phase_field,
    const std::string                                 &directory,
    const std::string                                 &file_name,
    const std::vector<std::pair<double, std::string>> &times_and_names)
  {
    const Triangles triangles = crack_surface(fields, phase_field);
    bool            written   = true;
    if (Utilities::MPI::this_mpi_process(fields.communicator()) == 0)
      try
      {
        const bool    noted = note_run_files(directory, {file_name});
        std::ofstream file(directory + "/" + file_name);
        write_triangles(file, triangles);
        std::ostringstream list;
        DataOutBase::write_pvd_record(list, times_and_names);
        // the old list stays until the new one is whole
        written =
          noted && file.flush() &&
          write_durably(directory + "/crack_surface.pvd", list.str()).empty();
      }
      catch (const std::exception &) // deal.II's, of a list without a file
      {
        written = false;
      }
    throw_on_all_ranks(written ? ""
                               : "Output/Directory: the surface of the crack "
                                 "cannot be written in '" +
                                   directory + "'; is the disk full?",
                       fields.communicator());
  }
} // namespace MixedCracks
