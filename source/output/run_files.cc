// SPDX-License-Identifier: GPL-2.0-or-later
// The list of what a run has written. Invariant: a file of a run is in the list
// before it exists. A crash in between leaves a name without a file, which does
// no harm; the other order would leave a file that no later run dares to
// remove. Removing goes the other way: the list itself last.
//
// The list is appended to, one name per line. A last line without an end is
// what a crash has left: not a name when read, cut off before more is appended.
// It is not fsynced: names that a power failure takes away make files foreign,
// and a foreign file is never removed.
//
// A list can be edited, and names in it are removed: those that are absolute or
// have '..' do not count; of a link the link is removed and not what it leads
// to, and folders only when they are empty.

#include <base/ranges.h>

#include <output/checkpoint_seal.h>
#include <output/disk.h>
#include <output/run_files.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

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
      return !name.empty() && path.is_relative() && !contains(path, "..");
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

    // A line that was cut off when a run was killed would make one name with
    // what is added.
    void
    remove_cut_line(const std::string &path)
    {
      const std::string text = contents_of_file(path);
      std::error_code   error;
      if (!text.empty() && text.back() != '\n')
        fs::resize_file(path, text.rfind('\n') + 1, error);
    }

    bool
    append(const std::string &directory, const std::string &text)
    {
      if (text.empty())
        return true;
      const std::string path = (fs::path(directory) / run_files_name).string();
      remove_cut_line(path);
      std::ofstream file(path, std::ios::app);
      return static_cast<bool>(file << text << std::flush);
    }

    // of names those that are not in the list
    std::string
    new_lines(const std::string              &directory,
              const std::vector<std::string> &names)
    {
      const auto listed = lines_of(fs::path(directory) / run_files_name);
      std::set<std::string> known(listed.begin(), listed.end());
      std::string           text;
      for (const std::string &name : names)
        if (known.insert(name).second)
          text += name + '\n';
      return text;
    }

    // The first format of a seal named the files: "3\nmesh 123\n...".
    void
    add_generation(const fs::path           &directory,
                   const std::string        &generation,
                   std::vector<std::string> &names)
    {
      for (const std::string &name : files_of_generation())
        names.push_back(generation + name);
      if (read_seal((directory / generation).string()).format == 1)
        for (const std::string &line :
             lines_of(directory / generation / "seal.txt"))
        {
          const std::string name = line.substr(0, line.find(' '));
          if (name.find('/') == std::string::npos)
            names.push_back(generation + name);
        }
      names.push_back(generation);
    }

    // A checkpoint is that of a run when a list names its folder, or a seal
    // shows it: a generation without one has been cut off while it was
    // written, and the seal of the other one speaks for it. Otherwise somebody
    // else has files with these names.
    void
    add_checkpoints(const fs::path &directory, std::vector<std::string> &names)
    {
      const std::set<std::string> listed(names.begin(), names.end());
      bool                        is_sealed = false;
      for (const char *const generation : generations)
        is_sealed =
          is_sealed || read_seal((directory / generation).string()).format > 0;
      for (const char *const generation : generations)
        if (fs::is_directory(directory / generation) &&
            (is_sealed || listed.count("checkpoint/") > 0 ||
             listed.count(generation) > 0))
          add_generation(directory, generation, names);
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



  const std::vector<std::string> &
  files_of_generation()
  {
    static const std::vector<std::string> names = [] {
      std::vector<std::string> all{"seal.txt", "record.txt"};
      append(all, names_of_libraries());
      // and what is left of one that was being written
      for (const char *const left : {"seal.txt.part",
                                     "record.txt.part",
                                     "record.txt.reserved",
                                     "mesh.reserved",
                                     "mesh_fixed.data.reserved"})
        all.emplace_back(left);
      return all;
    }();
    return names;
  }



  std::vector<std::string>
  checkpoint_files()
  {
    std::vector<std::string> names;
    for (const std::string generation : generations)
      for (const std::string &name : files_of_generation())
        names.push_back(generation + name);
    return names;
  }



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
    const bool               is_new = !has_run_files(directory);
    std::vector<std::string> of_runs;
    if (is_new)
      of_runs = recorded;
    for (const std::string &name : names)
      if (!is_there(fs::path(directory) / name))
        of_runs.push_back(name);
    if (append(directory,
               (is_new ? first_line : "") + new_lines(directory, of_runs)))
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
    return append(directory, new_lines(directory, names));
  }



  std::vector<std::string>
  numbered_files(const std::string &directory)
  {
    std::vector<std::string> names;
    add_fitting(directory,
                "fields/",
                "fields_[0-9]{5,}(\\.[0-9]+)?\\.p?vtu|"
                "(fields|mesh)_[0-9]{5,}\\.h5(\\.part)?|"
                "crack_surface_[0-9]{5,}\\.vtp",
                names);
    for (const std::string name : {"crack_path", "crack_sheet", "crack_front"})
      add_fitting(directory, name + '/', name + "_[0-9]{6,}\\.vtp", names);
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
