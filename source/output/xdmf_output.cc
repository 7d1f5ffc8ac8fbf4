// SPDX-License-Identifier: GPL-2.0-or-later
// XDMF: a list in XML, and the numbers in HDF5,
//
//   fields.xdmf   Grid "steps", a temporal collection of
//                   Grid "mesh": Time, Geometry and Topology in mesh_NNNNN.h5,
//                                Attribute ... in fields_NNNNN.h5
//                   ...
//
// Each cell has its own 2^dim nodes: values that are constant in cells jump
// there and can be kept as nodal ones, with one number of nodes for all fields.
// Size 8 bytes x 2^dim x cells x components; the mesh, 8 dim + 4 bytes per
// node, only when it has changed.
//
// One file is written by all ranks that have cells, collectively: a rank that
// gave up on a full disk would leave the others in a deadlock. Hence room for
// the sum over the ranks is looked for first, files are written as *.part, all
// ranks say whether they have succeeded, and only then rank 0 renames.
// fields.xdmf comes last.

#include <base/errors.h>
#include <base/log.h>

#include <output/disk.h>
#include <output/run_files.h>
#include <output/small_file.h>
#include <output/xdmf_output.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#ifdef DEAL_II_WITH_HDF5
#  include <hdf5.h>
#endif

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    const std::string grid_begin = "<Grid Name=\"mesh\"";
    const std::string grid_end   = "</Grid>\n";

    std::string
    failure(const std::string &directory)
    {
      return "Output/Directory: the fields cannot be written in '" + directory +
             "/fields'; is the disk full?";
    }



    std::string
    data_item(const std::string      &reference,
              const std::string      &type,
              const unsigned long int rows,
              const unsigned int      columns)
    {
      return format("<DataItem Dimensions=\"%lu %u\" NumberType=\"%s\" "
                    "Format=\"HDF\">%s</DataItem>",
                    rows,
                    columns,
                    type.c_str(),
                    reference.c_str());
    }

    template <int dim>
    std::string
    grid_text(const DataOutBase::DataOutFilter &data,
              const std::string                &mesh_file,
              const std::string                &solution_file,
              const double                      time,
              const unsigned long int           n_nodes,
              const unsigned long int           n_cells)
    {
      const std::string number = "Float\" Precision=\"8";
      std::string       text =
        grid_begin + " GridType=\"Uniform\">\n" +
        format("<Time Value=\"%.17g\"/>\n", time) +
        format("<Geometry GeometryType=\"%s\">", dim == 2 ? "XY" : "XYZ") +
        data_item(mesh_file + ":/nodes", number, n_nodes, dim) +
        "</Geometry>\n" +
        format("<Topology TopologyType=\"%s\" NumberOfElements=\"%lu\">",
               dim == 2 ? "Quadrilateral" : "Hexahedron",
               n_cells) +
        data_item(mesh_file + ":/cells",
                  "UInt",
                  n_cells,
                  GeometryInfo<dim>::vertices_per_cell) +
        "</Topology>\n";
      for (unsigned int i = 0; i < data.n_data_sets(); ++i)
      {
        const std::string  name       = data.get_data_set_name(i);
        const unsigned int components = data.get_data_set_dim(i);
        text +=
          format("<Attribute Name=\"%s\" AttributeType=\"%s\" "
                 "Center=\"Node\">",
                 name.c_str(),
                 components > 1 ? "Vector" : "Scalar") +
          data_item(solution_file + ":/" + name, number, n_nodes, components) +
          "</Attribute>\n";
      }
      return text + grid_end;
    }

    // The number in "...<Attribute ...>fields/fields_00012.h5:/...", or -1.
    int
    step_of_grid(const std::string &text)
    {
      const std::string mark = "fields/fields_";
      const auto        at   = text.find(mark);
      return at == std::string::npos
               ? -1
               : std::atoi(text.c_str() + at + mark.size());
    }

    // Write and rename; whether that worked.
    bool
    write_whole(const std::string &path, const std::string &text)
    {
      {
        std::ofstream file(path + ".part");
        file << text << std::flush;
        if (!file)
          return false;
      }
      std::error_code error;
      std::filesystem::rename(path + ".part", path, error);
      return !error;
    }
  } // namespace



  bool
  has_hdf5()
  {
#ifdef DEAL_II_WITH_HDF5
    return true;
#else
    return false;
#endif
  }



  template <int dim>
  bool
  XdmfOutput<dim>::has_room(const DataOutBase::DataOutFilter &data,
                            const bool                        has_cells,
                            const bool                        new_mesh,
                            const std::string &solution_file) const
  {
    std::uint64_t numbers = 0, mesh = 0;
    if (has_cells)
    {
      for (unsigned int i = 0; i < data.n_data_sets(); ++i)
        numbers += std::uint64_t(data.n_nodes()) * data.get_data_set_dim(i);
      mesh = std::uint64_t(data.n_nodes()) * dim * 8 +
             std::uint64_t(data.n_cells()) *
               GeometryInfo<dim>::vertices_per_cell * 4;
    }
    // of descriptions and alignment
    const std::uint64_t          margin = 65536;
    const std::vector<SizedFile> files  = {
       {directory + "/" + solution_file + ".part",
        Utilities::MPI::sum(8 * numbers, communicator) + margin},
       {directory + "/" + mesh_file + ".part",
       new_mesh ? Utilities::MPI::sum(mesh, communicator) + margin : 0}};
    const bool has_room = Utilities::MPI::this_mpi_process(communicator) > 0 ||
                          missing_space_for(files).empty();
    return Utilities::MPI::min(has_room ? 1 : 0, communicator) == 1;
  }



  template <int dim>
  void
  XdmfOutput<dim>::write_hdf5(const DataOut<dim>               &data_out,
                              const DataOutBase::DataOutFilter &data,
                              const bool                        has_cells,
                              const std::string                &solution_file)
  {
#ifdef DEAL_II_WITH_HDF5
    // what fails is said by an exception
    H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
#endif
    // ranks without cells know no names of data and cannot take part
    MPI_Comm writers;
    MPI_Comm_split(
      communicator,
      has_cells ? 0 : MPI_UNDEFINED,
      static_cast<int>(Utilities::MPI::this_mpi_process(communicator)),
      &writers);
    const bool new_mesh = mesh_file.empty();
    if (new_mesh)
      mesh_file =
        "fields/mesh" + solution_file.substr(std::strlen("fields/fields"));
    // on a full disk some ranks stop, which is a deadlock for the others
    int failures = has_room(data, has_cells, new_mesh, solution_file) ? 0 : 1;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      std::vector<std::string> names = {solution_file, solution_file + ".part"};
      if (new_mesh)
        names.insert(names.end(), {mesh_file, mesh_file + ".part"});
      if (!note_run_files(directory, names))
        failures = 1;
    }
    failures = Utilities::MPI::max(failures, communicator);
    if (has_cells && failures == 0)
    {
      try
      {
        data_out.write_hdf5_parallel(data,
                                     new_mesh,
                                     directory + "/" + mesh_file + ".part",
                                     directory + "/" + solution_file + ".part",
                                     writers);
      }
      catch (const std::exception &)
      {
        failures = 1;
      }
    }
    if (has_cells)
      MPI_Comm_free(&writers);
    // any rank may be the one that failed, and the last to close the file
    failures = Utilities::MPI::max(failures, communicator);
    if (failures == 0 && Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      std::error_code error;
      for (const std::string &name : {solution_file, mesh_file})
        if (!error && (name == solution_file || new_mesh))
          std::filesystem::rename(
            directory + "/" + name + ".part", directory + "/" + name, error);
      failures = error ? 1 : 0;
    }
    if (Utilities::MPI::max(failures, communicator) > 0)
      throw FileError(failure(directory));
  }



  template <int dim>
  std::string
  XdmfOutput<dim>::write(const DataOut<dim> &data_out,
                         const bool          has_cells,
                         const double        time,
                         const unsigned int  step)
  {
    // cell data differ at a vertex between its cells: keep its copies apart
    DataOutBase::DataOutFilter data(
      DataOutBase::DataOutFilterFlags(/*filter_duplicate_vertices=*/false,
                                      /*xdmf_hdf5_output=*/true));
    if (has_cells)
      data_out.write_filtered_data(data);
    const std::string solution_file = format("fields/fields_%05u.h5", step);
    write_hdf5(data_out, data, has_cells, solution_file);

    const unsigned long int n_nodes = Utilities::MPI::sum<unsigned long int>(
      has_cells ? data.n_nodes() : 0, communicator);
    const unsigned long int n_cells = Utilities::MPI::sum<unsigned long int>(
      has_cells ? data.n_cells() : 0, communicator);
    // the first rank with cells knows the names of the data
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int knowing = Utilities::MPI::min(
      has_cells ? Utilities::MPI::this_mpi_process(communicator) : n_ranks,
      communicator);
    const std::string text =
      grid_text<dim>(data, mesh_file, solution_file, time, n_nodes, n_cells);
    grids[step] = Utilities::MPI::broadcast(communicator, text, knowing);
    write_list();
    return solution_file;
  }



  template <int dim>
  void
  XdmfOutput<dim>::write_list() const
  {
    on_first_rank(communicator, [&]() {
      std::string text = "<?xml version=\"1.0\"?>\n"
                         "<Xdmf Version=\"2.0\">\n<Domain>\n"
                         "<Grid Name=\"steps\" GridType=\"Collection\" "
                         "CollectionType=\"Temporal\">\n";
      for (const auto &grid : grids)
        text += grid.second;
      text += "</Grid>\n</Domain>\n</Xdmf>\n";
      if (!write_whole(directory + "/fields.xdmf", text))
        throw FileError(failure(directory));
    });
  }



  template <int dim>
  void
  XdmfOutput<dim>::restore(const std::set<unsigned int> &steps)
  {
    if (Utilities::MPI::this_mpi_process(communicator) > 0)
      return;
    std::ifstream     file(directory + "/fields.xdmf");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    for (auto begin = text.find(grid_begin); begin != std::string::npos;)
    {
      const auto end = text.find(grid_end, begin);
      if (end == std::string::npos)
        return;
      const std::string grid =
        text.substr(begin, end + grid_end.size() - begin);
      const int step = step_of_grid(grid);
      if (step >= 0 && steps.count(static_cast<unsigned int>(step)) > 0)
        grids[static_cast<unsigned int>(step)] = grid;
      begin = text.find(grid_begin, end);
    }
  }



  template class XdmfOutput<2>;
  template class XdmfOutput<3>;
} // namespace MixedCracks
