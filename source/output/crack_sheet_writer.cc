// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/mpi.h>

#include <output/crack_sheet_writer.h>
#include <output/front_opening.h>
#include <output/small_file.h>

namespace MixedCracks
{
  using namespace dealii;



  template <int dim>
  void
  CrackSheetWriter<dim>::make_file(const double length)
  {
    length_scale = length;
    if (dim == 3 &&
        Utilities::MPI::this_mpi_process(fields.communicator()) == 0)
      file = std::make_unique<CrackSheetFile>(directory, 0.1 * length);
  }



  template <int dim>
  void
  CrackSheetWriter<dim>::open(const double length)
  {
    make_file(length);
    with_file(file, fields.communicator(), [&](auto &it) { it.open(); });
  }



  template <int dim>
  void
  CrackSheetWriter<dim>::restore(const double       length,
                                 const std::string &sheets,
                                 const std::string &fronts)
  {
    make_file(length);
    with_file(file, fields.communicator(), [&](auto &it) {
      it.restore(sheets, fronts);
    });
  }



  template <int dim>
  void
  CrackSheetWriter<dim>::add(const unsigned int             step,
                             const double                   time,
                             const double                   displacement,
                             const std::vector<CrackSheet> &sheets,
                             const LinearAlgebra::Vector   &elastic)
  {
    if constexpr (dim == 3)
    {
      const int is_new = file && file->differs(sheets) ? 1 : 0;
      if (Utilities::MPI::max(is_new, fields.communicator()) > 0)
      {
        const std::vector<double> angles =
          opening_angles(fields, elastic, sheets, length_scale);
        std::vector<FrontRow> rows =
          MixedCracks::front_rows(sheets, earlier_fronts, time - earlier_time);
        for (std::size_t i = 0; i < rows.size(); ++i)
          rows[i].opening_angle = angles[i];
        with_file(file, fields.communicator(), [&](auto &it) {
          it.add(step, time, displacement, sheets, rows);
        });
      }
      remember(time, sheets);
    }
    else
      (void)step, (void)time, (void)displacement, (void)sheets, (void)elastic;
  }



  template <int dim>
  void
  CrackSheetWriter<dim>::finish(const Outcome &outcome)
  {
    with_file(
      file, fields.communicator(), [&](auto &it) { it.finish(outcome); });
  }



  template class CrackSheetWriter<2>;
  template class CrackSheetWriter<3>;
} // namespace MixedCracks
