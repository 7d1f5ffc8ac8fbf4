// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_checkpoint_generations_h
#define mixed_cracks_output_checkpoint_generations_h

#include <mpi.h>

#include <array>
#include <string>

namespace MixedCracks
{
  /// What is found of the two generations of a checkpoint.
  struct Generations
  {
    /// why a generation is not whole; empty where it is
    std::array<std::string, 2> faults;
    int                        newest = -1; ///< that is whole, if any
    unsigned int               step   = 0;  ///< of the newest
    unsigned long int          number = 0;  ///< of the newest since the start
    /// one of them was written by another version of the program
    bool has_other_format = false;
  };

  /// @p directory: that of the checkpoint.
  std::string generation_directory(const std::string &directory,
                                   int                generation);

  /// Look on rank 0, and tell all. Collective.
  Generations look_for_generations(const std::string &directory,
                                   MPI_Comm           communicator);

  /// The reasons, each behind "; generation-0: ".
  std::string faults_in_words(const Generations &generations);

  /// Which generation is not whole, why, and what a run goes on from instead;
  /// empty where there is nothing to say.
  std::string fallback_in_words(const Generations &generations);

  /// Whether the fallback is due to damage: a generation that was being written
  /// when the run was killed has none.
  bool has_damage(const Generations &generations);
} // namespace MixedCracks

#endif
