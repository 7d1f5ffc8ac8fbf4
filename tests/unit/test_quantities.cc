// SPDX-License-Identifier: GPL-2.0-or-later
// The list of quantities, and what is made of it: columns, documentation.
#include <gtest/gtest.h>

#include <output/quantities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

using namespace MixedCracks;

namespace
{
  std::string
  header(const int dim, const std::vector<std::string> &asked = {})
  {
    std::string text;
    for (const Quantity &quantity : all_quantities())
      if (quantity.has_column(dim, asked))
        text += (text.empty() ? "" : ",") + quantity.column(dim);
    return text;
  }
} // namespace



// Scripts of users read columns by name, some of them by place.
TEST(Quantities, HaveTheColumnsOfStatistics)
{
  const std::string energies_to_imbalance =
    "elastic_energy_mJ,crack_energy_mJ,external_work_mJ,min_phase_field,"
    "max_phase_field_change,newton_iterations,linear_iterations,"
    "active_set_size,cells,dofs,wall_time_s,coupling_iterations,"
    "coupling_change,factorizations,rejected_steps,refinements,"
    "energy_imbalance_mJ,";
  EXPECT_EQ(header(2).find("step,time_s,displacement_mm,force_x_N,force_y_N," +
                           energies_to_imbalance + "crack_length_mm"),
            0u);
  EXPECT_EQ(header(3, {"Output/Crack volume"})
              .find("step,time_s,displacement_mm,force_x_N,force_y_N,"
                    "force_z_N," +
                    energies_to_imbalance + "crack_area_mm2,crack_volume_mm3"),
            0u);
}



// The page of results makes its words of the names of columns, see
// scripts/report_parts/quantities.py.
TEST(Quantities, HaveNamesOfTheirOwnAndKnownUnits)
{
  const std::set<std::string> units = {
    "", "mm", "mm2", "mm3", "N", "MPa", "mJ", "s"};
  std::set<std::string> names;
  for (const Quantity &quantity : all_quantities())
  {
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
    EXPECT_EQ(units.count(quantity.unit), 1u) << quantity.unit;
    EXPECT_FALSE(quantity.sentence.empty()) << quantity.name;
  }
}



TEST(Quantities, AreDocumentedAsTheListHasThem)
{
  std::ifstream      file(DOC_DIRECTORY "/output.md");
  std::ostringstream doc, table;
  doc << file.rdbuf();
  print_quantities(table);
  EXPECT_NE(doc.str().find('\n' + table.str() + '\n'), std::string::npos)
    << "The table of statistics.csv in doc/output.md shall be:\n"
    << table.str();
}



TEST(Quantities, OfARowAreFoundByName)
{
  StatisticsRow row, first;
  row["step"]             = 3.;
  row["force_x"]          = 3.;
  row["force_z"]          = 4.;
  row["external_work"]    = 12.;
  row["elastic_energy"]   = 7.;
  first["elastic_energy"] = 2.;
  EXPECT_EQ(row.step(), 3u);
  EXPECT_DOUBLE_EQ(row.force_size(), 5.);
  EXPECT_TRUE(std::isnan(row["crack_volume"]));
  EXPECT_THROW(row["energy_imbalance"], std::out_of_range);
  EXPECT_THROW(row["force"], std::out_of_range);
  const auto imbalance = std::find_if(
    all_quantities().begin(), all_quantities().end(), [](const auto &quantity) {
      return quantity.name == "energy_imbalance";
    });
  EXPECT_DOUBLE_EQ(value_of(*imbalance, row, first), 7.);
}
