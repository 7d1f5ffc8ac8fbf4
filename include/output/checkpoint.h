// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_checkpoint_h
#define mixed_cracks_output_checkpoint_h

#include <deal.II/distributed/tria.h>

#include <discretization/fields.h>
#include <discretization/state.h>

#include <output/checkpoint_generations.h>
#include <output/checkpoint_seal.h>
#include <output/run_end.h>
#include <output/run_totals.h>
#include <output/statistics.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// All of a run that is not a field.
  struct RunRecord
  {
    /// the entries of the .prm that must not change between the two parts
    std::string signature;
    /// what a step that failed was tried with, as in case_signature.h
    std::string  attempt;
    RunEnd       end = RunEnd::none;
    std::string  why_failed;         ///< behind the words for the end
    double       cell_size     = 0.; ///< mm, of the first mesh
    double       time          = 0.; ///< s
    double       time_step     = 0.; ///< that led here, s
    double       next_step     = 0.; ///< s, not shortened to meet the end time
    double       peak_force    = 0.; ///< N
    double       external_work = 0.; ///< mJ
    unsigned int peak_step     = 0;
    unsigned int steps_to_wait = 0; ///< before the load step may grow
    unsigned int n_refinements = 0; ///< of the mesh so far
    /// where faces of a slit have passed through each other, for the warnings
    unsigned int n_overlapping_steps = 0;
    double       deepest_overlap     = 0.; ///< mm
    std::string  overlap_in_words;
    /// warnings of loads that were mended on the way, when the run was resumed
    std::vector<std::string> changed_loads;
    RunTotals                totals; ///< so far

    std::vector<StatisticsRow>                  rows;
    std::vector<std::pair<double, std::string>> field_files;

    /// CSV files whose rows belong to the state, by name, as far as they have
    /// come; when they are written, rank 0 alone knows them
    std::map<std::string, std::string> tables;
  };

  /// The state written down, in two generations so that one of them is whole
  /// whenever the program is stopped. A generation is whole when its seal fits
  /// to its record, and the record to the files that it lists with sizes and
  /// checksums.
  template <int dim>
  class Checkpoint
  {
  public:
    using Triangulation = dealii::parallel::distributed::Triangulation<dim>;

    /// @p directory: the output directory.
    Checkpoint(const std::string &output_directory, const MPI_Comm communicator)
      : directory(output_directory + "/checkpoint")
      , communicator(communicator)
    {}

    /// Overwrite the older generation: when this returns, it is on the disk
    /// and was read back. Throws FileError, and leaves the other generation
    /// alone. Collective.
    void write(const RunRecord   &record,
               const State       &state,
               const Fields<dim> &fields,
               Triangulation     &triangulation);

    /// Find the newest whole generation and read what is not a field. Throws
    /// FileError when there is none, or one of another format. Collective.
    RunRecord read();

    /// What read() has found.
    const Generations &
    found() const
    {
      return *generations;
    }

    /// Refine the coarse mesh as it was, after read(). Throws FileError.
    void load_mesh(Triangulation &triangulation) const;

    /// The fields and what was seen of damage, after load_mesh() and the
    /// distribution of dofs; times are left alone. Throws FileError.
    void load_fields(const Fields<dim> &fields,
                     Triangulation     &triangulation,
                     State             &state) const;

  private:
    std::string newest_directory() const;

    /// Remove the files of a generation and see that the disk has room for a
    /// new one.
    void make_room(const std::string   &path,
                   const Fields<dim>   &fields,
                   const Triangulation &triangulation) const;

    const std::string          directory;
    const MPI_Comm             communicator;
    std::optional<Generations> generations; ///< once somebody has looked
    ContentsOnDisk             contents;    ///< of the one that was read
  };

  /// Bytes that one generation takes on a mesh of @p n_cells, about; without
  /// the rows of the run, which are about 0.3 kB each.
  template <int dim>
  std::uint64_t checkpoint_size(const Fields<dim> &fields,
                                std::uint64_t      n_cells,
                                std::uint64_t      n_coarse_cells);
} // namespace MixedCracks

#endif
