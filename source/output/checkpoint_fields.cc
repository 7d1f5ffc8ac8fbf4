// SPDX-License-Identifier: GPL-2.0-or-later
// The values of a state by cells, as deal.II attaches data to a mesh: for each
// cell K, in the order of p4est, behind 8 bytes for the file,
//
//   4 bytes of deal.II's, then for each vector of the state its values at the
//   dofs of K, as doubles: first vectors on elastic dofs, then those of phi.
//
// A value is there once for each cell that has it, 2 to 4 times in the plane;
// in return p4est distributes the cells over any number of ranks, and no
// numbering of dofs, which depends on that number, is kept.
//
// The checksum is sum_K FNV(values of K) modulo 2^64: a sum has no order, so
// that any number of ranks can form it from their cells, in writing, in reading
// back by blocks of the file, and in loading. It does not see two cells
// exchanged; the checksum of the file in record.txt does.

#include <base/checksum.h>
#include <base/errors.h>

#include <deal.II/base/mpi.h>

#include <deal.II/grid/cell_id.h>

#include <output/checkpoint_fields.h>
#include <output/disk.h>

#include <cstring>
#include <fstream>
#include <vector>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    using Values = Vector<double>;

    // before the values of all cells, and of each cell
    constexpr std::uint64_t header_bytes = 8, status_bytes = 4;

    template <int dim>
    char *
    append(
      const DoFHandler<dim>                            &dof_handler,
      const std::vector<const LinearAlgebra::Vector *> &vectors,
      const typename parallel::distributed::Triangulation<dim>::cell_iterator
           &triangulation_cell,
      char *out)
    {
      const typename DoFHandler<dim>::cell_iterator cell(*triangulation_cell,
                                                         &dof_handler);
      Values local(dof_handler.get_fe().n_dofs_per_cell());
      for (const LinearAlgebra::Vector *vector : vectors)
      {
        cell->get_dof_values(*vector, local);
        std::memcpy(out, local.data(), local.size() * sizeof(double));
        out += local.size() * sizeof(double);
      }
      return out;
    }



    // Only what this rank owns: an owned dof lies on an owned cell, or on
    // several, which then have the same value.
    template <int dim>
    const char *
    take(const DoFHandler<dim> &dof_handler,
         const IndexSet        &owned,
         const typename parallel::distributed::Triangulation<dim>::cell_iterator
                                            &triangulation_cell,
         const char                         *in,
         std::vector<LinearAlgebra::Vector> &vectors)
    {
      const typename DoFHandler<dim>::cell_iterator cell(*triangulation_cell,
                                                         &dof_handler);
      std::vector<types::global_dof_index>          dofs(
        dof_handler.get_fe().n_dofs_per_cell());
      cell->get_dof_indices(dofs);
      for (LinearAlgebra::Vector &vector : vectors)
        for (const types::global_dof_index dof : dofs)
        {
          double value;
          std::memcpy(&value, in, sizeof(value));
          in += sizeof(value);
          if (owned.is_element(dof))
            vector(dof) = value;
        }
      return in;
    }



    void
    spread(std::vector<LinearAlgebra::Vector>         &owned,
           const LinearAlgebra::Vector                &with_ghosts,
           const std::vector<LinearAlgebra::Vector *> &vectors)
    {
      for (std::size_t i = 0; i < vectors.size(); ++i)
      {
        owned[i].compress(VectorOperation::insert);
        *vectors[i] = with_ghosts;
        // constant, since a temporary would be moved and take the ghosts away
        const LinearAlgebra::Vector &values = owned[i];
        *vectors[i]                         = values;
      }
    }
  } // namespace



  template <int dim>
  std::uint64_t
  checkpoint_bytes_per_cell(const Fields<dim> &fields)
  {
    std::uint64_t n_values = 0;
    for (const StateVector &vector : state_vectors)
      n_values += (vector.dofs == StateDofs::elastic ? fields.elastic
                                                     : fields.phase_field)
                    .get_fe()
                    .n_dofs_per_cell();
    return sizeof(double) * n_values;
  }



  std::uint64_t
  size_of_values(const FieldsOnDisk &on_disk)
  {
    return header_bytes +
           on_disk.cells * (status_bytes + on_disk.bytes_per_cell);
  }



  template <int dim>
  std::vector<char>
  CheckpointFields<dim>::values(const State        &state,
                                const CellIterator &cell) const
  {
    std::vector<char> bytes(checkpoint_bytes_per_cell(fields));
    char             *out = append(fields.elastic,
                       vectors_on(StateDofs::elastic, state),
                       cell,
                       bytes.data());
    append(
      fields.phase_field, vectors_on(StateDofs::phase_field, state), cell, out);
    return bytes;
  }



  template <int dim>
  FieldsOnDisk
  CheckpointFields<dim>::save(const State       &state,
                              Triangulation     &triangulation,
                              const std::string &path) const
  {
    FieldsOnDisk written;
    written.cells          = triangulation.n_global_active_cells();
    written.bytes_per_cell = checkpoint_bytes_per_cell(fields);
    std::uint64_t sum      = 0;
    triangulation.register_data_attach(
      [&](const CellIterator &cell, const auto &) {
        std::vector<char> bytes = values(state, cell);
        sum += checksum(bytes.data(), bytes.data() + bytes.size());
        return bytes;
      },
      /*returns_variable_size_data=*/false);
    triangulation.save(path);
    written.sum = Utilities::MPI::sum(sum, fields.communicator());
    return written;
  }



  // deal.II gives the handle that reads to who registers the same data again,
  // as its SolutionTransfer::deserialize() does; nothing is packed by that.
  template <int dim>
  void
  CheckpointFields<dim>::load(const FieldsOnDisk &expected,
                              Triangulation      &triangulation,
                              State              &state) const
  {
    const auto elastic     = vectors_on(StateDofs::elastic, state);
    const auto phase_field = vectors_on(StateDofs::phase_field, state);
    std::vector<LinearAlgebra::Vector> on_elastic(
      elastic.size(), fields.owned_vector(fields.elastic_dofs));
    std::vector<LinearAlgebra::Vector> on_phase_field(
      phase_field.size(), fields.owned_vector(fields.phase_field_dofs));
    std::uint64_t sum = 0;

    const unsigned int handle = triangulation.register_data_attach(
      [&](const CellIterator &cell, const auto &) {
        return values(state, cell);
      },
      /*returns_variable_size_data=*/false);
    triangulation.notify_ready_to_unpack(
      handle, [&](const CellIterator &cell, const auto &, const auto &range) {
        const std::vector<char> bytes(range.begin(), range.end());
        if (bytes.size() != expected.bytes_per_cell)
          return;
        sum += checksum(bytes.data(), bytes.data() + bytes.size());
        const char *in = take(fields.elastic,
                              fields.elastic_dofs.owned,
                              cell,
                              bytes.data(),
                              on_elastic);
        take(fields.phase_field,
             fields.phase_field_dofs.owned,
             cell,
             in,
             on_phase_field);
      });
    if (Utilities::MPI::sum(sum, fields.communicator()) != expected.sum)
      throw FileError("the values of the fields are not those that were "
                      "written");
    spread(on_elastic, fields.ghosted_vector(fields.elastic_dofs), elastic);
    spread(on_phase_field,
           fields.ghosted_vector(fields.phase_field_dofs),
           phase_field);
  }



  FieldsOnDisk
  read_back(const std::string  &file_name,
            const FieldsOnDisk &expected,
            const MPI_Comm      communicator)
  {
    const std::uint64_t rank  = Utilities::MPI::this_mpi_process(communicator);
    const std::uint64_t n     = Utilities::MPI::n_mpi_processes(communicator);
    const std::uint64_t begin = expected.cells * rank / n;
    const std::uint64_t end   = expected.cells * (rank + 1) / n;
    const std::uint64_t block = status_bytes + expected.bytes_per_cell;
    std::ifstream       file(file_name, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(header_bytes + begin * block));
    std::vector<char> bytes(block);
    std::uint64_t     sum = 0, cells = 0;
    for (std::uint64_t cell = begin; cell < end; ++cell)
    {
      if (!file.read(bytes.data(), static_cast<std::streamsize>(block)))
        break;
      sum += checksum(bytes.data() + status_bytes, bytes.data() + block);
      ++cells;
    }
    FieldsOnDisk found = expected;
    found.sum          = Utilities::MPI::sum(sum, communicator);
    found.cells        = Utilities::MPI::sum(cells, communicator);
    return found;
  }



  template class CheckpointFields<2>;
  template class CheckpointFields<3>;
  template std::uint64_t checkpoint_bytes_per_cell(const Fields<2> &);
  template std::uint64_t checkpoint_bytes_per_cell(const Fields<3> &);
} // namespace MixedCracks
