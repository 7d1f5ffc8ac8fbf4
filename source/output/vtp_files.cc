// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/finite_text.h>

#include <output/run_files.h>
#include <output/small_file.h>
#include <output/vtp_files.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace MixedCracks
{
  namespace
  {
    const std::string end_of_file = "</VTKFile>\n";
  }



  std::string
  vtp_name(const std::string &folder, const unsigned int step)
  {
    char buffer[20];
    std::snprintf(buffer, sizeof(buffer), "_%06u.vtp", step);
    return folder + '/' + folder + buffer;
  }



  std::string
  vtp_array(const std::string &attributes, const std::string &content)
  {
    return "<DataArray " + attributes + " format=\"ascii\">\n" + content +
           "\n</DataArray>\n";
  }



  bool
  is_whole_vtp(const std::string &file_name)
  {
    std::ifstream     file(file_name, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    return text.size() >= end_of_file.size() &&
           text.compare(text.size() - end_of_file.size(),
                        end_of_file.size(),
                        end_of_file) == 0;
  }



  void
  write_vtp_file(const std::string &directory,
                 const std::string &name,
                 const std::string &content)
  {
    const std::string path = directory + '/' + name;
    std::error_code   ignored; // writing fails then
    std::filesystem::create_directories(
      std::filesystem::path(path).parent_path(), ignored);
    if (!note_run_files(directory, {name}))
      throw cannot_be_written(path);
    std::ofstream file(path);
    if (!(file << content << std::flush))
      throw cannot_be_written(path);
  }



  std::string
  list_of_vtp(
    const std::string                                  &folder,
    const std::vector<std::pair<unsigned int, double>> &steps_and_times)
  {
    std::string content = "<?xml version=\"1.0\"?>\n"
                          "<VTKFile type=\"Collection\" version=\"0.1\" "
                          "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const auto &[step, time] : steps_and_times)
      content += "<DataSet timestep=\"" + csv_number(time) +
                 "\" group=\"\" part=\"0\" file=\"" + vtp_name(folder, step) +
                 "\"/>\n";
    return content + "</Collection>\n" + end_of_file;
  }
} // namespace MixedCracks
