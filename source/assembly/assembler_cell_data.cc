// SPDX-License-Identifier: GPL-2.0-or-later
// Averages over the cells for the output, (sum_q w_q a_q)/V: stresses (MPa;
// those of Cauchy at finite strain), energy density (MPa), at finite strain the
// largest principal stretch and J, and the constants of the material where they
// vary.

#include <assembly/assembler.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  void
  Assembler<dim>::add_averages(
    const typename ElasticKernel<dim>::CellAverages &averages,
    const unsigned int                               index,
    CellData<dim>                                   &data) const
  {
    const std::string  axes = "xyz";
    const unsigned int n = fields.elastic.get_triangulation().n_active_cells();
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        data.set(std::string("stress_") + axes[i] + axes[j],
                 n,
                 index,
                 averages.stress[i][j]);
    data.set("strain_energy_density", n, index, averages.energy_density);
    if (!is_finite())
      return;
    data.set("largest_stretch", n, index, averages.largest_stretch);
    data.set("volume_ratio", n, index, averages.volume_ratio);
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



  template <int dim>
  CellData<dim>
  Assembler<dim>::cell_data(const Vector &elastic,
                            const Vector &lagged_phase_field,
                            const Vector &phase_field)
  {
    const unsigned int n_cells =
      fields.elastic.get_triangulation().n_active_cells();
    CellData<dim> data;
    for (unsigned int cell = 0; cell < cells->n_cells(); ++cell)
    {
      load_elastic(
        cell, elastic, lagged_phase_field, ElasticEvaluation::stresses);
      cells->phase_field.read(cell, phase_field, local_phase_field);
      phase_field_kernel.interpolate(local_phase_field, phase_field_values);
      const auto         averages = elastic_kernel.averages(phase_field_values);
      const unsigned int index    = cells->active_index(cell);
      add_averages(averages, index, data);
      data.set("material", n_cells, index, cells->material(cell));
      if (constants_vary())
        add_constants(cell, index, data);
    }
    return data;
  }



#define INSTANTIATE(dim)                                                     \
  template void Assembler<dim>::add_averages(                                \
    const ElasticKernel<dim>::CellAverages &, unsigned int, CellData<dim> &) \
    const;                                                                   \
  template void Assembler<dim>::add_constants(                               \
    unsigned int, unsigned int, CellData<dim> &) const;                      \
  template CellData<dim> Assembler<dim>::cell_data(                          \
    const Vector &, const Vector &, const Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
