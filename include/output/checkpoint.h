// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_checkpoint_h
#define mixed_cracks_output_checkpoint_h

#include <core/state.h>

#include <deal.II/distributed/tria.h>

#include <discretization/fields.h>

#include <output/statistics.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// All of a run that is not a field.
  struct RunRecord
  {
    /// the entries of the .prm that must not change between the two parts
    std::string  signature;
    double       cell_size     = 0.; ///< mm, of the first mesh
    double       time          = 0.; ///< s
    double       time_step     = 0.; ///< that led here, s
    double       next_step     = 0.; ///< s
    double       peak_force    = 0.; ///< N
    double       external_work = 0.; ///< mJ
    unsigned int peak_step     = 0;
    unsigned int steps_to_wait = 0; ///< before the load step may grow

    /// where damage was seen first, mm
    std::vector<dealii::Point<2>>               nuclei;
    std::vector<StatisticsRow>                  rows;
    std::vector<std::pair<double, std::string>> field_files;

    /// CSV files whose rows belong to the state, by name, as far as they have
    /// come; when they are written, rank 0 alone knows them
    std::map<std::string, std::string> tables;
  };

  /// The state written down, in two generations so that one of them is whole
  /// whenever the program is stopped. Each has checksums of its files.
  template <int dim>
  class Checkpoint
  {
  public:
    using Triangulation = dealii::parallel::distributed::Triangulation<dim>;

    /// @p directory: the output directory.
    Checkpoint(const std::string &directory, MPI_Comm communicator);

    /// Overwrite the older generation. Throws FileError. Collective.
    void write(const RunRecord     &record,
               const State         &state,
               const Fields<dim>   &fields,
               const Triangulation &triangulation) const;

    /// Find the newest whole generation and read what is not a field. Throws
    /// InputError when there is none. Collective.
    RunRecord read();

    /// Refine the coarse mesh as it was, after read().
    void load_mesh(Triangulation &triangulation) const;

    /// The fields, after load_mesh() and the distribution of dofs; times are
    /// left alone.
    void load_fields(const Fields<dim> &fields, State &state) const;

  private:
    std::string generation_directory(int generation) const;

    /// Step of a generation, -1 when it is not whole. On rank 0.
    int step_of(int generation) const;

    const std::string directory;
    const MPI_Comm    communicator;
    int               chosen = 0;
  };
} // namespace MixedCracks

#endif
