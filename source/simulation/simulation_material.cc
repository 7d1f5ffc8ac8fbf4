// SPDX-License-Identifier: GPL-2.0-or-later
// The material of the .prm on a mesh: the map, whose default corners are those
// of the body; constants at the quadrature points where they vary; and their
// ranges over all of these points and ranks, for warnings and choices.

#include <assembly/constants_table.h>

#include <base/log.h>

#include <simulation/simulation_load_size.h>
#include <simulation/simulation_material.h>

#include <limits>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    void
    widen(Range &range, const double value)
    {
      range.smallest = std::min(range.smallest, value);
      range.largest  = std::max(range.largest, value);
    }

    std::string
    range_in_words(const Range &range)
    {
      return !range.varies()
               ? format("%.4g", range.smallest)
               : format("%.4g to %.4g", range.smallest, range.largest);
    }
  } // namespace



  template <int dim>
  MaterialField<dim>
  make_material_field(const MaterialParameters &parameters,
                      const Triangulation<dim> &triangulation)
  {
    // every rank has all cells of the coarse mesh
    std::set<types::material_id> ids;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      ids.insert(cell->material_id());
    std::shared_ptr<const GridData> map;
    if (parameters.map.given())
      map = read_material_map<dim>(parameters.map,
                                   coarse_extent(triangulation),
                                   triangulation.get_communicator());
    MaterialField<dim> field(parameters, map);
    field.check_ids(ids);
    return field;
  }



  template <int dim>
  ConstantsFunction<dim>
  constants_function(const ModelParameters    &model,
                     const MaterialField<dim> &field)
  {
    if (!field.varies())
      return {};
    return
      [model, field](const Point<dim> &point, const types::material_id id) {
        return model.at_point(field(point, id), dim);
      };
  }



  template <int dim>
  MaterialRange
  material_range(const MaterialField<dim> &field, const Fields<dim> &fields)
  {
    const double  huge = std::numeric_limits<double>::max();
    const Range   none{huge, -huge};
    MaterialRange range{none, none, none, none, none};
    const auto    add = [&](const MaterialValues &values) {
      const ElasticConstants &elastic = values.elastic;
      widen(range.lambda, elastic.lambda);
      widen(range.mu, elastic.mu);
      widen(range.ratio, elastic.lambda / elastic.mu);
      widen(range.nu, elastic.poisson_ratio());
      widen(range.critical_energy_release_rate,
            values.critical_energy_release_rate);
    };
    if (field.varies())
      for_each_quadrature_point<dim>(
        fields, [&](const Point<dim> &point, const types::material_id id) {
          add(field(point, id));
        });
    else
      add(field(Point<dim>(), 0));
    for (Range *each : {&range.lambda,
                        &range.mu,
                        &range.ratio,
                        &range.nu,
                        &range.critical_energy_release_rate})
    {
      each->smallest =
        Utilities::MPI::min(each->smallest, fields.communicator());
      each->largest = Utilities::MPI::max(each->largest, fields.communicator());
    }
    return range;
  }



  std::string
  in_words(const MaterialRange &range)
  {
    return "material varies: lambda = " + range_in_words(range.lambda) +
           " MPa, mu = " + range_in_words(range.mu) +
           " MPa, G_c = " + range_in_words(range.critical_energy_release_rate) +
           " N/mm";
  }



#define INSTANTIATE(dim)                                                       \
  template MaterialField<dim> make_material_field(const MaterialParameters &,  \
                                                  const Triangulation<dim> &); \
  template ConstantsFunction<dim> constants_function(                          \
    const ModelParameters &, const MaterialField<dim> &);                      \
  template MaterialRange material_range(const MaterialField<dim> &,            \
                                        const Fields<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
