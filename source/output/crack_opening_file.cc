// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/mpi.h>

#include <output/crack_opening_file.h>
#include <output/directory.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    std::string
    header(const int dim)
    {
      return std::string("step,time_s,line,position_mm,x_mm,y_mm,") +
             (dim == 3 ? "z_mm," : "") + "opening_mm\n";
    }
  } // namespace



  template <int dim>
  CrackOpeningFile<dim>::CrackOpeningFile(
    const std::string                   &directory,
    const std::vector<OpeningLine<dim>> &lines,
    const MPI_Comm                       communicator)
    : name(directory + "/crack_opening.csv")
    , lines(lines)
    , communicator(communicator)
  {}



  template <int dim>
  void
  CrackOpeningFile<dim>::write(const std::string &content,
                               const bool         append) const
  {
    if (lines.empty())
      return;
    std::string message;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      std::ofstream file(name, append ? std::ios::app : std::ios::trunc);
      file << content << std::flush;
      if (!file)
        message = "Output/Directory: '" + name +
                  "' cannot be written; is the disk full?";
    }
    throw_on_all_ranks(message, communicator);
  }



  template <int dim>
  void
  CrackOpeningFile<dim>::open() const
  {
    write(header(dim), /*append=*/false);
  }



  template <int dim>
  void
  CrackOpeningFile<dim>::restore(const unsigned int last_step) const
  {
    std::string   kept = header(dim), line;
    std::ifstream file(name);
    std::getline(file, line);
    const auto n_commas = std::count(kept.begin(), kept.end(), ',');
    while (std::getline(file, line))
      // one that was cut off is of a later step, too
      if (std::count(line.begin(), line.end(), ',') == n_commas &&
          std::strtoul(line.c_str(), nullptr, 10) <= last_step)
        kept += line + '\n';
    file.close();
    // nobody writes before all have read
    MPI_Barrier(communicator);
    write(kept, /*append=*/false);
  }



  template <int dim>
  void
  CrackOpeningFile<dim>::add(const unsigned int         step,
                             const double               time,
                             const std::vector<double> &openings) const
  {
    std::ostringstream out;
    out << std::setprecision(10);
    std::size_t number = 0;
    for (std::size_t l = 0; l < lines.size(); ++l)
      for (unsigned int i = 0; i < lines[l].n_positions; ++i, ++number)
      {
        const dealii::Point<dim> position = lines[l].position(i);
        out << step << ',' << time << ',' << l << ','
            << position.distance(lines[l].begin);
        for (unsigned int d = 0; d < dim; ++d)
          out << ',' << position[d];
        out << ',' << openings[number] << '\n';
      }
    write(out.str(), /*append=*/true);
  }



  template class CrackOpeningFile<2>;
  template class CrackOpeningFile<3>;
} // namespace MixedCracks
