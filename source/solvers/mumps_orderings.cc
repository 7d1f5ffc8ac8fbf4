// SPDX-License-Identifier: GPL-2.0-or-later
// Orderings of MUMPS by name. METIS is that of MUMPS, where it was built with
// it, or ours.

#include <solvers/mumps.h>
#include <solvers/mumps_orderings.h>

#include <utility>

namespace MixedCracks
{
  namespace
  {
    // with the numbers of the manual, ICNTL(7) and INFOG(7)
    const std::vector<std::pair<std::string, int>> all_orderings = {
      {"automatic", 7},
      {"METIS", 5},
      {"SCOTCH", 3},
      {"PORD", 4},
      {"AMD", 0},
      {"AMF", 2},
      {"QAMD", 6}};
  } // namespace



  std::vector<std::string>
  Mumps::orderings()
  {
    std::vector<std::string> result;
    for (const auto &[name, number] : all_orderings)
      result.push_back(name);
    return result;
  }



  int
  mumps_number_of(const std::string &ordering)
  {
    for (const auto &[name, number] : all_orderings)
      if (name == ordering)
        return number;
    return all_orderings.front().second;
  }



  std::string
  mumps_ordering_of(const int number)
  {
    if (number == mumps_given_ordering)
      return "METIS";
    for (const auto &[name, its_number] : all_orderings)
      if (its_number == number)
        return name;
    return "number " + std::to_string(number);
  }
} // namespace MixedCracks
