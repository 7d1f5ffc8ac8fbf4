// SPDX-License-Identifier: GPL-2.0-or-later
#include <output/quantities.h>
#include <output/statistics_row.h>

#include <cmath>
#include <limits>
#include <map>

namespace MixedCracks
{
  namespace
  {
    std::size_t
    number_of(const std::string &name)
    {
      static const std::map<std::string, std::size_t> numbers = []() {
        std::map<std::string, std::size_t> result;
        for (const Quantity &quantity : all_quantities())
          if (quantity.is_kept())
            result[quantity.name] = &quantity - all_quantities().data();
        return result;
      }();
      return numbers.at(name);
    }
  } // namespace



  StatisticsRow::StatisticsRow()
  {
    for (const Quantity &quantity : all_quantities())
      values.push_back(
        quantity.entry.empty() ? 0. : std::numeric_limits<double>::quiet_NaN());
  }



  double &
  StatisticsRow::operator[](const std::string &name)
  {
    return values[number_of(name)];
  }



  double
  StatisticsRow::operator[](const std::string &name) const
  {
    return values[number_of(name)];
  }



  double
  StatisticsRow::force_size() const
  {
    const StatisticsRow &row = *this;
    return std::sqrt(row["force_x"] * row["force_x"] +
                     row["force_y"] * row["force_y"] +
                     row["force_z"] * row["force_z"]);
  }



  // (W - W_0) - (E - E_0) - (D - D_0), 0 in an evolution that balances energy.
  double
  StatisticsRow::energy_imbalance(const StatisticsRow &start) const
  {
    const auto growth = [&](const char *const name) {
      return (*this)[name] - start[name];
    };
    return growth("external_work") - growth("elastic_energy") -
           growth("crack_energy");
  }
} // namespace MixedCracks
