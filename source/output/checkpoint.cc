// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>

#include <deal.II/base/mpi.h>

#include <deal.II/distributed/solution_transfer.h>

#include <output/checkpoint.h>
#include <output/directory.h>
#include <output/run_record.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;
  namespace fs = std::filesystem;

  namespace
  {
    using Vector = LinearAlgebra::Vector;

    template <int dim>
    using Transfer = parallel::distributed::SolutionTransfer<dim, Vector>;

    // the last file to be written: what it names is whole
    const char *const seal_name   = "seal.txt";
    const char *const record_name = "record.txt";
    const char *const mesh_name   = "mesh";

    // every file but the seal itself with its checksum, in order of names
    std::string
    contents(const fs::path &directory)
    {
      std::vector<std::string> lines;
      for (const auto &entry : fs::directory_iterator(directory))
        if (entry.path().filename() != seal_name)
          lines.push_back(entry.path().filename().string() + ' ' +
                          std::to_string(file_checksum(entry.path().string())));
      std::sort(lines.begin(), lines.end());
      std::string text;
      for (const std::string &line : lines)
        text += line + '\n';
      return text;
    }



    void
    seal(const fs::path &directory, const unsigned int step)
    {
      const std::string text = contents(directory);
      std::ofstream     file(directory / seal_name);
      file << step << '\n' << text << std::flush;
      if (!file)
        throw FileError("the disk may be full");
    }
  } // namespace



  template <int dim>
  Checkpoint<dim>::Checkpoint(const std::string &output_directory,
                              const MPI_Comm     communicator)
    : directory(output_directory + "/checkpoint")
    , communicator(communicator)
  {}



  template <int dim>
  std::string
  Checkpoint<dim>::generation_directory(const int generation) const
  {
    return directory + "/generation-" + std::to_string(generation);
  }



  template <int dim>
  int
  Checkpoint<dim>::step_of(const int generation) const
  {
    const fs::path path = generation_directory(generation);
    std::ifstream  file(path / seal_name);
    int            step = -1;
    if (!(file >> step))
      return -1;
    std::string rest;
    std::getline(file, rest);
    std::ostringstream listed;
    listed << file.rdbuf();
    return listed.str() == contents(path) ? step : -1;
  }



  template <int dim>
  void
  Checkpoint<dim>::write(const RunRecord     &record,
                         const State         &state,
                         const Fields<dim>   &fields,
                         const Triangulation &triangulation) const
  {
    const bool  first = Utilities::MPI::this_mpi_process(communicator) == 0;
    int         generation = 0;
    std::string message;
    if (first)
      try
      {
        generation = step_of(0) < step_of(1) ? 0 : 1;
        fs::remove_all(generation_directory(generation));
        fs::create_directories(generation_directory(generation));
      }
      catch (const std::exception &error)
      {
        message =
          std::string("the checkpoint cannot be written: ") + error.what();
      }
    throw_on_all_ranks(message, communicator);
    generation = Utilities::MPI::broadcast(communicator, generation, 0);

    Transfer<dim> elastic(fields.elastic), phase_field(fields.phase_field);
    elastic.prepare_for_serialization(
      std::vector<const Vector *>{&state.elastic, &state.reaction});
    phase_field.prepare_for_serialization(
      std::vector<const Vector *>{&state.phase_field,
                                  &state.lagged_phase_field,
                                  &state.previous_phase_field});
    triangulation.save(generation_directory(generation) + '/' + mesh_name);
    MPI_Barrier(communicator);
    if (first)
      try
      {
        {
          std::ofstream file(generation_directory(generation) + '/' +
                             record_name);
          write_record(file, record);
        }
        seal(generation_directory(generation), record.rows.back().step);
      }
      catch (const std::exception &error)
      {
        message =
          std::string("the checkpoint cannot be written: ") + error.what();
      }
    throw_on_all_ranks(message, communicator);
  }



  template <int dim>
  RunRecord
  Checkpoint<dim>::read()
  {
    std::string text, message;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      const int steps[] = {
        fs::exists(generation_directory(0)) ? step_of(0) : -1,
        fs::exists(generation_directory(1)) ? step_of(1) : -1};
      chosen = steps[1] > steps[0] ? 1 : 0;
      if (steps[chosen] < 0)
        message = "--resume: there is no whole checkpoint in '" + directory +
                  "'. Allowed: the output directory of a run that wrote one "
                  "(Output/Checkpoint every).";
      std::ifstream      file(generation_directory(chosen) + '/' + record_name);
      std::ostringstream all;
      all << file.rdbuf();
      text = all.str();
    }
    throw_on_all_ranks(message, communicator);
    chosen = Utilities::MPI::broadcast(communicator, chosen, 0);
    std::istringstream in(Utilities::MPI::broadcast(communicator, text, 0));
    return read_record(in);
  }



  template <int dim>
  void
  Checkpoint<dim>::load_mesh(Triangulation &triangulation) const
  {
    triangulation.load(generation_directory(chosen) + '/' + mesh_name);
  }



  template <int dim>
  void
  Checkpoint<dim>::load_fields(const Fields<dim> &fields, State &state) const
  {
    Vector elastic     = fields.owned_vector(fields.elastic_dofs);
    Vector reaction    = elastic;
    Vector phase_field = fields.owned_vector(fields.phase_field_dofs);
    Vector lagged = phase_field, previous = phase_field;
    // in the order in which they were written
    Transfer<dim>         elastic_transfer(fields.elastic);
    Transfer<dim>         phase_field_transfer(fields.phase_field);
    std::vector<Vector *> on_elastic     = {&elastic, &reaction};
    std::vector<Vector *> on_phase_field = {&phase_field, &lagged, &previous};
    elastic_transfer.deserialize(on_elastic);
    phase_field_transfer.deserialize(on_phase_field);
    state.elastic              = fields.ghosted_vector(fields.elastic_dofs);
    state.reaction             = state.elastic;
    state.phase_field          = fields.ghosted_vector(fields.phase_field_dofs);
    state.lagged_phase_field   = state.phase_field;
    state.previous_phase_field = state.phase_field;
    const Vector &elastic_values = elastic, &reaction_values = reaction;
    const Vector &phase_field_values = phase_field, &lagged_values = lagged;
    const Vector &previous_values = previous;
    state.elastic                 = elastic_values;
    state.reaction                = reaction_values;
    state.phase_field             = phase_field_values;
    state.lagged_phase_field      = lagged_values;
    state.previous_phase_field    = previous_values;
  }



  template class Checkpoint<2>;
  template class Checkpoint<3>;
} // namespace MixedCracks
