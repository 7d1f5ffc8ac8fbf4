// SPDX-License-Identifier: GPL-2.0-or-later
// Periodic sides of the .prm: on the coarse mesh, before it is refined or a
// checkpoint is loaded, so that p4est keeps both sides within one level and
// gives each rank the cells on the other side as ghosts.

#include <simulation/simulation_setup.h>

#include <memory>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  Periodicity<dim>
  periodicity(const Parameters<dim> &parameters)
  {
    Periodicity<dim> result;
    result.pairs      = parameters.geometry.periodic_pairs();
    const auto strain = std::make_shared<const MeanStrain<dim>>(
      parameters.boundary_conditions.mean_strain(
        parameters.model.strain.is_finite()));
    result.mean_strain = [strain](const double time) {
      return strain->at(time);
    };
    return result;
  }



  template <int dim>
  void
  make_periodic(const Parameters<dim> &parameters,
                Triangulation<dim>    &triangulation)
  {
    const auto pairs = parameters.geometry.periodic_pairs();
    if (pairs.empty())
      return;
    const PeriodicSides<dim> sides(triangulation, pairs);
    parameters.boundary_conditions
      .mean_strain(parameters.model.strain.is_finite())
      .require_effect(sides.periods());
    triangulation.add_periodicity(sides.faces(triangulation));
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  shifts_to_images(const Parameters<dim>    &parameters,
                   const Triangulation<dim> &triangulation)
  {
    std::vector<Tensor<1, dim>> shifts(1);
    const PeriodicSides<dim>    sides(triangulation,
                                   parameters.geometry.periodic_pairs());
    for (const Tensor<1, dim> &period : sides.basis())
      for (std::size_t i = 0, n = shifts.size(); i < n; ++i)
        for (const double sign : {1., -1.})
          shifts.push_back(shifts[i] + sign * period);
    return shifts;
  }



#define INSTANTIATE(dim)                                                      \
  template Periodicity<dim> periodicity(const Parameters<dim> &);             \
  template void make_periodic(const Parameters<dim> &, Triangulation<dim> &); \
  template std::vector<Tensor<1, dim>> shifts_to_images(                      \
    const Parameters<dim> &, const Triangulation<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
