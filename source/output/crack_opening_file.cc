// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/finite_text.h>

#include <output/crack_opening_file.h>

#include <iomanip>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    std::string
    header_of_openings(const int dim)
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
    : RestoredTable(directory + "/crack_opening.csv",
                    lines.empty() ? "" : header_of_openings(dim),
                    communicator)
    , lines(lines)
  {}



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
    RestoredTable::add(out.str());
  }



  template class CrackOpeningFile<2>;
  template class CrackOpeningFile<3>;
} // namespace MixedCracks
