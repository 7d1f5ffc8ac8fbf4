// SPDX-License-Identifier: GPL-2.0-or-later
// With t the thickness (1 in 3-d), the sum over the rows of a boundary
//
//   t sum_q traction_q area_q
//
// is the integral of the stress of the elements over it. The force of
// Output/Watched boundaries is that of the nodes, which balances the loads
// exactly; the two differ by the error of the stress.

#include <base/finite_text.h>

#include <deal.II/base/mpi.h>

#include <output/traction_profiles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // position, normal, traction, area of a point
    template <int dim>
    using TractionNumbers = std::array<double, 3 * dim + 1>;



    template <int dim>
    std::string
    header_of_tractions()
    {
      std::string result = "step,time_s,boundary";
      for (const auto &[name, unit] :
           {std::make_pair("", "_mm"), std::make_pair("traction_", "_MPa")})
        for (unsigned int d = 0; d < dim; ++d)
          result += std::string(",") + name + "xyz"[d] + unit;
      return result + ",area_mm2\n";
    }



    template <int dim>
    std::vector<double>
    flat(const std::vector<TractionPoint<dim>> &points)
    {
      std::vector<double> result;
      for (const TractionPoint<dim> &point : points)
      {
        for (unsigned int d = 0; d < dim; ++d)
          result.push_back(point.position[d]);
        for (const Tensor<1, dim> &vector : {point.normal, point.traction})
          for (unsigned int d = 0; d < dim; ++d)
            result.push_back(vector[d]);
        result.push_back(point.area);
      }
      return result;
    }



    // By coordinates without their rounding, at one place (on a slit) by the
    // normal.
    template <int dim>
    void
    order_by_place(std::vector<TractionNumbers<dim>> &points)
    {
      constexpr double rounding = 1e-9;
      double           size     = 1e-300;
      for (const auto &point : points)
        for (unsigned int d = 0; d < dim; ++d)
          size = std::max(size, std::abs(point[d]));
      const auto key = [&](const TractionNumbers<dim> &point) {
        std::array<double, 2 * dim> result;
        for (unsigned int d = 0; d < dim; ++d)
        {
          result[d]       = std::round(point[d] / (rounding * size));
          result[dim + d] = std::round(point[dim + d] / rounding);
        }
        return result;
      };
      std::sort(points.begin(),
                points.end(),
                [&](const auto &a, const auto &b) { return key(a) < key(b); });
    }



    // of all ranks, on the first
    template <int dim>
    std::vector<TractionNumbers<dim>>
    gathered(const std::vector<TractionPoint<dim>> &points,
             const MPI_Comm                         communicator)
    {
      std::vector<TractionNumbers<dim>> result;
      for (const std::vector<double> &part :
           Utilities::MPI::gather(communicator, flat(points)))
        for (std::size_t i = 0; i < part.size(); i += 3 * dim + 1)
        {
          result.emplace_back();
          std::copy_n(part.begin() + i, 3 * dim + 1, result.back().begin());
        }
      order_by_place<dim>(result);
      return result;
    }
  } // namespace



  template <int dim>
  TractionProfiles<dim>::TractionProfiles(const std::string     &directory,
                                          TractionProfileOptions options,
                                          const MPI_Comm         communicator)
    : RestoredTable(directory + "/traction_profiles.csv",
                    options.boundaries.empty() ? ""
                                               : header_of_tractions<dim>(),
                    communicator)
    , options(std::move(options))
  {}



  template <int dim>
  void
  TractionProfiles<dim>::add(const unsigned int    step,
                             const State          &state,
                             const Assembler<dim> &assembler)
  {
    if (options.boundaries.empty() || step % options.every != 0)
      return;
    std::ostringstream out;
    out.imbue(csv_locale());
    out << std::setprecision(10);
    for (const auto &[boundary, ids] : options.boundaries)
      for (const auto &point : gathered<dim>(
             assembler.tractions(ids, state.elastic, state.lagged_phase_field),
             communicator))
      {
        out << step << ',' << state.time << ',' << csv_field(boundary);
        for (unsigned int d = 0; d < dim; ++d)
          out << ',' << point[d];
        for (unsigned int d = 0; d < dim; ++d)
          out << ',' << point[2 * dim + d];
        out << ',' << options.thickness * point[3 * dim] << '\n';
      }
    RestoredTable::add(out.str());
  }



  template class TractionProfiles<2>;
  template class TractionProfiles<3>;
} // namespace MixedCracks
