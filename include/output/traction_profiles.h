// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_traction_profiles_h
#define mixed_cracks_output_traction_profiles_h

#include <assembly/assembler.h>

#include <discretization/boundary_ids.h>
#include <discretization/state.h>

#include <mpi.h>

#include <output/restored_table.h>

#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// What is written of tractions.
  struct TractionProfileOptions
  {
    std::vector<std::pair<std::string, BoundaryIds>> boundaries;

    unsigned int every     = 1;  ///< steps
    double       thickness = 1.; ///< mm; 1 in 3-d
  };

  /// DIR/traction_profiles.csv: a row per step that is written and quadrature
  /// point on the boundaries; without boundaries there is no file. The rows
  /// are in the order of the coordinates, on any number of ranks. Rank 0
  /// writes; throws FileError on all of them. Collective.
  template <int dim>
  class TractionProfiles : public RestoredTable
  {
  public:
    TractionProfiles(const std::string     &directory,
                     TractionProfileOptions options,
                     MPI_Comm               communicator);



    /// An accepted step, where it is its turn.
    void
    add(unsigned int step, const State &state, const Assembler<dim> &assembler);

  private:
    const TractionProfileOptions options;
  };
} // namespace MixedCracks

#endif
