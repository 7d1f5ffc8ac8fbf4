// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_checkpoint_fields_h
#define mixed_cracks_output_checkpoint_fields_h

#include <deal.II/distributed/tria.h>

#include <discretization/fields.h>
#include <discretization/state.h>

#include <cstdint>
#include <string>

namespace MixedCracks
{
  /// What belongs to a checkpoint and can be told apart from nonsense: the
  /// same whatever the number of ranks.
  struct FieldsOnDisk
  {
    std::uint64_t cells          = 0; ///< of all ranks
    std::uint64_t bytes_per_cell = 0; ///< of values
    /// of the checksums of the values of the cells, modulo 2^64
    std::uint64_t sum = 0;
  };

  /// The vectors of a state as deal.II keeps data of cells in a file beside
  /// the mesh: "mesh_fixed.data" holds two numbers of 4 bytes and then, for
  /// each cell, 4 bytes and the values at its degrees of freedom.
  template <int dim>
  class CheckpointFields
  {
  public:
    using Triangulation = dealii::parallel::distributed::Triangulation<dim>;

    explicit CheckpointFields(const Fields<dim> &fields)
      : fields(fields)
    {}

    /// Save the mesh as @p path, and the vectors of @p state with it. Whether
    /// the disk has room for them is to be known before: what fails here ends
    /// the program. Collective.
    FieldsOnDisk save(const State       &state,
                      Triangulation     &triangulation,
                      const std::string &path) const;

    /// The vectors, after Triangulation::load() and the distribution of the
    /// degrees of freedom. Throws FileError when they are others than
    /// @p expected. Collective.
    void load(const FieldsOnDisk &expected,
              Triangulation      &triangulation,
              State              &state) const;

  private:
    using CellIterator = typename Triangulation::cell_iterator;

    std::vector<char> values(const State        &state,
                             const CellIterator &cell) const;

    const Fields<dim> &fields;
  };

  /// Bytes per cell of the values of a state.
  template <int dim>
  std::uint64_t checkpoint_bytes_per_cell(const Fields<dim> &fields);

  /// Size of the file of the values, in bytes.
  std::uint64_t size_of_values(const FieldsOnDisk &on_disk);

  /// What the file of the values really holds, read from the disk by all
  /// ranks, each a part. Collective.
  FieldsOnDisk read_back(const std::string  &file,
                         const FieldsOnDisk &expected,
                         MPI_Comm            communicator);
} // namespace MixedCracks

#endif
