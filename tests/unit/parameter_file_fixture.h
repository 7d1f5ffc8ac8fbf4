// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_tests_parameter_file_fixture_h
#define mixed_cracks_tests_parameter_file_fixture_h

#include <base/errors.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <input/parameter_file.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace MixedCracks
{
  // What the rooms of the program declare, in small.
  struct DeclaredValues
  {
    std::string         title   = "none";
    std::string         name    = "rectangle";
    double              radius  = 4;
    int                 levels  = 2;
    double              kappa   = 0.001;
    double              modulus = 7.2;
    bool                mixed   = true;
    std::string         cracks;
    std::vector<double> center = {12, 18};

    dealii::ParameterHandler prm;

    DeclaredValues()
    {
      using namespace dealii::Patterns;
      prm.add_parameter("Title", title, "One line.");
      prm.enter_subsection("Geometry");
      prm.add_parameter("Name",
                        name,
                        "The domain.",
                        Selection("rectangle|slit square|punctured strip"));
      prm.enter_subsection("Punctured strip");
      prm.add_parameter("Hole radius", radius, "In mm.", Double(0));
      prm.add_parameter("Hole center", center, "In mm.", List(Double(), 2, 2));
      prm.leave_subsection();
      prm.leave_subsection();
      prm.enter_subsection("Mesh");
      prm.add_parameter("Global refinements", levels, "", Integer(0, 10));
      prm.leave_subsection();
      prm.enter_subsection("Model");
      prm.add_parameter("Residual stiffness", kappa, "", Double(0, 1));
      prm.add_parameter("Young's modulus", modulus, "", Double(0));
      prm.add_parameter("Mixed", mixed, "");
      prm.add_parameter("Cracks", cracks, "");
      prm.add_action("Cracks", [](const std::string &value) {
        if (value == "refused")
          throw InputError("Model/Cracks: refused by its owner.");
      });
      prm.leave_subsection();
    }
  };

  // A directory of this test and this process.
  class ParameterFileFixture : public testing::Test
  {
  protected:
    ParameterFileFixture()
      : directory(std::filesystem::path(testing::TempDir()) /
                  ("mixed_cracks_" + std::to_string(getpid())))
    {
      std::filesystem::create_directories(directory);
    }

    ~ParameterFileFixture() override
    {
      std::filesystem::remove_all(directory);
    }

    std::string
    write(const std::string &text, const std::string &name = "case.prm") const
    {
      const std::filesystem::path path = directory / name;
      std::filesystem::create_directories(path.parent_path());
      std::ofstream(path, std::ios::binary) << text;
      return path.string();
    }

    void
    read(const std::string              &text,
         const std::vector<std::string> &overrides = {})
    {
      read_parameters(write(text), overrides, values.prm, MPI_COMM_SELF);
    }

    // The message of an InputError, without the name of the directory.
    std::string
    message_for(const std::string              &text,
                const std::vector<std::string> &overrides = {})
    {
      try
      {
        DeclaredValues fresh;
        read_parameters(write(text), overrides, fresh.prm, MPI_COMM_SELF);
      }
      catch (const InputError &error)
      {
        return without_directory(error.what());
      }
      return "accepted";
    }

    std::string
    without_directory(std::string message) const
    {
      const std::string prefix = directory.string() + "/";
      for (std::size_t at = message.find(prefix); at != std::string::npos;
           at             = message.find(prefix))
        message.erase(at, prefix.size());
      return message;
    }

    void
    expect(const std::string              &text,
           const std::vector<std::string> &parts,
           const std::vector<std::string> &overrides = {})
    {
      const std::string message = message_for(text, overrides);
      for (const std::string &part : parts)
        EXPECT_NE(message.find(part), std::string::npos)
          << text << "\n-> " << message << "\nexpected: " << part;
      EXPECT_EQ(message.find("Exception"), std::string::npos) << message;
    }

    std::filesystem::path directory;
    DeclaredValues        values;
  };
} // namespace MixedCracks

#endif
