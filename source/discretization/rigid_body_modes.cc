// SPDX-License-Identifier: GPL-2.0-or-later
// What costs no elastic energy: the kernel of eps, u = c + W x with W
// antisymmetric. In units of the body, with y = (x - middle)/size,
//
//   translations  u = e_d                        dim modes
//   rotations     u = e_b y_a - e_a y_b, a < b   1 in the plane, 3 in space
//
// of entries up to 1, so that the coarse functions of multigrid are of one
// size. They hold for linear and quadratic displacements alike, as they are
// linear in x.

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe.h>

#include <discretization/rigid_body_modes.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // one chosen displacement dof
    template <int dim>
    struct Place
    {
      Point<dim>   position;
      unsigned int component = invalid; // of the displacement

      static constexpr unsigned int invalid = -1;
    };



    // in the order of the owned dofs
    template <int dim>
    std::vector<Place<dim>>
    places_of(const Fields<dim> &fields, const std::vector<bool> &chosen)
    {
      const IndexSet           &owned = fields.elastic_dofs.owned;
      const FiniteElement<dim> &fe    = fields.elastic.get_fe();
      std::vector<unsigned int> numbers; // among the chosen ones
      unsigned int              n_chosen = 0;
      for (const bool is_chosen : chosen)
      {
        numbers.push_back(n_chosen);
        n_chosen += is_chosen;
      }
      std::vector<Place<dim>>              places(n_chosen);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      // owned dofs may stand on cells of other ranks only for those, which
      // are ghosts here
      for (const auto &cell : fields.elastic.active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          if (!owned.is_element(dofs[i]))
            continue;
          const auto at = owned.index_within_set(dofs[i]);
          if (!chosen[at])
            continue;
          Place<dim> &place = places[numbers[at]];
          if (place.component != Place<dim>::invalid)
            continue;
          place.component = fe.system_to_component_index(i).first;
          place.position  = fields.mapping.transform_unit_to_real_cell(
            cell, fe.unit_support_point(i));
        }
      }
      return places;
    }



    // middle and half the largest extent of the box around all places
    template <int dim>
    std::pair<Point<dim>, double>
    middle_and_size(const std::vector<Place<dim>> &places,
                    const MPI_Comm                 communicator)
    {
      std::vector<double> largest(2 * dim,
                                  std::numeric_limits<double>::lowest());
      for (const Place<dim> &place : places)
        for (unsigned int d = 0; d < dim; ++d)
        {
          largest[d]       = std::max(largest[d], place.position[d]);
          largest[dim + d] = std::max(largest[dim + d], -place.position[d]);
        }
      Utilities::MPI::max(largest, communicator, largest);
      Point<dim> middle;
      double     size = 0.;
      for (unsigned int d = 0; d < dim; ++d)
      {
        middle[d] = 0.5 * (largest[d] - largest[dim + d]);
        size      = std::max(size, 0.5 * (largest[d] + largest[dim + d]));
      }
      return {middle, size};
    }
  } // namespace



  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const Fields<dim> &fields, const std::vector<bool> &chosen)
  {
    const auto places         = places_of(fields, chosen);
    const auto [middle, size] = middle_and_size(places, fields.communicator());
    constexpr unsigned int           n_rotations = dim * (dim - 1) / 2;
    std::vector<std::vector<double>> modes(dim + n_rotations);
    for (const Place<dim> &place : places)
    {
      const Tensor<1, dim> arm = (place.position - middle) / size;
      for (unsigned int d = 0; d < dim; ++d)
        modes[d].push_back(place.component == d ? 1. : 0.);
      // in the plane of two axes each
      unsigned int mode = dim;
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = a + 1; b < dim; ++b, ++mode)
          modes[mode].push_back(place.component == a   ? -arm[b]
                                : place.component == b ? arm[a]
                                                       : 0.);
    }
    return modes;
  }



  template std::vector<std::vector<double>>
  rigid_body_modes(const Fields<2> &, const std::vector<bool> &);
  template std::vector<std::vector<double>>
  rigid_body_modes(const Fields<3> &, const std::vector<bool> &);
} // namespace MixedCracks
