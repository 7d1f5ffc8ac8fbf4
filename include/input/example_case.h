// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_input_example_case_h
#define mixed_cracks_input_example_case_h

#include <string>
#include <vector>

namespace MixedCracks
{
  /// A parameter file that comes with the program.
  struct ExampleCase
  {
    std::string name;  ///< "folder/case"
    std::string title; ///< the first line of its head
    std::string path;
  };

  /// Where the examples are: `share/mixed-cracks/parameters` beside the `bin`
  /// that this program is in, or, not installed, in the sources. Throws
  /// FileError when they are in neither.
  std::string example_folder();

  /// All .prm files below @p folder, in the order of their names.
  std::vector<ExampleCase> example_cases(const std::string &folder);

  /// The names with their titles, one a line.
  std::string list_of_examples(const std::string &folder);

  /// Copy an example into @p destination, with every file that it names beside
  /// it; the copy names that one. @p name: "folder/case", or "case", which is
  /// the first of that name. Returns a text on what has been written. Throws
  /// InputError for an unknown name, FileError where a file is there already or
  /// cannot be written; then nothing is left behind.
  std::string write_example(const std::string &folder,
                            const std::string &name,
                            const std::string &destination);
} // namespace MixedCracks

#endif
