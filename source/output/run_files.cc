// SPDX-License-Identifier: GPL-2.0-or-later
#include <output/run_files.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace MixedCracks
{
  namespace fs = std::filesystem;

  const char *const run_files_name = "run_files.txt";

  namespace
  {
    const std::string first_line =
      "# written by a run of mixed-cracks; --overwrite removes these files and "
      "no others\n";

    const char *const generations[] = {"checkpoint/generation-0/",
                                       "checkpoint/generation-1/"};

    bool
    is_folder(const std::string &name)
    {
      return !name.empty() && name.back() == '/';
    }

    bool
    is_there(const fs::path &path)
    {
      std::error_code error; // a link to nothing is something, too
      return fs::symlink_status(path, error).type() !=
               fs::file_type::not_found &&
             !error;
    }

    // A list may have been edited: never leave the directory.
    bool
    stays_inside(const std::string &name)
    {
      const fs::path path(name);
      return !name.empty() && path.is_relative() &&
             std::find(path.begin(), path.end(), "..") == path.end();
    }

    std::vector<std::string>
    lines_of(const fs::path &path)
    {
      std::vector<std::string> lines;
      std::ifstream            file(path);
      for (std::string line; std::getline(file, line);)
        // the last one may have been cut
        if (!file.eof() && stays_inside(line) && line.front() != '#')
          lines.push_back(line);
      return lines;
    }

    bool
    append(const std::string &directory, const std::string &text)
    {
      std::ofstream file(fs::path(directory) / run_files_name, std::ios::app);
      file << text << std::flush;
      return static_cast<bool>(file);
    }

    // The seal of a checkpoint names its files: "3\nmesh 123\n...". What a
    // checkpoint without one may hold has been cut off while it was written.
    void
    add_checkpoints(const fs::path &directory, std::vector<std::string> &names)
    {
      for (const std::string generation : generations)
      {
        const fs::path folder = directory / generation;
        if (!fs::is_directory(folder))
          continue;
        for (const char *name : {"seal.txt",
                                 "record.txt",
                                 "mesh",
                                 "mesh.info",
                                 "mesh_fixed.data",
                                 "mesh_variable.data"})
          names.push_back(generation + name);
        for (const std::string &line : lines_of(folder / "seal.txt"))
        {
          const std::string name = line.substr(0, line.find(' '));
          if (name.find('/') == std::string::npos)
            names.push_back(generation + name);
        }
        names.push_back(generation);
      }
    }

    // files in one folder whose names fit
    void
    add_fitting(const fs::path           &directory,
                const std::string        &folder,
                const std::string        &pattern,
                std::vector<std::string> &names)
    {
      std::error_code  error;
      const std::regex fitting(pattern);
      for (const auto &entry :
           fs::directory_iterator(directory / folder, error))
        if (std::regex_match(entry.path().filename().string(), fitting))
          names.push_back(folder + entry.path().filename().string());
    }

    void
    add_files_without_list(const std::string        &directory,
                           std::vector<std::string> &names)
    {
      for (const char *name : {"statistics.csv", "log.txt", "parameters.prm"})
        if (!is_there(fs::path(directory) / name))
          return;
      for (const char *name : {"log.txt",
                               "statistics.csv",
                               "fields.pvd",
                               "fields.xdmf",
                               "parameters.prm",
                               "summary.json",
                               "crack_opening.csv",
                               "crack_path.csv",
                               "crack_path.pvd",
                               "crack_surface.pvd",
                               "checkpoint/"})
        names.push_back(name);
      for (const std::string &name : numbered_files(directory))
        names.push_back(name);
      for (const char *name : {"fields/", "crack_path/"})
        names.push_back(name);
    }
  } // namespace



  bool
  has_run_files(const std::string &directory)
  {
    std::ifstream file(fs::path(directory) / run_files_name);
    std::string   line;
    return std::getline(file, line) && line + '\n' == first_line;
  }



  bool
  begin_run_files(const std::string              &directory,
                  const std::vector<std::string> &recorded,
                  const std::vector<std::string> &names)
  {
    const bool  is_new = !has_run_files(directory);
    std::string text   = is_new ? first_line : "";
    if (is_new)
      for (const std::string &name : recorded)
        text += name + '\n';
    for (const std::string &name : names)
      if (!is_there(fs::path(directory) / name))
        text += name + '\n';
    if (append(directory, text))
      return true;
    std::error_code error; // a list that is cut off would pass for another's
    if (is_new)
      fs::remove(fs::path(directory) / run_files_name, error);
    return false;
  }



  bool
  note_run_files(const std::string              &directory,
                 const std::vector<std::string> &names)
  {
    if (!has_run_files(directory))
      return true;
    std::string text;
    for (const std::string &name : names)
      text += name + '\n';
    return append(directory, text);
  }



  std::vector<std::string>
  numbered_files(const std::string &directory)
  {
    std::vector<std::string> names;
    add_fitting(directory,
                "fields/",
                "fields_[0-9]{5}(\\.[0-9]+)?\\.p?vtu|"
                "(fields|mesh)_[0-9]{5}\\.h5(\\.part)?|"
                "crack_surface_[0-9]{5}\\.vtp",
                names);
    add_fitting(directory, "crack_path/", "crack_path_[0-9]{6}\\.vtp", names);
    return names;
  }



  std::vector<std::string>
  files_of_runs(const std::string &directory)
  {
    std::vector<std::string> names;
    if (has_run_files(directory))
      names = lines_of(fs::path(directory) / run_files_name);
    else
      add_files_without_list(directory, names);
    add_checkpoints(directory, names);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
  }



  void
  remove_run_files(const std::string              &directory,
                   const std::vector<std::string> &names)
  {
    std::vector<std::string> folders;
    for (const std::string &name : names)
      if (is_folder(name))
        folders.push_back(name);
      else if (!fs::is_directory(
                 fs::symlink_status(fs::path(directory) / name)))
        fs::remove(fs::path(directory) / name);
    // those within others first
    std::sort(folders.rbegin(), folders.rend());
    for (const std::string &folder : folders)
    {
      std::error_code error; // not empty: something else is in it
      const fs::path  path =
        fs::path(directory) / folder.substr(0, folder.size() - 1);
      if (fs::symlink_status(path, error).type() == fs::file_type::directory)
        fs::remove(path, error);
    }
    if (has_run_files(directory))
      fs::remove(fs::path(directory) / run_files_name);
  }
} // namespace MixedCracks
