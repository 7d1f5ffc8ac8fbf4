// SPDX-License-Identifier: GPL-2.0-or-later
// How a checkpoint is written. G is the older generation (or one that is not
// whole), H the other one, which nobody touches. A crash or power failure after
//
//   1. G: remove seal.txt, then the rest, or  G has no seal: "not finished"
//      make its folder, durably
//   2. reserve room for the files of G        likewise
//   3. mesh, mesh.info, mesh_fixed.data       likewise
//   4. fsync on every rank                    likewise
//   5. read the values back, compare sums     likewise
//   6. record.txt, durably; read it back      likewise
//   7. seal.txt, durably; read it back        G is whole and newer than H
//
// leaves H to resume from up to 6. The rename in 7 is the one moment at which
// the checkpoint changes; before the first of all there is none. That unlink in
// 1 reaches the disk before what follows is not needed: an old seal does not
// fit to a new record, and an old record not to new files (checkpoint_seal.cc).
//
// Two generations rather than a copy that is renamed: a folder cannot replace
// another that is not empty. Room is looked for first, as the libraries of step
// 3 abort or go on when a write fails; values are read back for the same
// reason.
//
// What fails on one rank is thrown on all of them, by a reduction after 2, 4, 5
// and 7. The others would wait in the next collective call, a deadlock.

#include <base/collective.h>
#include <base/errors.h>

#include <deal.II/base/mpi.h>

#include <output/checkpoint.h>
#include <output/directory.h>
#include <output/disk.h>
#include <output/run_files.h>
#include <output/run_record.h>

