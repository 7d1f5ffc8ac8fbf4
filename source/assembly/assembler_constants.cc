// SPDX-License-Identifier: GPL-2.0-or-later
#include <assembly/assembler.h>

namespace MixedCracks
{
  template <int dim>
  void
  Assembler<dim>::lumped_toughness(const Constraints &constraints,
                                   Vector            &toughness)
  {
    cells->phase_field.begin_sum(toughness);
    dealii::Vector<double> local(local_phase_field.size());
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      phase_field_kernel.reinit(cells->geometry(cell), (*constants)[cell]);
      phase_field_kernel.lumped_toughness(local);
      cells->phase_field.add(cell, local, constraints, toughness);
    }
    cells->phase_field.end_sum(toughness);
  }



  template <int dim>
  void
  Assembler<dim>::add_constants(const unsigned int cell,
                                const unsigned int index,
                                CellData<dim>     &data) const
  {
    const CellGeometry<dim> &geometry = cells->geometry(cell);
    const CellConstants      at       = (*constants)[cell];
    PointConstants           sum{0., 0., 0.};
    for (unsigned int q = 0; q < geometry.weights.size(); ++q)
    {
      sum.lambda += at[q].lambda * geometry.weights[q];
      sum.mu += at[q].mu * geometry.weights[q];
      sum.critical_energy_release_rate +=
        at[q].critical_energy_release_rate * geometry.weights[q];
    }
    const double       volume = geometry.volume();
    const unsigned int n = fields.elastic.get_triangulation().n_active_cells();
    data.set("lame_lambda", n, index, sum.lambda / volume);
    data.set("shear_modulus", n, index, sum.mu / volume);
    data.set("critical_energy_release_rate",
             n,
             index,
             sum.critical_energy_release_rate / volume);
  }



  template void Assembler<2>::lumped_toughness(const Constraints &, Vector &);
  template void Assembler<3>::lumped_toughness(const Constraints &, Vector &);
  template void
  Assembler<2>::add_constants(unsigned int, unsigned int, CellData<2> &) const;
  template void
  Assembler<3>::add_constants(unsigned int, unsigned int, CellData<3> &) const;
} // namespace MixedCracks
