// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/errors.h>

#include <output/run_record.h>

#include <fstream>
#include <iomanip>

namespace MixedCracks
{
  namespace
  {
    // one member after the other, for reading and for writing alike
    template <typename Row, typename Action>
    void
    for_each_member(Row &row, const Action &action)
    {
      action(row.step);
      action(row.time);
      action(row.displacement);
      for (auto &component : row.force)
        action(component);
      action(row.elastic_energy);
      action(row.crack_energy);
      action(row.external_work);
      action(row.min_phase_field);
      action(row.phase_field_change);
      action(row.newton_iterations);
      action(row.linear_iterations);
      action(row.active_set_size);
      action(row.cells);
      action(row.dofs);
      action(row.wall_time);
      action(row.coupling_iterations);
      action(row.coupling_change);
      action(row.factorizations);
      action(row.rejected_steps);
      action(row.refinements);
      action(row.crack_volume);
      action(row.crack_surface);
    }
  } // namespace



  void
  write_record(std::ostream &out, const RunRecord &record)
  {
    out << std::setprecision(17) << std::quoted(record.signature) << '\n'
        << record.cell_size << ' ' << record.time << ' ' << record.time_step
        << ' ' << record.next_step << ' ' << record.peak_force << ' '
        << record.external_work << ' ' << record.peak_step << ' '
        << record.steps_to_wait << '\n'
        << record.nuclei.size() << '\n';
    for (const dealii::Point<2> &nucleus : record.nuclei)
      out << nucleus[0] << ' ' << nucleus[1] << '\n';
    out << record.rows.size() << '\n';
    for (const StatisticsRow &row : record.rows)
    {
      for_each_member(row, [&](const auto &value) { out << value << ' '; });
      out << row.point_displacements.size();
      for (const double displacement : row.point_displacements)
        out << ' ' << displacement;
      out << '\n';
    }
    out << record.field_files.size() << '\n';
    for (const auto &[time, name] : record.field_files)
      out << time << ' ' << std::quoted(name) << '\n';
    out << record.tables.size() << '\n';
    for (const auto &[name, text] : record.tables)
      out << std::quoted(name) << ' ' << std::quoted(text) << '\n';
  }



  RunRecord
  read_record(std::istream &in)
  {
    RunRecord   record;
    std::size_t n_nuclei = 0, n_rows = 0, n_files = 0, n_tables = 0;
    in >> std::quoted(record.signature) >> record.cell_size >> record.time >>
      record.time_step >> record.next_step >> record.peak_force >>
      record.external_work >> record.peak_step >> record.steps_to_wait >>
      n_nuclei;
    for (std::size_t i = 0; in && i < n_nuclei; ++i)
    {
      dealii::Point<2> nucleus;
      in >> nucleus[0] >> nucleus[1];
      record.nuclei.push_back(nucleus);
    }
    in >> n_rows;
    for (std::size_t i = 0; in && i < n_rows; ++i)
    {
      StatisticsRow row;
      for_each_member(row, [&](auto &value) { in >> value; });
      std::size_t n_displacements = 0;
      in >> n_displacements;
      for (std::size_t k = 0; in && k < n_displacements; ++k)
      {
        row.point_displacements.push_back(0.);
        in >> row.point_displacements.back();
      }
      record.rows.push_back(row);
    }
    in >> n_files;
    for (std::size_t i = 0; in && i < n_files; ++i)
    {
      std::pair<double, std::string> file;
      in >> file.first >> std::quoted(file.second);
      record.field_files.push_back(file);
    }
    in >> n_tables;
    for (std::size_t i = 0; in && i < n_tables; ++i)
    {
      std::string name;
      in >> std::quoted(name);
      in >> std::quoted(record.tables[name]);
    }
    if (!in)
      throw FileError("--resume: the checkpoint cannot be read.");
    return record;
  }



  unsigned long long
  file_checksum(const std::string &file_name)
  {
    std::ifstream      file(file_name, std::ios::binary);
    unsigned long long sum = 14695981039346656037ULL;
    if (!file)
      return 0;
    char buffer[65536];
    while (file.read(buffer, sizeof(buffer)) || file.gcount() > 0)
      for (std::streamsize i = 0; i < file.gcount(); ++i)
        sum = (sum ^ static_cast<unsigned char>(buffer[i])) * 1099511628211ULL;
    return sum;
  }
} // namespace MixedCracks
