// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <input/parameter_file.h>
#include <input/parameter_manual.h>

// Boost's parser includes a header of Boost that it calls deprecated.
#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    struct Values
    {
      double                   radius = 4;
      double                   kappa  = 0.001;
      std::string              empty;
      std::string              law = "Wu";
      dealii::ParameterHandler prm;

      Values()
      {
        using namespace dealii::Patterns;
        prm.enter_subsection("Geometry");
        prm.enter_subsection("Punctured strip");
        prm.add_parameter("Hole radius",
                          radius,
                          "Radius of the hole, in mm; 0: no hole. " +
                            std::string(40, 'a') + " " + std::string(40, 'b') +
                            " ends with a backslash \\",
                          Double(0));
        prm.leave_subsection();
        prm.add_parameter("Note", empty, "Says \"hello\", _a_ * b < c.");
        prm.leave_subsection();
        prm.enter_subsection("Model");
        prm.add_parameter("Crack density", law, "", Selection("AT1|AT2|Wu"));
        prm.add_parameter("Young's \u03ba", kappa, "\u03ba.", Double(0, 1));
        prm.leave_subsection();
      }
    };

    std::string
    printed(const dealii::ParameterHandler &prm, const std::string &format)
    {
      std::ostringstream stream;
      print_parameters(stream, prm, format);
      return stream.str();
    }

    void
    expect(const std::string &text, const std::string &part)
    {
      EXPECT_NE(text.find(part), std::string::npos)
        << text << "\nexpected: " << part;
    }
  } // namespace

  TEST(ParameterManual, PrmCanBeReadAgain)
  {
    Values original;
    original.radius = 0; // only what goes through the handler is printed
    original.prm.enter_subsection("Geometry");
    original.prm.set("Note", "a = b, c");
    original.prm.enter_subsection("Punctured strip");
    original.prm.set("Hole radius", "2.50");
    original.prm.leave_subsection();
    original.prm.leave_subsection();
    const std::string text = printed(original.prm, "prm");

    const std::string file = testing::TempDir() + "mixed_cracks_manual_" +
                             std::to_string(getpid()) + ".prm";
    std::ofstream(file) << text;
    Values copy;
    read_parameters(file, {}, copy.prm, MPI_COMM_SELF);
    std::filesystem::remove(file);
    EXPECT_EQ(copy.radius, 2.5);
    EXPECT_EQ(copy.empty, "a = b, c");
    EXPECT_EQ(printed(copy.prm, "prm"), text);

    expect(text, "    set Hole radius = 2.50\n");
    expect(text, "# Allowed: a number, at least 0. Default: 4.");
    expect(text, "# Allowed: one of: AT1, AT2, Wu. Default: Wu.");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), 80U) << line;
  }

  TEST(ParameterManual, JsonIsJson)
  {
    std::istringstream          stream(printed(Values().prm, "json"));
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(stream, tree);
    ASSERT_EQ(tree.size(), 4U);
    const auto &first = tree.front().second;
    EXPECT_EQ(first.get<std::string>("full_name"),
              "Geometry/Punctured strip/Hole radius");
    EXPECT_EQ(first.get_child("subsections").size(), 2U);
    EXPECT_EQ(first.get<std::string>("name"), "Hole radius");
    EXPECT_EQ(first.get<std::string>("default_value"), "4");
    EXPECT_EQ(first.get<std::string>("allowed"), "a number, at least 0");
    const auto &last = tree.back().second;
    EXPECT_EQ(last.get<std::string>("name"), "Young's \u03ba");
    EXPECT_EQ(last.get<std::string>("documentation"), "\u03ba.");
  }

  TEST(ParameterManual, Markdown)
  {
    const std::string text = printed(Values().prm, "markdown");
    expect(text, "\n## Geometry/Punctured strip\n");
    expect(text, "\n### Hole radius\n");
    expect(text, "- Default: `4`\n- Allowed: a number, at least 0\n");
    expect(text, "\n## Geometry\n\n### Note\n");
    expect(text, "\\_a\\_ \\* b \\< c");
    expect(text, "- Default: empty\n");
  }

  TEST(ParameterManual, IsTheSameEveryTime)
  {
    for (const std::string &format : parameter_formats())
      EXPECT_EQ(printed(Values().prm, format), printed(Values().prm, format));
  }

  TEST(ParameterManual, RefusesOtherFormats)
  {
    for (const std::string format : {"", "xml", "PRM", "latex"})
      EXPECT_THROW(printed(Values().prm, format), InputError);
  }
} // namespace MixedCracks
