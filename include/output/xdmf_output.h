// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_xdmf_output_h
#define mixed_cracks_output_xdmf_output_h

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/data_out.h>

#include <map>
#include <set>
#include <string>

namespace MixedCracks
{
  /// fields.xdmf for ParaView and fields/*.h5, one file for all ranks:
  /// fields_NNNNN.h5 for each step that is written, and mesh_NNNNN.h5 for
  /// each mesh, with the number of the first step that is written on it.
  /// Files get their names when they are whole.
  template <int dim>
  class XdmfOutput
  {
  public:
    /// @p directory: the output directory, with "fields" in it.
    XdmfOutput(const std::string &directory, const MPI_Comm communicator)
      : directory(directory)
      , communicator(communicator)
    {}

    /// Write the patches of @p data_out, of which a rank without cells has
    /// none (@p has_cells), and the list of all steps. Returns the
    /// name of the file below the directory. Throws FileError on all ranks.
    /// Collective.
    std::string write(const dealii::DataOut<dim> &data_out,
                      bool                        has_cells,
                      double                      time,
                      unsigned int                step);

    /// The mesh is another one from now on.
    void
    mesh_changed()
    {
      mesh_file.clear();
    }

    /// Continue the list of a resumed run with those of its steps that are
    /// in @p steps. Collective.
    void restore(const std::set<unsigned int> &steps);

  private:
    /// Whether the disk has room for the files. Collective.
    bool has_room(const dealii::DataOutBase::DataOutFilter &data,
                  bool                                      has_cells,
                  bool                                      new_mesh,
                  const std::string &solution_file) const;

    void write_hdf5(const dealii::DataOut<dim>               &data_out,
                    const dealii::DataOutBase::DataOutFilter &data,
                    bool                                      has_cells,
                    const std::string                        &solution_file);

    void write_list() const;

    const std::string directory;
    const MPI_Comm    communicator;
    std::string       mesh_file; ///< of the present mesh; empty: not written
    /// elements <Grid> of fields.xdmf by step, complete on rank 0
    std::map<unsigned int, std::string> grids;
  };

  /// Whether deal.II was built with HDF5.
  bool has_hdf5();
} // namespace MixedCracks

#endif
