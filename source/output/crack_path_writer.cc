// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/mpi.h>

#include <output/crack_path_writer.h>
#include <output/small_file.h>

namespace MixedCracks
{
  template <int dim>
  void
  CrackPathWriter<dim>::make_file(const double length_scale)
  {
    if (dim == 2 && dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      file = std::make_unique<CrackPathFile>(directory, 0.1 * length_scale);
  }



  template <int dim>
  void
  CrackPathWriter<dim>::open(const double length_scale)
  {
    make_file(length_scale);
    with_file(file, communicator, [&](auto &it) { it.open(); });
  }



  template <int dim>
  void
  CrackPathWriter<dim>::restore(const double       length_scale,
                                const std::string &earlier)
  {
    make_file(length_scale);
    with_file(file, communicator, [&](auto &it) { it.restore(earlier); });
  }



  template <int dim>
  void
  CrackPathWriter<dim>::add(const unsigned int        step,
                            const double              time,
                            const double              displacement,
                            const std::vector<Crack> &cracks)
  {
    with_file(file, communicator, [&](auto &it) {
      it.add(step, time, displacement, cracks);
    });
  }



  template <int dim>
  void
  CrackPathWriter<dim>::finish(const Outcome &outcome)
  {
    with_file(file, communicator, [&](auto &it) { it.finish(outcome); });
  }



  template class CrackPathWriter<2>;
  template class CrackPathWriter<3>;
} // namespace MixedCracks
