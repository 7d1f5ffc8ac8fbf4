// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>
#include <base/finite_text.h>

#include <deal.II/base/mpi.h>

#include <output/crack_opening_file.h>
#include <output/small_file.h>

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
      message = append ? append_to_file(name, content)
                       : replace_small_file(name, content);
    throw_on_all_ranks(message, communicator);
  }



  template <int dim>
  void
  CrackOpeningFile<dim>::open()
  {
    restore("");
  }



  // The table is written from the rows of the checkpoint, not continued: rows
  // of steps behind it, which will be computed again, must not stay.
  template <int dim>
  void
  CrackOpeningFile<dim>::restore(const std::string &earlier)
  {
    all_rows = earlier.empty() && !lines.empty() ? header(dim) : earlier;
    write(all_rows, /*append=*/false);
  }



  template <int dim>
  void
  CrackOpeningFile<dim>::add(const unsigned int         step,
                             const double               time,
                             const std::vector<double> &openings)
  {
    std::ostringstream out;
    out.imbue(csv_locale());
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
    // for checkpoints, of which the first rank knows
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      all_rows += out.str();
    write(out.str(), /*append=*/true);
  }



  template class CrackOpeningFile<2>;
  template class CrackOpeningFile<3>;
} // namespace MixedCracks
