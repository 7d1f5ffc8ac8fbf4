// SPDX-License-Identifier: GPL-2.0-or-later
// Which generation a run goes on from: of those that are whole, the one with
// the larger number. Numbers count checkpoints since the start of the run and
// go on when it is resumed; times of files would depend on clocks and on
// copying.
//
//   no folder                     not there
//   no seal.txt                   not finished: the run was killed meanwhile
//   another number of format      of another program: Checkpoint::read()
//                                 refuses both, it may be the newer one
//   record or a file changed      damaged: the other one serves, with a warning

#include <base/errors.h>

#include <deal.II/base/mpi.h>

#include <output/checkpoint_generations.h>
#include <output/checkpoint_seal.h>
#include <output/disk.h>
#include <output/run_record.h>

#include <filesystem>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // why a generation is not whole, where nothing has gone wrong
    const std::string not_there    = "it is not there";
    const std::string not_finished = "it was not finished, it has no seal.txt";

    // throws what is wrong with it
    void
    look_at(const std::string &path,
            const int          generation,
            const Seal        &seal,
            Generations       &found)
    {
      if (seal.format != checkpoint_format())
      {
        found.has_other_format = true;
        throw FileError("checkpoint format " + std::to_string(seal.format) +
                        ", this program reads " +
                        std::to_string(checkpoint_format()));
      }
      std::istringstream run(read_sealed(path).run);
      if (read_record(run).rows.back().step() != seal.step)
        throw FileError("it ends at another step than its seal");
      if (found.newest >= 0 && seal.number <= found.number)
        return;
      found.newest = generation;
      found.number = seal.number;
      found.step   = seal.step;
    }

    std::string
    fault(const std::string &path, const int generation, Generations &found)
    {
      const Seal seal = read_seal(path);
      if (!std::filesystem::is_directory(path))
        return not_there;
      if (seal.format == 0)
        return size_of_file(path + "/seal.txt") < 0
                 ? not_finished
                 : "'seal.txt' is not what was written";
      try
      {
        look_at(path, generation, seal, found);
      }
      catch (const std::exception &error)
      {
        return error.what();
      }
      return "";
    }

    // of the one that does not serve
    std::string
    other_fault(const Generations &generations)
    {
      return generations.newest < 0
               ? ""
               : generations.faults[1 - generations.newest];
    }
  } // namespace



  std::string
  generation_directory(const std::string &directory, const int generation)
  {
    return directory + "/generation-" + std::to_string(generation);
  }



  Generations
  look_for_generations(const std::string &directory,
                       const MPI_Comm     communicator)
  {
    using namespace dealii::Utilities::MPI;
    Generations found;
    if (this_mpi_process(communicator) == 0)
      for (const int generation : {0, 1})
        found.faults[generation] =
          fault(generation_directory(directory, generation), generation, found);
    for (std::string &reason : found.faults)
      reason = broadcast(communicator, reason, 0);
    found.newest           = broadcast(communicator, found.newest, 0);
    found.number           = broadcast(communicator, found.number, 0);
    found.step             = broadcast(communicator, found.step, 0);
    found.has_other_format = broadcast(communicator, found.has_other_format, 0);
    return found;
  }



  std::string
  faults_in_words(const Generations &generations)
  {
    std::string text;
    for (const int generation : {0, 1})
      if (!generations.faults[generation].empty())
        text += "; generation-" + std::to_string(generation) + ": " +
                generations.faults[generation];
    return text;
  }



  bool
  has_damage(const Generations &generations)
  {
    const std::string reason = other_fault(generations);
    return !reason.empty() && reason != not_there && reason != not_finished;
  }



  std::string
  fallback_in_words(const Generations &generations)
  {
    const std::string reason = other_fault(generations);
    if (reason.empty() || reason == not_there)
      return "";
    return "generation-" + std::to_string(1 - generations.newest) +
           " of the checkpoint " +
           (has_damage(generations) ? "is damaged (" + reason + ")"
                                    : "was not finished when the run ended") +
           "; the run goes on from generation-" +
           std::to_string(generations.newest) + ", which is of step " +
           std::to_string(generations.step);
  }
} // namespace MixedCracks
