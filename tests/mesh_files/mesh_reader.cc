// SPDX-License-Identifier: GPL-2.0-or-later
// Reads mesh files as the program does, many in one process, for
// test_mesh_files.py. A line of the input is
//
//   dimension TAB whether simplices are cut TAB boundary names TAB file
//
// and its answer a line "STATUS TAB TEXT": 0 and the number of cells, or the
// exit status of the program and its message.
#include <base/errors.h>
#include <base/text.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <deal.II/grid/tria.h>

#include <problem/geometry.h>

#include <algorithm>
#include <iostream>

namespace
{
  using namespace MixedCracks;

  template <int dim>
  std::string
  cells_of(const std::vector<std::string> &words)
  {
    const auto               geometry = all_geometries<dim>().make("mesh file");
    dealii::ParameterHandler prm;
    geometry->add_parameters(prm);
    prm.set("Cut simplices", words.at(1));
    prm.set("Boundary names", words.at(2));
    prm.set("File name", words.at(3));
    geometry->check();
    dealii::Triangulation<dim> mesh;
    geometry->create(mesh);
    return "0\tmesh of the file: " + std::to_string(mesh.n_active_cells()) +
           " cells";
  }

  std::string
  answer(const std::vector<std::string> &words)
  {
    try
    {
      return words.at(0) == "3" ? cells_of<3>(words) : cells_of<2>(words);
    }
    catch (const InputError &error)
    {
      return std::string("2\tmixed-cracks: error: ") + error.what();
    }
    catch (const FileError &error)
    {
      return std::string("4\tmixed-cracks: error: ") + error.what();
    }
    catch (const std::exception &error)
    {
      return std::string("1\t") + error.what();
    }
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (std::string line; std::getline(std::cin, line);)
  {
    std::string text = answer(dealii::Utilities::split_string_list(line, '\t'));
    std::replace(text.begin(), text.end(), '\n', '\v'); // still one line
    std::cout << text << std::endl;
  }
}