#include <filesystem>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;
  namespace fs = std::filesystem;

  namespace
  {
    const std::string mesh_name = "/mesh";

    // Of a cell of the coarse mesh in p4est's file: its corners, neighbours
    // and, at most, corners and edges of its own.
    template <int dim>
    constexpr std::uint64_t bytes_per_tree = dim == 2 ? 140 : 400;

    // The same where each corner and edge belongs to as many cells as in a
    // regular mesh.
    template <int dim>
    constexpr std::uint64_t usual_bytes_per_tree = dim == 2 ? 68 : 234;

    // Of a cell in p4est's file: its coordinates and its level.
    template <int dim>
    constexpr std::uint64_t bytes_per_quadrant = 4 * (dim + 1);

    // of what is small: record, seal, the ends of blocks
    constexpr std::uint64_t margin = 65536;

    // the same, as it is without rows
    constexpr std::uint64_t usual_record = 4096;

    // s, for the other ranks where writing has failed on one
    constexpr double patience = 30.;



    template <int dim>
    std::uint64_t
    largest_mesh_size(const std::uint64_t n_cells,
                      const std::uint64_t n_coarse_cells)
    {
      return n_cells * bytes_per_quadrant<dim> +
             n_coarse_cells * bytes_per_tree<dim> + 16384;
    }



    // p4est puts the cells last, each with bytes of its own, at a multiple of
    // 32 bytes, and before them the counts of cells of the coarse ones. What
    // was cut off elsewhere is found out before it ends the program there.
    template <int dim>
    void
    require_mesh_size(const std::string  &path,
                      const std::uint64_t n_cells,
                      const std::uint64_t n_coarse_cells)
    {
      const auto size  = static_cast<std::uint64_t>(size_of_file(path));
      const auto cells = n_cells * bytes_per_quadrant<dim>;
      if (size < cells + 8 * n_coarse_cells || (size - cells) % 32 != 0 ||
          size > largest_mesh_size<dim>(n_cells, n_coarse_cells))
        throw FileError("'" + path + "' has " + std::to_string(size) +
                        " bytes, which is not the size of a mesh of " +
                        std::to_string(n_cells) + " cells");
    }



    // the same on all ranks
    template <int dim>
    unsigned int
    mesh_checksum(const parallel::distributed::Triangulation<dim> &mesh)
    {
      return Utilities::MPI::broadcast(
        mesh.get_communicator(), mesh.get_checksum(), 0);
    }



    // Throw what went wrong on the first rank that has a message, on all of
    // them.
    void
    require_on_all_ranks(const std::string &message,
                         const MPI_Comm     communicator)
    {
      const unsigned int n = Utilities::MPI::n_mpi_processes(communicator);
      const unsigned int failing = Utilities::MPI::min(
        message.empty() ? n : Utilities::MPI::this_mpi_process(communicator),
        communicator);
      if (failing < n)
        throw FileError(
          "the checkpoint cannot be written: " +
          Utilities::MPI::broadcast(communicator, message, failing));
    }
  } // namespace



  template <int dim>
  std::uint64_t
  checkpoint_size(const Fields<dim>  &fields,
                  const std::uint64_t n_cells,
                  const std::uint64_t n_coarse_cells)
  {
    FieldsOnDisk values;
    values.cells          = n_cells;
    values.bytes_per_cell = checkpoint_bytes_per_cell(fields);
    return size_of_values(values) + n_cells * bytes_per_quadrant<dim> +
           n_coarse_cells * usual_bytes_per_tree<dim> + usual_record;
  }



  template <int dim>
  std::string
  Checkpoint<dim>::newest_directory() const
  {
    return generation_directory(directory, generations->newest);
  }



  template <int dim>
  void
  Checkpoint<dim>::make_room(const std::string   &path,
                             const Fields<dim>   &fields,
                             const Triangulation &triangulation) const
  {
    std::string  message;
    FieldsOnDisk values;
    values.cells          = triangulation.n_global_active_cells();
    values.bytes_per_cell = checkpoint_bytes_per_cell(fields);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      try
      {
        // the seal first: what is half removed is no damage
        for (const std::string &name : files_of_generation())
          fs::remove(path + '/' + name);
        for (const std::string &folder : {directory, path})
          if (message.empty())
            message = make_folder_durably(folder);
        if (message.empty())
          message = missing_space_for(
            {{path + mesh_name,
              largest_mesh_size<dim>(values.cells, triangulation.n_cells(0))},
             {path + mesh_name + "_fixed.data", size_of_values(values)},
             {path + "/record.txt", margin}});
      }
      catch (const std::exception &error)
      {
        message = error.what();
      }
    require_on_all_ranks(message, communicator);
  }



  template <int dim>
  void
  Checkpoint<dim>::write(const RunRecord   &record,
                         const State       &state,
                         const Fields<dim> &fields,
                         Triangulation     &triangulation)
  {
    if (!generations)
      generations = look_for_generations(directory, communicator);
    const int         next   = generations->newest == 0 ? 1 : 0;
    const std::string path   = generation_directory(directory, next);
    const auto        number = generations->number + 1;
    make_room(path, fields, triangulation);

    ContentsOnDisk written;
    written.mesh_checksum  = mesh_checksum(triangulation);
    written.damage_origins = state.damage_origins;
    std::string message;
    try
    {
      written.fields = CheckpointFields<dim>(fields).save(
        state, triangulation, path + mesh_name);
    }
    catch (const ExceptionBase &)
    {
      // of MPI; usually it comes to all ranks
      if (!all_ranks_arrive(communicator, patience))
        throw;
      message = "MPI cannot open or write '" + path + mesh_name +
                "_fixed.data'; what it has printed may say why";
    }
    require_on_all_ranks(message, communicator);
    // every rank sends its part to the disk
    for (const char *const ending : {"", ".info", "_fixed.data"})
      if (message.empty())
        message = sync_to_disk(path + mesh_name + ending);
    require_on_all_ranks(message, communicator);
    const FieldsOnDisk found =
      read_back(path + mesh_name + "_fixed.data", written.fields, communicator);
    if (found.sum != written.fields.sum || found.cells != written.fields.cells)
      message = "'" + path + mesh_name +
                "_fixed.data' is not what was written; is the disk full?";
    require_on_all_ranks(message, communicator);

    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      try
      {
        require_mesh_size<dim>(
          path + mesh_name, written.fields.cells, triangulation.n_cells(0));
        written.files = files_of_libraries(path);
        std::ostringstream run;
        write_record(run, record);
        write_seal(path, written, run.str(), number, record.rows.back().step());
        if (read_seal(path).number != number)
          throw FileError("its seal is not what was written");
      }
      catch (const std::exception &error)
      {
        message = error.what();
      }
    require_on_all_ranks(message, communicator);
    generations->newest = next;
    generations->number = number;
  }



  template <int dim>
  RunRecord
  Checkpoint<dim>::read()
  {
    generations = look_for_generations(directory, communicator);
    // one that another program wrote may be the newer one
    if (generations->has_other_format || generations->newest < 0)
      throw FileError(
        "--resume: there is no whole checkpoint in '" + directory + "'" +
        faults_in_words(*generations) +
        ". Allowed: the output directory of a run that wrote one (Output/"
        "Checkpoint every).");
    std::string text;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      text = contents_of_file(newest_directory() + "/record.txt");
    const SealedRecord sealed =
      split_record(Utilities::MPI::broadcast(communicator, text, 0));
    contents = sealed.contents;
    std::istringstream run(sealed.run);
    return read_record(run);
  }



  template <int dim>
  void
  Checkpoint<dim>::load_mesh(Triangulation &triangulation) const
  {
    int failed = 0;
    try
    {
      require_mesh_size<dim>(newest_directory() + mesh_name,
                             contents.fields.cells,
                             triangulation.n_cells(0));
      triangulation.load(newest_directory() + mesh_name);
    }
    catch (const std::exception &)
    {
      failed = 1;
    }
    if (Utilities::MPI::max(failed, communicator) > 0 ||
        mesh_checksum(triangulation) != contents.mesh_checksum ||
        triangulation.n_global_active_cells() != contents.fields.cells)
      throw FileError("--resume: the mesh of the checkpoint in '" + directory +
                      "' cannot be restored.");
  }



  template <int dim>
  void
  Checkpoint<dim>::load_fields(const Fields<dim> &fields,
                               Triangulation     &triangulation,
                               State             &state) const
  {
    if (checkpoint_bytes_per_cell(fields) != contents.fields.bytes_per_cell)
      throw FileError("--resume: the checkpoint in '" + directory +
                      "' holds values of other elements.");
    try
    {
      CheckpointFields<dim>(fields).load(contents.fields, triangulation, state);
    }
    catch (const FileError &error)
    {
      throw FileError("--resume: the checkpoint in '" + directory +
                      "' cannot be read: " + error.what() + ".");
    }
    state.damage_origins = contents.damage_origins;
  }



  template class Checkpoint<2>;
  template class Checkpoint<3>;
  template std::uint64_t
  checkpoint_size(const Fields<2> &, std::uint64_t, std::uint64_t);
  template std::uint64_t
  checkpoint_size(const Fields<3> &, std::uint64_t, std::uint64_t);
} // namespace MixedCracks
