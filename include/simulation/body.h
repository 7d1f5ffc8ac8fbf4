// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_body_h
#define mixed_cracks_simulation_body_h

#include <deal.II/distributed/tria.h>

#include <discretization/constraints.h>
#include <discretization/fields.h>
#include <discretization/mesh_estimate.h>

#include <output/checkpoint.h>

#include <simulation/parameters.h>
#include <simulation/simulation_material.h>

#include <memory>
#include <optional>

namespace MixedCracks
{
  /// The body on its mesh: what is set up once per mesh, and what it is made
  /// of. First one of the functions that make a mesh is called; after a change
  /// of the mesh fields and constraints are those of refine_and_transfer().
  /// Collective.
  template <int dim>
  class Body
  {
  public:
    Body(const Parameters<dim> &parameters, MPI_Comm communicator);

    /// As the .prm says. Throws InputError for a body that is not held, and for
    /// what else only a mesh can tell.
    void make();

    /// The same for `--check`: a mesh that is large is counted and not built.
    void make_to_check();

    /// The mesh of a checkpoint. @p first_cell_size: of record.
    void restore(const Checkpoint<dim> &checkpoint, double first_cell_size);

    /// Of the mesh as it is, or would be.
    MeshEstimate counts() const;

    /// The size of cells that adaptation has refined as far as it may, mm.
    double cell_size_at_cracks() const;

    /// l, mm.
    double
    length_scale() const
    {
      return material->description().length_scale;
    }

    /// mm^2, 3-d mm^3.
    double volume() const;

    MPI_Comm
    communicator() const
    {
      return fields.communicator();
    }

    const Parameters<dim> &parameters;

    dealii::parallel::distributed::Triangulation<dim> triangulation;
    double      cell_size = 0.; ///< h of expressions: of the first mesh, mm
    Fields<dim> fields;
    Constraints<dim> constraints;

    std::unique_ptr<const Material<dim>>      material;
    std::unique_ptr<const MaterialField<dim>> material_field;
    MaterialRange                             material_range{};

    /// the first mesh, when `--check` has not built it
    std::optional<MeshEstimate> not_built;

  private:
    /// All that lives on the mesh.
    void set_up();
  };
} // namespace MixedCracks

#endif
