// SPDX-License-Identifier: GPL-2.0-or-later
// A directory that a test has for itself, and what its files hold.
#ifndef mixed_cracks_tests_unit_files_of_test_h
#define mixed_cracks_tests_unit_files_of_test_h

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace MixedCracks
{
  namespace Testing
  {
    /// Made before each test, removed after it.
    class FilesOfTest : public ::testing::Test
    {
    protected:
      /// @p name: of the kind of test; each process has its own.
      explicit FilesOfTest(const std::string &name)
        : directory((std::filesystem::temp_directory_path() /
                     (name + "_" + std::to_string(getpid())))
                      .string())
      {}

      void
      SetUp() override
      {
        std::filesystem::create_directories(directory);
      }

      void
      TearDown() override
      {
        std::filesystem::remove_all(directory);
      }

      std::string
      content(const std::string &name) const
      {
        std::ifstream      in(directory + '/' + name);
        std::ostringstream out;
        out << in.rdbuf();
        return out.str();
      }

      /// How often @p word is in a file.
      unsigned int
      count(const std::string &name, const std::string &word) const
      {
        const std::string text = content(name);
        unsigned int      n    = 0;
        for (std::size_t at = text.find(word); at != std::string::npos;
             at             = text.find(word, at + 1))
          ++n;
        return n;
      }

      const std::string directory;
    };
  } // namespace Testing
} // namespace MixedCracks

#endif
