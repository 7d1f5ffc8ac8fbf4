// SPDX-License-Identifier: GPL-2.0-or-later
// Fields of a step: VTU, one file per rank with a .pvtu that lists them, or
// XDMF, or both; and a list over the steps. Order: names into run_files.txt,
// the files of the step, then the list, so that the list never names a file
// that is not whole. fields.pvd and fields.xdmf are replaced by renaming: a
// reader sees the old or the new one.
//
// The libraries do not say when the disk is full: the last block of a file is
// written in a destructor. Each rank therefore looks whether its file has the
// last line that it should have.
//
// Steps come out of order, as the peak is written when it is over; lists are
// sorted by time or step.

#include <base/errors.h>

#include <deal.II/numerics/data_out.h>

#include <output/crack_surface.h>
#include <output/disk.h>
#include <output/field_output.h>
#include <output/run_files.h>
#include <output/small_file.h>

#include <algorithm>
#include <sstream>

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



    // "fields/fields_00012.pvtu": the step is in the name, with five digits or
    // more
    std::string
    digits_of_step(const std::string &name)
    {
      const auto begin = name.rfind('_') + 1;
      return name.substr(begin, name.find('.', begin) - begin);
    }

    // "fields_00012.02.vtu" of "fields_00012.pvtu", rank 2 and 12 ranks
    std::string
    piece_of(const std::string &name, const MPI_Comm communicator)
    {
      const unsigned int last =
        Utilities::MPI::n_mpi_processes(communicator) - 1;
      return name.substr(0, name.rfind('.')) + '.' +
             Utilities::int_to_string(
               Utilities::MPI::this_mpi_process(communicator),
               Utilities::needed_digits(last)) +
             ".vtu";
    }

    template <int dim>
    bool
    has_owned_cells(const Triangulation<dim> &triangulation)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          return true;
      return false;
    }
  } // namespace



  template <int dim>
  FieldOutput<dim>::FieldOutput(const Fields<dim> &fields,
                                const std::string &directory,
                                const std::string &format)
    : fields(fields)
    , directory(directory)
    , writes_vtu(format == "VTU" || format == "both")
    , writes_xdmf(format == "XDMF" || format == "both")
    , xdmf(directory, fields.communicator())
    , mesh_watch(fields.elastic.get_triangulation().signals.any_change.connect(
        [this]() { xdmf.mesh_changed(); }))
  {}



  template <int dim>
  void
  FieldOutput<dim>::write(const State                                &state,
                          const unsigned int                          step,
                          const std::map<std::string, Vector<float>> &cell_data)
  {
    if (!is_on() || !steps.insert(step).second)
      return;
    DataOut<dim>          data_out;
    const auto           &triangulation = fields.elastic.get_triangulation();
    DataOutBase::VtkFlags flags;
    flags.time = state.time;
    // the enumeration has another name in deal.II 9.4 than from 9.5 on
    flags.compression_level = decltype(flags.compression_level)::best_speed;
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
    if (writes_xdmf)
      name =
        xdmf.write(data_out, has_owned_cells(triangulation), state.time, step);
    if (writes_vtu)
      name = write_vtu(data_out, step);
    times_and_names.emplace_back(state.time, name);
    if (writes_vtu)
      write_collection();
    if constexpr (dim == 3)
      write_surface(state.phase_field);
  }



  template <int dim>
  void
  FieldOutput<dim>::write_surface(
    const LinearAlgebra::Vector &phase_field) const
  {
    if constexpr (dim == 3)
    {
      std::vector<std::pair<double, std::string>> surfaces;
      for (const auto &[time, name] : times_and_names)
        surfaces.emplace_back(
          time, "fields/crack_surface_" + digits_of_step(name) + ".vtp");
      const std::string latest = surfaces.back().second;
      std::sort(surfaces.begin(), surfaces.end());
      write_crack_surface(fields, phase_field, directory, latest, surfaces);
    }
  }



  // as write_vtu_with_pvtu_record() calls them
  template <int dim>
  bool
  FieldOutput<dim>::note_vtu_files(const unsigned int step) const
  {
    if (Utilities::MPI::this_mpi_process(fields.communicator()) != 0)
      return true;
    const unsigned int n =
      Utilities::MPI::n_mpi_processes(fields.communicator());
    const std::string base =
      "fields/fields_" + Utilities::int_to_string(step, 5) + '.';
    std::vector<std::string> names = {base + "pvtu"};
    for (unsigned int rank = 0; rank < n; ++rank)
      names.push_back(
        base + Utilities::int_to_string(rank, Utilities::needed_digits(n - 1)) +
        ".vtu");
    return note_run_files(directory, names);
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_vtu(const DataOut<dim> &data_out,
                              const unsigned int  step) const
  {
    std::string name;
    int         failures = note_vtu_files(step) ? 0 : 1;
    try
    {
      // one file for each rank: needs no parallel file system
      name = data_out.write_vtu_with_pvtu_record(
        directory + "/fields/", "fields", step, fields.communicator(), 5, 0);
      // the last part of a file is written when it is closed, and nobody looks
      const std::string end  = "</VTKFile>\n";
      const std::string path = directory + "/fields/";
      const bool        is_first =
        Utilities::MPI::this_mpi_process(fields.communicator()) == 0;
      if (!ends_with(path + piece_of(name, fields.communicator()), end) ||
          (is_first && !ends_with(path + name, end)))
        failures = 1;
    }
    catch (const std::exception &)
    {
      failures = 1;
    }
    // any rank may be the one whose file failed
    if (Utilities::MPI::max(failures, fields.communicator()) > 0)
      throw FileError("Output/Directory: the fields cannot be written in '" +
                      directory + "/fields'; is the disk full?");
    return "fields/" + name;
  }



  template <int dim>
  void
  FieldOutput<dim>::write_collection() const
  {
    on_first_rank(fields.communicator(), [&]() {
      // the peak is written when the force has fallen: keep the list in order
      std::vector<std::pair<double, std::string>> sorted;
      for (const auto &record : times_and_names)
        if (record.second.find(".pvtu") != std::string::npos)
          sorted.push_back(record);
      std::sort(sorted.begin(), sorted.end());
      std::ostringstream text;
      DataOutBase::write_pvd_record(text, sorted);
      // the old list stays until the new one is whole
      const std::string problem =
        write_durably(directory + "/fields.pvd", text.str());
      if (!problem.empty())
        throw FileError(
          "Output/Directory: the list of fields cannot be written: " + problem +
          '.');
    });
  }



  template <int dim>
  void
  FieldOutput<dim>::restore(
    const std::vector<std::pair<double, std::string>> &earlier)
  {
    times_and_names = earlier;
    for (const auto &record : earlier)
      steps.insert(Utilities::string_to_int(digits_of_step(record.second)));
    xdmf.restore(steps);
  }



  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace MixedCracks
