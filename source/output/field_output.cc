// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>

#include <deal.II/numerics/data_out.h>

#include <output/directory.h>
#include <output/field_output.h>

#include <algorithm>
#include <fstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    void
    add_elastic_fields(const Fields<dim>           &fields,
                       const LinearAlgebra::Vector &solution,
                       DataOut<dim>                &data_out)
    {
      using Kind = DataComponentInterpretation::DataComponentInterpretation;
      std::vector<std::string> names(dim, "displacement");
      std::vector<Kind>        kinds(
        dim, DataComponentInterpretation::component_is_part_of_vector);
      if (fields.layout.mixed)
      {
        names.emplace_back("pressure");
        kinds.push_back(DataComponentInterpretation::component_is_scalar);
      }
      data_out.add_data_vector(fields.elastic, solution, names, kinds);
    }
  } // namespace



  template <int dim>
  FieldOutput<dim>::FieldOutput(const Fields<dim> &fields,
                                const std::string &directory)
    : fields(fields)
    , directory(directory)
  {}



  template <int dim>
  void
  FieldOutput<dim>::write(const State                                &state,
                          const unsigned int                          step,
                          const std::map<std::string, Vector<float>> &cell_data)
  {
    if (!steps.insert(step).second)
      return;
    DataOut<dim>          data_out;
    const auto           &triangulation = fields.elastic.get_triangulation();
    DataOutBase::VtkFlags flags;
    flags.time = state.time;
    flags.compression_level =
      DataOutBase::VtkFlags::ZlibCompressionLevel::best_speed;
    data_out.set_flags(flags);
    data_out.attach_triangulation(triangulation);
    add_elastic_fields(fields, state.elastic, data_out);
    data_out.add_data_vector(
      fields.phase_field, state.phase_field, "phase_field");
    for (const auto &[name, values] : cell_data)
      data_out.add_data_vector(values, name, DataOut<dim>::type_cell_data);
    Vector<float> subdomain(triangulation.n_active_cells());
    subdomain = static_cast<float>(triangulation.locally_owned_subdomain());
    data_out.add_data_vector(
      subdomain, "subdomain", DataOut<dim>::type_cell_data);
    data_out.build_patches(fields.mapping);

    std::string name;
    int         failures = 0;
    try
    {
      // one file for each rank: needs no parallel file system
      name = data_out.write_vtu_with_pvtu_record(
        directory + "/fields/", "fields", step, fields.communicator(), 5, 0);
    }
    catch (const std::exception &)
    {
      failures = 1;
    }
    // any rank may be the one whose file failed
    if (Utilities::MPI::max(failures, fields.communicator()) > 0)
      throw FileError("Output/Directory: the fields cannot be written in '" +
                      directory + "/fields'; is the disk full?");
    times_and_names.emplace_back(state.time, "fields/" + name);
    write_collection();
  }



  template <int dim>
  void
  FieldOutput<dim>::write_collection() const
  {
    if (Utilities::MPI::this_mpi_process(fields.communicator()) != 0)
      return;
    // the peak is written when the force has fallen: keep the list in order
    auto sorted = times_and_names;
    std::sort(sorted.begin(), sorted.end());
    std::ofstream file(directory + "/fields.pvd");
    DataOutBase::write_pvd_record(file, sorted);
  }



  template <int dim>
  void
  FieldOutput<dim>::restore(
    const std::vector<std::pair<double, std::string>> &earlier)
  {
    times_and_names = earlier;
    // "fields/fields_00012.pvtu": the step is in the name
    for (const auto &record : earlier)
      steps.insert(Utilities::string_to_int(
        record.second.substr(record.second.size() - 10, 5)));
  }



  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace MixedCracks
