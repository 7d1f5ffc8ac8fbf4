// SPDX-License-Identifier: GPL-2.0-or-later
#include <core/case_signature.h>
#include <core/errors.h>
#include <core/parameter_tree.h>

#include <fstream>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // FNV-1a, 64 bits, and the size; of the file as the first rank sees it
    std::string
    contents_of(const std::string &path, const MPI_Comm communicator)
    {
      std::string result;
      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::ifstream      file(path, std::ios::binary);
        unsigned long long sum = 14695981039346656037ULL, size = 0;
        for (char byte; file.get(byte); ++size)
          sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
        result =
          std::to_string(size) + " bytes, checksum " + std::to_string(sum);
      }
      return dealii::Utilities::MPI::broadcast(communicator, result);
    }
  } // namespace



  std::string
  case_signature(const dealii::ParameterHandler &prm,
                 const MPI_Comm                  communicator)
  {
    std::string       text;
    const std::string free_to_change[] = {
      "Load stepping", "Linear solver", "Output"};
    const ParameterTree tree(prm);
    for (const ParameterEntry &entry : tree.entries())
    {
      bool fixed = true;
      for (const std::string &subsection : free_to_change)
        fixed = fixed && entry.path.front() != subsection;
      // whose columns of statistics.csv go on
      fixed = fixed || entry.full_name() == "Output/Displacement at points";
      if (!fixed)
        continue;
      // what a file holds matters, not where it stands
      const bool is_file = entry.name == "File name" && !entry.value.empty();
      if (!is_file)
        text += entry.full_name() + " = " + entry.value + '\n';
      if (is_file)
        text += "contents of " + entry.full_name() + ": " +
                contents_of(entry.value, communicator) + '\n';
    }
    return text;
  }



  void
  require_same_case(const std::string &before, const std::string &now)
  {
    std::istringstream old_lines(before), new_lines(now);
    std::string        old_line, new_line;
    while (std::getline(new_lines, new_line))
    {
      std::getline(old_lines, old_line);
      if (old_line != new_line)
        throw InputError("--resume: the case has changed; the checkpoint was "
                         "written with '" +
                         old_line + "', found now '" + new_line +
                         "'. Allowed to change: entries of Load stepping, "
                         "Linear solver and Output, but for "
                         "Output/Displacement at points.");
    }
  }
} // namespace MixedCracks
