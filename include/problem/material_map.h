// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_material_map_h
#define mixed_cracks_problem_material_map_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <problem/grid_data.h>

#include <memory>
#include <string>

namespace MixedCracks
{
  /// Subsection "Material/Map": a picture or a table that expressions of the
  /// material know as the variable 'map'.
  struct MaterialMapParameters
  {
    std::string file_name;
    std::string lower_corner;
    std::string upper_corner;
    std::string interpolation = "nearest";

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    bool
    given() const
    {
      return !file_name.empty();
    }
  };

  /// Read the file on one rank. @p box: the extent of the mesh, which a
  /// picture covers unless corners are given; mm. Throws FileError or
  /// InputError on every rank alike. Collective.
  template <int dim>
  std::shared_ptr<const GridData>
  read_material_map(const MaterialMapParameters    &parameters,
                    const dealii::BoundingBox<dim> &box,
                    MPI_Comm                        communicator);
} // namespace MixedCracks

#endif
