// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>
#include <base/finite_text.h>

#include <deal.II/base/mpi.h>

#include <output/statistics.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    std::string
    header(const int dim)
    {
      return std::string("step,time_s,displacement_mm,force_x_N,force_y_N,") +
             (dim == 3 ? "force_z_N," : "") +
             "elastic_energy_mJ,crack_energy_mJ,external_work_mJ,"
             "min_phase_field,max_phase_field_change,newton_iterations,"
             "linear_iterations,active_set_size,cells,dofs,wall_time_s,"
             "coupling_iterations,coupling_change,factorizations,"
             "rejected_steps,refinements,energy_imbalance_mJ," +
             crack_surface_name(dim);
    }



    std::string
    line(const StatisticsRow &row,
         const StatisticsRow &first,
         const int            dim,
         const bool           with_crack_volume,
         const std::size_t    n_point_columns)
    {
      std::ostringstream out;
      out.imbue(csv_locale());
      out << std::setprecision(10) << row.step << ',' << row.time << ','
          << row.displacement;
      for (int d = 0; d < dim; ++d)
        out << ',' << row.force[d];
      out << ',' << row.elastic_energy << ',' << row.crack_energy << ','
          << row.external_work << ',' << row.min_phase_field << ','
          << row.phase_field_change << ',' << row.newton_iterations << ','
          << row.linear_iterations << ',' << row.active_set_size << ','
          << row.cells << ',' << row.dofs << ',' << std::setprecision(4)
          << row.wall_time << ',' << row.coupling_iterations << ','
          << row.coupling_change << ',' << row.factorizations << ','
          << row.rejected_steps << ',' << row.refinements << ','
          << std::setprecision(10) << row.energy_imbalance(first) << ','
          << row.crack_surface;
      // what was asked for later only is empty in the rows before
      if (with_crack_volume)
        out << ',';
      if (with_crack_volume && !std::isnan(row.crack_volume))
        out << row.crack_volume;
      for (std::size_t i = 0; i < n_point_columns; ++i)
      {
        out << ',';
        if (i < row.point_displacements.size())
          out << row.point_displacements[i];
      }
      out << '\n';
      return out.str();
    }
  } // namespace



  double
  StatisticsRow::force_size() const
  {
    return std::sqrt(force[0] * force[0] + force[1] * force[1] +
                     force[2] * force[2]);
  }



  double
  StatisticsRow::energy_imbalance(const StatisticsRow &start) const
  {
    return external_work - start.external_work -
           (elastic_energy - start.elastic_energy) -
           (crack_energy - start.crack_energy);
  }



  std::string
  crack_surface_name(const int dim)
  {
    return dim == 2 ? "crack_length_mm" : "crack_area_mm2";
  }



  StatisticsTable::StatisticsTable(const MPI_Comm communicator)
    : communicator(communicator)
  {}



  void
  StatisticsTable::open(const std::string              &file_name,
                        const int                       dimension,
                        const bool                      crack_volume,
                        const std::vector<std::string> &point_columns)
  {
    dim               = dimension;
    with_crack_volume = crack_volume;
    n_point_columns   = point_columns.size();
    name              = file_name;
    std::string message;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      file.open(name);
      file << header(dim) << (with_crack_volume ? ",crack_volume_mm3" : "");
      for (const std::string &column : point_columns)
        file << ',' << csv_field(column);
      file << '\n' << std::flush;
      if (!file)
        message = "Output/Directory: '" + name + "' cannot be written.";
    }
    throw_on_all_ranks(message, communicator);
  }



  void
  StatisticsTable::restore(const std::vector<StatisticsRow> &earlier)
  {
    for (const StatisticsRow &row : earlier)
      add(row);
  }



  void
  StatisticsTable::add(const StatisticsRow &row)
  {
    table.push_back(row);
    std::string message;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      file << line(row, table.front(), dim, with_crack_volume, n_point_columns)
           << std::flush;
      if (!file)
        message = "Output/Directory: '" + name +
                  "' cannot be written any more; is the disk full?";
    }
    throw_on_all_ranks(message, communicator);
  }
} // namespace MixedCracks
