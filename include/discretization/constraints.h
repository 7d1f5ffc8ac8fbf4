// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_constraints_h
#define mixed_cracks_discretization_constraints_h

#include <deal.II/base/function.h>

#include <deal.II/lac/affine_constraints.h>

#include <discretization/boundary_ids.h>
#include <discretization/fields.h>
#include <discretization/periodic_constraints.h>
#include <discretization/vertex_dofs.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// One displacement component given on a part of the boundary.
  template <int dim>
  struct PrescribedComponent
  {
    /// stands for the component normal to a flat boundary, which the mesh tells
    static constexpr unsigned int normal =
      dealii::numbers::invalid_unsigned_int;

    BoundaryIds  boundary;
    unsigned int component;
    /// value in mm; has as many components as the elastic element, of which
    /// `component` is asked; its time is set before
    std::shared_ptr<dealii::Function<dim>> value;
    /// what messages call the boundary
    std::string name = {};
  };

  /// One displacement component given at a vertex.
  template <int dim>
  struct PrescribedPoint
  {
    dealii::Point<dim>                     point; ///< mm
    unsigned int                           component;
    std::shared_ptr<dealii::Function<dim>> value; ///< as above
    /// whether the value is ever another one than 0
    bool moves = true;
    /// the name of the set that it is of, if any. Those follow from the mesh:
    /// nothing is wrong when one is a hanging node, which follows its
    /// neighbours
    std::string set{};
  };

  /// Hanging nodes, prescribed displacements and periodic sides. Newton
  /// corrections vanish on the prescribed dofs and are equal on both sides of a
  /// pair; residuals are assembled with the hanging nodes only, so that their
  /// rows there are the nodal reactions, and what acts through a periodic side.
  template <int dim>
  class Constraints
  {
  public:
    Constraints(const Fields<dim>                    &fields,
                std::vector<PrescribedComponent<dim>> prescribed,
                std::vector<PrescribedPoint<dim>>     points      = {},
                Periodicity<dim>                      periodicity = {});

    /// Where the points depend on the mesh: what reinit() asks for them first.
    /// Has to give the same on all ranks; may be collective.
    void
    take_points_from(std::function<std::vector<PrescribedPoint<dim>>()> source)
    {
      source_of_points = std::move(source);
    }

    /// To be called when the mesh changed. Throws InputError on all ranks when
    /// a prescribed point is no vertex of the mesh, a plane of symmetry not
    /// flat, or a pair of periodic sides not alike.
    void reinit();

    /// The prescribed values at @p time written into @p elastic (without
    /// ghosts), and hanging nodes made to fit.
    /// Throws InputError on all ranks where conditions on both of two periodic
    /// sides contradict the mean strain.
    void apply_prescribed(double time, LinearAlgebra::Vector &elastic) const;

    /// Make hanging nodes and periodic sides of a state (without ghosts) fit,
    /// at the mean strain of @p time.
    void fit(double time, LinearAlgebra::Vector &elastic) const;

    /// Add (E(after) - E(before)) x to the displacements of @p elastic.
    void add_mean_strain(double                 before,
                         double                 after,
                         LinearAlgebra::Vector &elastic) const;

    /// Zero everything but the rows of prescribed dofs and of periodic sides
    /// (of a vector without ghosts): from a residual to the reaction.
    void keep_prescribed(LinearAlgebra::Vector &residual) const;

    /// Zero the rows of prescribed dofs, move those of dependent sides to what
    /// they depend on: from a residual to a right hand side.
    void drop_prescribed(LinearAlgebra::Vector &residual) const;

    /// What is left of a reaction where what acts through periodic sides is
    /// taken out, which adds up to 0 over images: that of supports.
    void drop_periodic(LinearAlgebra::Vector &reaction) const;

    /// Give a node of the phase field (without ghosts) that others depend on
    /// the smallest value that one of its images has.
    void spread_least(LinearAlgebra::Vector &phase_field) const;

    const dealii::AffineConstraints<double> &
    elastic_hanging_nodes() const
    {
      return elastic_hanging;
    }

    /// Hanging nodes and periodic sides, homogeneous.
    const dealii::AffineConstraints<double> &
    elastic_periodic() const
    {
      return periodic_sides.any() ? periodic_sides.homogeneous()
                                  : elastic_hanging;
    }

    const dealii::AffineConstraints<double> &
    elastic_corrections() const
    {
      return elastic_newton;
    }

    /// Those of the phase field, periodic sides included.
    const dealii::AffineConstraints<double> &
    phase_field_hanging_nodes() const
    {
      return phase_field_hanging;
    }

    const std::vector<PrescribedComponent<dim>> &
    prescribed_components() const
    {
      return prescribed;
    }

    const std::vector<PrescribedPoint<dim>> &
    prescribed_points() const
    {
      return points;
    }

    /// Their dofs, as far as this rank knows them.
    const std::vector<VertexDofs> &
    dofs_of_points() const
    {
      return point_dofs;
    }

    const PeriodicConstraints<dim> &
    periodic() const
    {
      return periodic_sides;
    }

    /// Of a body with periodic sides, the components of the displacement that
    /// nothing prescribes: these are held at the vertex held_vertex(), the last
    /// of prescribed_points().
    const std::vector<unsigned int> &
    held_components() const
    {
      return held;
    }

    dealii::Point<dim>
    held_vertex() const
    {
      return vertex_held;
    }

  private:
    std::vector<bool> mask_of(const PrescribedComponent<dim> &entry) const;

    /// Add what is held because nothing else holds it to `points`.
    void hold_translations();

    /// What is prescribed at a node is prescribed at its image.
    void prescribe_images();

    /// The same for values, checked.
    void add_values_of_images(
      double                                             time,
      std::map<dealii::types::global_dof_index, double> &values) const;

    /// Find the components of planes of symmetry.
    void resolve_symmetry();

    /// The dofs of `points` that this rank knows, in their order. Collective.
    std::vector<VertexDofs> find_points() const;

    const Fields<dim>                                 &fields;
    std::vector<PrescribedComponent<dim>>              prescribed;
    std::vector<PrescribedPoint<dim>>                  points;
    std::function<std::vector<PrescribedPoint<dim>>()> source_of_points;
    std::vector<VertexDofs>                            point_dofs;
    PeriodicConstraints<dim>                           periodic_sides;
    std::vector<unsigned int>                          held;
    dealii::Point<dim>                                 vertex_held;

    dealii::AffineConstraints<double> elastic_hanging;
    dealii::AffineConstraints<double> elastic_newton;
    dealii::AffineConstraints<double> phase_field_hanging;
    dealii::IndexSet                  prescribed_dofs; // owned
  };
} // namespace MixedCracks

#endif
