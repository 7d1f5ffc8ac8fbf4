// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_statistics_row_h
#define mixed_cracks_output_statistics_row_h

#include <string>
#include <vector>

namespace MixedCracks
{
  /// The quantities of an accepted step, by their names in all_quantities().
  class StatisticsRow
  {
  public:
    /// All 0, but unknown (NaN) what only an entry of the .prm asks for.
    StatisticsRow();

    /// Of a quantity that is kept. Throws std::out_of_range for another name.
    double &operator[](const std::string &name);
    double  operator[](const std::string &name) const;

    unsigned int
    step() const
    {
      return static_cast<unsigned int>((*this)["step"]);
    }

    /// Length of the force vector, N.
    double force_size() const;

    /// External work since @p start less the growth of stored and crack
    /// energy, mJ: what a crack that runs sets free, what a lagged phase field
    /// holds back, and what a pressure law without an energy hides.
    double energy_imbalance(const StatisticsRow &start) const;

    /// In the order of all_quantities(), 0 for those that are not kept.
    std::vector<double> values;
    /// mm; components in turn; empty where not asked for
    std::vector<double> point_displacements;
    /// at points with prescribed displacement, N; component after component
    std::vector<double> reactions;
  };
} // namespace MixedCracks

#endif
