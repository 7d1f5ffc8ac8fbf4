// SPDX-License-Identifier: GPL-2.0-or-later
// What the tests of mesh files share.
#ifndef mixed_cracks_tests_mesh_files_h
#define mixed_cracks_tests_mesh_files_h

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>

#include "geometries.h"

namespace GeometryTests
{
  struct FileEntries
  {
    std::string file_name;
    std::string boundary_names;
    std::string circles;
  };

  template <int dim = 2>
  std::unique_ptr<Geometry<dim>>
  mesh_file(const FileEntries &entries)
  {
    auto                     geometry = all_geometries<dim>().make("mesh file");
    dealii::ParameterHandler prm;
    geometry->add_parameters(prm);
    prm.set("File name", entries.file_name);
    prm.set("Boundary names", entries.boundary_names);
    prm.set("Circles", entries.circles);
    return geometry;
  }

  // the directory meshes/ of the source tree, two above this one
  const std::string meshes = std::filesystem::path(__FILE__)
                               .parent_path()
                               .parent_path()
                               .parent_path()
                               .string() +
                             "/meshes";

  const FileEntries plate = {
    meshes + "/plate_with_hole.msh",
    "1 = bottom ; 2 = right ; 3 = top ; 4 = left ; 5 = hole",
    "hole : 10, 10 : 4"};

  const FileEntries beam = {
    meshes + "/notched_beam.inp",
    "1 = left ; 2 = right ; 3 = bottom ; 4 = top ; 5 = notch",
    ""};

  // One path per rank, so that ranks do not overwrite each other's file; the
  // first rank's is the one that is read.
  inline std::string
  written(const std::string &text)
  {
    const std::string path =
      ::testing::TempDir() + "mixed_cracks_mesh_" +
      std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
      ".inp";
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
} // namespace GeometryTests

#endif
