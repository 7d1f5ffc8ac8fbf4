// SPDX-License-Identifier: GPL-2.0-or-later
// The list behind every name in a .prm, and its messages.
#include <base/names.h>
#include <base/registry.h>

#include <model/crack_density.h>
#include <model/energy_split.h>
#include <model/pressure_law.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

using namespace MixedCracks;

namespace
{
  struct Shape
  {
    std::string name;
    int         n_corners;
  };

  const Registry<Shape, int>
    shapes("shape",
           {{"slit square",
             "a square with a slit",
             [](int n) {
               return std::make_unique<Shape>(Shape{"square", n});
             }},
            {"rectangle", "any rectangle", [](int n) {
               return std::make_unique<Shape>(Shape{"rectangle", n});
             }}});

  template <typename List>
  void
  expect_is_well_formed(const List &list)
  {
    const auto names = list.names();
    EXPECT_FALSE(names.empty());
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(),
              names.size());
    for (const std::string &name : names)
    {
      EXPECT_FALSE(name.empty());
      // these would break the selection pattern or a line of a .prm
      EXPECT_EQ(name.find_first_of("|#;\n"), std::string::npos) << name;
      EXPECT_NE(list.documentation().find("'" + name + "': "),
                std::string::npos);
    }
  }
} // namespace



TEST(Names, NearestForgivesCaseBlanksAndTypos)
{
  const std::vector<std::string> names = {"AT1", "Wu", "relaxed bulk"};
  EXPECT_EQ(nearest_name("wu", names), "Wu");
  EXPECT_EQ(nearest_name(" Wu ", names), "Wu");
  EXPECT_EQ(nearest_name("AT3", names), "AT1");
  EXPECT_EQ(nearest_name("relaxd bulk", names), "relaxed bulk");
  EXPECT_EQ(nearest_name("relaxed_bulk", names), "relaxed bulk");
}



TEST(Names, NothingIsSuggestedForSomethingElse)
{
  EXPECT_EQ(nearest_name("spectral", {"AT1", "Wu"}), "");
  EXPECT_EQ(nearest_name("anything", {}), "");
}



TEST(Names, MessageNamesWhatWasFoundAndWhatIsAllowed)
{
  const std::string close = unknown_name_message("AT4", {"AT1", "Wu"});
  EXPECT_NE(close.find("'AT4'"), std::string::npos);
  EXPECT_NE(close.find("did you mean 'AT1'?"), std::string::npos);
  EXPECT_NE(close.find("AT1, Wu"), std::string::npos);
  const std::string far = unknown_name_message("spectral", {"AT1", "Wu"});
  EXPECT_EQ(far.find("did you mean"), std::string::npos);
  EXPECT_NE(far.find("AT1, Wu"), std::string::npos);
}



TEST(Names, JoinedWithTheirSeparator)
{
  EXPECT_EQ(join_names({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(join_names({"a", "b"}, "|"), "a|b");
  EXPECT_EQ(join_names({}), "");
}



TEST(Registry, MakesByNameAndPassesTheArguments)
{
  const auto shape = shapes.make("rectangle", 4);
  EXPECT_EQ(shape->name, "rectangle");
  EXPECT_EQ(shape->n_corners, 4);
  EXPECT_EQ(shapes.make("slit square", 5)->name, "square");
}



TEST(Registry, UnknownNameIsAnInputErrorWithTheNearest)
{
  try
  {
    shapes.make("slit sqare", 4);
    FAIL() << "an unknown name was accepted";
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("shape"), std::string::npos);
    EXPECT_NE(message.find("'slit sqare'"), std::string::npos);
    EXPECT_NE(message.find("'slit square'"), std::string::npos);
    EXPECT_NE(message.find("rectangle"), std::string::npos);
  }
  // a name is not matched by its beginning or in another case
  EXPECT_THROW(shapes.make("Rectangle", 4), InputError);
  EXPECT_THROW(shapes.make("rect", 4), InputError);
  EXPECT_THROW(shapes.make("", 4), InputError);
}



TEST(Registry, ListsItsNamesForPatternAndManual)
{
  EXPECT_EQ(shapes.selection(), "slit square|rectangle");
  EXPECT_EQ(shapes.documentation(),
            "'slit square': a square with a slit. "
            "'rectangle': any rectangle.");
}



TEST(Registry, ListsOfTheModelAreWellFormed)
{
  expect_is_well_formed(all_crack_densities());
  expect_is_well_formed(all_energy_splits<2>());
  expect_is_well_formed(all_energy_splits<3>());
  expect_is_well_formed(all_pressure_laws());
  EXPECT_EQ(all_energy_splits<2>().names(), all_energy_splits<3>().names());
}
