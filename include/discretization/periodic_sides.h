// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_periodic_sides_h
#define mixed_cracks_discretization_periodic_sides_h

#include <deal.II/base/tensor.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <discretization/boundary_ids.h>

#include <array>
#include <bitset>
#include <functional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Two flat sides of the body that are the same but for a translation.
  struct PeriodicPair
  {
    std::array<BoundaryIds, 2> sides;
    std::array<std::string, 2> names; ///< what messages call them
  };

  /// What is periodic: u(second side) - u(first side) = E(t) L on each pair, L
  /// the vector from the first to the second, and all other fields are equal.
  template <int dim>
  struct Periodicity
  {
    std::vector<PeriodicPair> pairs;
    /// E(t), small strain, or the mean of the displacement gradient; empty: 0
    std::function<dealii::Tensor<2, dim>(double)> mean_strain{};

    dealii::Tensor<2, dim>
    strain_at(const double time) const
    {
      return mean_strain ? mean_strain(time) : dealii::Tensor<2, dim>();
    }
  };

  /// The faces of a coarse mesh that belong together, and the vectors between
  /// them. The same on every rank.
  template <int dim>
  class PeriodicSides
  {
  public:
    using Mesh    = dealii::Triangulation<dim>;
    using Handler = dealii::DoFHandler<dim>;

    PeriodicSides() = default;

    /// Throws InputError with the names of both sides where they are not flat,
    /// not opposite, or a face has no partner, and where the vectors are not
    /// independent.
    PeriodicSides(const Mesh &mesh, const std::vector<PeriodicPair> &pairs);

    /// The vector L of each pair, mm.
    const std::vector<dealii::Tensor<1, dim>> &
    periods() const
    {
      return period_of_pair;
    }

    /// Those of them that differ; at most dim.
    const std::vector<dealii::Tensor<1, dim>> &
    basis() const
    {
      return different;
    }

    /// How often each of basis() is in @p difference of two points, rounded.
    std::array<int, dim>
    count_periods(const dealii::Tensor<1, dim> &difference) const;

    /// For Triangulation::add_periodicity(), to be called before the mesh is
    /// refined.
    std::vector<
      dealii::GridTools::PeriodicFacePair<typename Mesh::cell_iterator>>
    faces(const Mesh &mesh) const;

    /// For DoFTools::make_periodicity_constraints(). The first sides have the
    /// independent dofs where the meshes are alike.
    std::vector<
      dealii::GridTools::PeriodicFacePair<typename Handler::cell_iterator>>
    faces(const Handler &handler) const;

    /// A face of a cell of the coarse mesh.
    struct Face
    {
      int          cell;
      unsigned int number;
    };

    struct Match
    {
      std::array<Face, 2> faces;
      std::bitset<3>      orientation;
      std::size_t         pair;
    };

    /// In the order of the pairs.
    const std::vector<Match> &
    matches() const
    {
      return matched;
    }

    /// mm^3, in 2-d mm^2: of the cell that is repeated, holes included; in
    /// directions without a period the extent of the body counts.
    double cell_volume(const Mesh &mesh) const;

  private:
    void match(const Mesh &mesh, const PeriodicPair &pair);

    std::vector<dealii::Tensor<1, dim>> period_of_pair;
    std::vector<dealii::Tensor<1, dim>> different;
    std::vector<Match>                  matched;
  };
} // namespace MixedCracks

#endif
