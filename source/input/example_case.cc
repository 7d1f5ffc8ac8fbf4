// SPDX-License-Identifier: GPL-2.0-or-later
// Examples: the cases that are installed with the program, copied to where the
// user is. What a case reads (a mesh, a map, a table, an included .prm) is any
// word of it, outside comments, that is the name of a file as seen from the
// case; it is copied along, and the copy of the case names it without folders.

#include <base/errors.h>
#include <base/names.h>
#include <base/text.h>
#include <base/version.h>

#include <input/example_case.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    namespace fs = std::filesystem;

    std::string
    content_of(const fs::path &path)
    {
      std::ifstream      file(path, std::ios::binary);
      std::ostringstream text;
      text << file.rdbuf();
      if (!file)
        throw FileError("example '" + path.string() + "' cannot be read.");
      return text.str();
    }



    // the first line that says something, without its '#' and what stands apart
    // behind it: a source
    std::string
    title_of(const fs::path &path)
    {
      std::istringstream lines(content_of(path));
      for (std::string line; std::getline(lines, line);)
      {
        const std::size_t begin = line.find_first_not_of("# ");
        if (begin != std::string::npos &&
            line.find("SPDX") == std::string::npos)
          return line.substr(begin, line.find("  ", begin) - begin);
      }
      return "";
    }



    // Names of the files to be written and what is to be in them.
    class Copies
    {
    public:
      void
      add_case(const fs::path &path)
      {
        std::istringstream lines(content_of(path));
        std::string        text;
        for (std::string line; std::getline(lines, line);)
          text += with_copies(line, path.parent_path()) + '\n';
        contents[path.filename().string()] = text;
      }

      // All of them or none.
      void
      write(const fs::path &folder) const
      {
        for (const auto &entry : contents)
          if (fs::exists(folder / entry.first))
            throw FileError("--example: '" + (folder / entry.first).string() +
                            "' is there already, and is left as it is.");
        std::vector<fs::path> written;
        for (const auto &[name, text] : contents)
        {
          written.push_back(folder / name);
          std::ofstream file(written.back(), std::ios::binary);
          if (!(file << text).flush())
          {
            std::error_code error;
            for (const fs::path &path : written)
              fs::remove(path, error);
            throw FileError("--example: '" + (folder / name).string() +
                            "' cannot be written.");
          }
        }
      }

      std::vector<std::string>
      names() const
      {
        std::vector<std::string> result;
        for (const auto &entry : contents)
          result.push_back(entry.first);
        return result;
      }

    private:
      // @p line with the base names of the files that it names
      std::string
      with_copies(const std::string &line, const fs::path &folder)
      {
        const std::string separators = " \t\"=;,()\\";
        const std::size_t end        = std::min(line.find('#'), line.size());
        std::string       result;
        std::size_t       at = 0;
        while (at < end)
        {
          const std::size_t begin =
            std::min(line.find_first_not_of(separators, at), end);
          const std::size_t next =
            std::min(line.find_first_of(separators, begin), end);
          result += line.substr(at, begin - at) +
                    copied(line.substr(begin, next - begin), folder);
          at = next;
        }
        return result + line.substr(end);
      }



      std::string
      copied(const std::string &word, const fs::path &folder)
      {
        std::error_code error;
        const fs::path  path = folder / word;
        if (word.find('.') == std::string::npos ||
            !fs::is_regular_file(path, error))
          return word;
        if (path.extension() == ".prm")
          add_case(path);
        else
          contents[path.filename().string()] = content_of(path);
        return path.filename().string();
      }

      std::map<std::string, std::string> contents;
    };
  } // namespace



  std::string
  example_folder()
  {
    std::error_code error;
    const fs::path  program = fs::read_symlink("/proc/self/exe", error);
    const fs::path  installed =
      program.parent_path() / MIXED_CRACKS_SHARE / "parameters";
    const fs::path sources = fs::path(MIXED_CRACKS_SOURCE) / "parameters";
    for (const fs::path &folder : {installed, sources})
      if (fs::is_directory(folder, error))
        return folder.lexically_normal().string();
    throw FileError("--example: there are no examples: neither '" +
                    installed.lexically_normal().string() + "' nor '" +
                    sources.string() + "' is a directory.");
  }



  std::vector<ExampleCase>
  example_cases(const std::string &folder)
  {
    std::vector<ExampleCase> result;
    for (const auto &entry : fs::recursive_directory_iterator(folder))
    {
      const fs::path &path = entry.path();
      if (path.extension() == ".prm")
        result.push_back(
          {path.lexically_relative(folder).replace_extension().string(),
           title_of(path),
           path.string()});
    }
    std::sort(result.begin(), result.end(), [](const auto &a, const auto &b) {
      return a.name < b.name;
    });
    return result;
  }



  std::string
  list_of_examples(const std::string &folder)
  {
    const std::vector<ExampleCase> cases = example_cases(folder);
    std::size_t                    width = 0;
    for (const ExampleCase &each : cases)
      width = std::max(width, each.name.size());
    std::string text;
    for (const ExampleCase &each : cases)
      text += each.name + std::string(width + 2 - each.name.size(), ' ') +
              each.title + '\n';
    return text;
  }



  std::string
  write_example(const std::string &folder,
                const std::string &name,
                const std::string &destination)
  {
    const std::vector<ExampleCase> cases = example_cases(folder);
    const auto                     found =
      std::find_if(cases.begin(), cases.end(), [&](const ExampleCase &each) {
        return each.name == name ||
               fs::path(each.name).filename().string() == name;
      });
    if (found == cases.end())
    {
      std::vector<std::string> names;
      for (const ExampleCase &each : cases)
        names.push_back(each.name);
      throw InputError("--example: " + unknown_name_message(name, names));
    }
    Copies copies;
    copies.add_case(found->path);
    copies.write(destination);
    std::string text = found->name + ": " + found->title + "\nwritten: ";
    text += join_names(copies.names(), ", ");
    return text + "\nrun it: mpirun -n 2 mixed-cracks " +
           fs::path(found->path).filename().string() + '\n';
  }
} // namespace MixedCracks
