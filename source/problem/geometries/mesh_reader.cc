// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>
#include <problem/geometries/mesh_reader.h>
#include <problem/geometries/mesh_scan.h>

#include <deal.II/grid/grid_in.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // Returns why the file cannot be read; empty when it worked.
    std::string
    read_file(const std::string &path, std::string &text)
    {
      std::error_code no_error;
      if (std::filesystem::is_directory(path, no_error))
        return "it is a directory";
      errno = 0;
      std::ifstream file(path, std::ios::binary);
      if (!file)
        return std::strerror(errno);
      text.assign(std::istreambuf_iterator<char>(file), {});
      return file.bad() ? "reading it failed" : "";
    }



    // What deal.II's exceptions about meshes mean, in words
    std::string
    explanation(const std::string &exception)
    {
      const auto is_about = [&exception](const char *word) {
        return exception.find(word) != std::string::npos;
      };
      if (is_about("InvalidVertexIndex"))
        return "has cells with nodes that it does not list";
      if (is_about("InteriorLine"))
        return "gives a boundary id to a line inside the domain";
      if (is_about("internal face")) // a message, not a name
        return "gives a boundary id to a line or face inside the domain";
      if (is_about("Degenerate") || is_about("Distorted") ||
          is_about("NegativeMeasure"))
        return "has degenerate or twisted cells";
      return "has inconsistent contents (missing nodes, degenerate cells, "
             "lines that are no edge of a cell, or broken numbers)";
    }



    template <int dim>
    bool
    has_degenerate_cells(const dealii::Triangulation<dim> &triangulation)
    {
      constexpr unsigned int n = dealii::GeometryInfo<dim>::vertices_per_cell;
      for (const auto &cell : triangulation.active_cell_iterators())
      {
        dealii::Point<dim>     corners[n];
        dealii::Tensor<0, dim> jacobians[n];
        for (unsigned int v = 0; v < n; ++v)
          corners[v] = cell->vertex(v);
        dealii::GeometryInfo<dim>::alternating_form_at_vertices(corners,
                                                                jacobians);
        for (const double jacobian : jacobians)
          if (!(jacobian > 1e-9 * std::pow(cell->diameter(), dim)))
            return true;
      }
      return false;
    }



    // The Abaqus reader prints its exceptions instead of passing them on.
    class SilentErrorStream
    {
    public:
      SilentErrorStream()
        : original(std::cerr.rdbuf(swallowed.rdbuf()))
      {}

      SilentErrorStream(const SilentErrorStream &) = delete;

      ~SilentErrorStream()
      {
        std::cerr.rdbuf(original);
      }

    private:
      std::ostringstream swallowed;
      std::streambuf    *original;
    };
  } // namespace



  std::string
  read_file_once(const std::string &path,
                 const MPI_Comm     communicator,
                 const std::string &parameter)
  {
    std::string text, reason;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      reason = read_file(path, text);
    reason = dealii::Utilities::MPI::broadcast(communicator, reason);
    if (!reason.empty())
      throw FileError(parameter + ": cannot read '" + path + "': " + reason +
                      ".");
    return dealii::Utilities::MPI::broadcast(communicator, text);
  }



  template <int dim>
  std::string
  read_mesh(const std::string &text, dealii::Triangulation<dim> &triangulation)
  {
    const MeshScan scan = scan_mesh(text, dim);
    if (!scan.problem.empty())
      return scan.problem;

    dealii::GridIn<dim>     reader(triangulation);
    std::istringstream      in(text);
    const SilentErrorStream silence;
    try
    {
      switch (scan.format)
      {
        case MeshScan::gmsh:
          reader.read_msh(in);
          break;
        case MeshScan::abaqus:
          reader.read_abaqus(in);
          break;
        default:
          reader.read_ucd(in);
      }
    }
    catch (const dealii::ExceptionBase &error)
    {
      return explanation(error.get_exc_name());
    }
    catch (const std::exception &)
    {
      return explanation("");
    }
    if (triangulation.n_cells() == 0)
      return explanation("");
    return has_degenerate_cells(triangulation) ? explanation("Degenerate") : "";
  }



  template std::string read_mesh(const std::string &,
                                 dealii::Triangulation<2> &);
  template std::string read_mesh(const std::string &,
                                 dealii::Triangulation<3> &);
} // namespace MixedCracks
