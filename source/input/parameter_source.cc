// SPDX-License-Identifier: GPL-2.0-or-later
// The text of a .prm: read by one rank, and handed to all as statements that
// know their file and line. Comments begin with '#', a backslash at the end of
// a line goes on in the next one, "include FILE" stands for the statements of a
// file in the directory of the one that includes it. Files that include
// themselves, by whatever way, are refused.
//
// Errors are handed on as text with their kind, so that all ranks throw the
// same.

#include <base/errors.h>
#include <base/ranges.h>
#include <base/text.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <input/parameter_source.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    namespace fs = std::filesystem;
    using dealii::Utilities::trim;

    // Nobody writes that many parameters by hand; a mesh or a result file
    // given by mistake is not read to its end.
    constexpr std::size_t largest_file = 8U << 20U;

    std::string
    read_bytes(const fs::path &path)
    {
      const std::string what = "parameter file '" + path.string() + "'";
      std::error_code   error;
      if (fs::is_directory(path, error))
        throw FileError(what + " is a directory.");
      if (!fs::exists(path, error))
        throw FileError(what + " does not exist.");

      errno = 0;
      std::ifstream stream(path, std::ios::binary);
      if (!stream)
        throw FileError(what + " cannot be read: " + std::strerror(errno) +
                        ".");
      std::string bytes(largest_file + 1, '\0');
      stream.read(&bytes[0], static_cast<std::streamsize>(bytes.size()));
      if (stream.bad())
        throw FileError(what + " cannot be read.");
      bytes.resize(static_cast<std::size_t>(stream.gcount()));
      return bytes;
    }

    // Refuses what is no text. Bytes above 127 are left alone: a comment may
    // be in any language and encoding.
    std::string
    read_text(const fs::path &path)
    {
      std::string       text = read_bytes(path);
      const std::string what = "parameter file '" + path.string() + "'";
      if (text.size() > largest_file)
        throw InputError(what + " has more than 8 MB; that is no parameter "
                                "file.");
      if (any_of(text, [](const unsigned char c) {
            return (c < 32 && std::isspace(c) == 0) || c == 127;
          }))
        throw InputError(what + " is not a text file: it holds bytes that no "
                                "text has.");
      if (starts_with(text, "\xEF\xBB\xBF")) // byte order mark
        text.erase(0, 3);
      if (all_of(text,
                 [](const unsigned char c) { return std::isspace(c) != 0; }))
        throw InputError(what + " is empty.");
      return text;
    }

    // Split into statements. A comment ends with its line, whatever its last
    // character, and does not end a statement that goes on behind it.
    std::vector<SourceLine>
    statements(const std::string &text, const std::string &file)
    {
      std::vector<SourceLine> lines;
      std::istringstream      stream(text);
      std::string             line;
      bool                    continued = false;
      for (unsigned int number = 1; std::getline(stream, line); ++number)
      {
        const std::size_t comment = line.find('#');
        line                      = trim(line.substr(0, comment));
        if (line.empty() && comment != std::string::npos)
          continue;
        const bool goes_on = !line.empty() && line.back() == '\\';
        if (goes_on)
          line = trim(line.substr(0, line.size() - 1));
        if (continued)
          lines.back().text += (line.empty() ? "" : " ") + line;
        else if (!line.empty() || goes_on)
          lines.push_back({file, number, line});
        continued = goes_on;
      }
      if (continued)
        throw InputError(lines.back().place() +
                         ": the last line ends with a backslash, so "
                         "something should follow.");
      return lines;
    }

    // The file name of an include statement, otherwise empty.
    std::string
    included_file(const SourceLine &line)
    {
      std::istringstream stream(line.text);
      std::string        keyword, name;
      stream >> keyword >> std::ws;
      std::getline(stream, name);
      if (keyword != "include" && keyword != "INCLUDE")
        return "";
      if (name.empty())
        throw InputError(line.place() +
                         ": expected 'include FILE', found no file name.");
      return name;
    }

    void
    append_file(const fs::path          &path,
                std::vector<fs::path>    including,
                std::vector<SourceLine> &lines)
    {
      including.push_back(fs::weakly_canonical(path));
      for (const SourceLine &line : statements(read_text(path), path.string()))
      {
        const std::string name = included_file(line);
        if (name.empty())
        {
          lines.push_back(line);
          continue;
        }
        const fs::path other = (path.parent_path() / name).lexically_normal();
        if (contains(including, fs::weakly_canonical(other)))
          throw InputError(line.place() + ": '" + name + "' includes itself.");
        if (!fs::exists(other))
          throw FileError(line.place() + ": the included file '" +
                          other.string() + "' does not exist.");
        append_file(other, including, lines);
      }
    }

    // What rank 0 tells the others: how it went, then either the message or
    // three strings for each line.
    std::vector<std::string>
    packed_source(const std::string &file_name)
    {
      try
      {
        std::vector<SourceLine> lines;
        append_file(file_name, {}, lines);
        std::vector<std::string> packed{"good"};
        for (const SourceLine &line : lines)
          packed.insert(packed.end(),
                        {line.file, std::to_string(line.number), line.text});
        return packed;
      }
      catch (const InputError &error)
      {
        return {"input error", error.what()};
      }
      catch (const std::exception &error)
      {
        return {"file error", error.what()};
      }
    }
  } // namespace



  std::string
  SourceLine::place() const
  {
    return file + ":" + std::to_string(number);
  }



  std::vector<SourceLine>
  read_source(const std::string &file_name, const MPI_Comm comm)
  {
    std::vector<std::string> packed;
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      packed = packed_source(file_name);
    packed = dealii::Utilities::MPI::broadcast(comm, packed, 0);

    if (packed.at(0) == "input error")
      throw InputError(packed.at(1));
    if (packed.at(0) == "file error")
      throw FileError(packed.at(1));
    std::vector<SourceLine> lines;
    for (std::size_t i = 1; i + 2 < packed.size(); i += 3)
      lines.push_back({packed[i],
                       static_cast<unsigned int>(std::stoul(packed[i + 1])),
                       packed[i + 2]});
    return lines;
  }
} // namespace MixedCracks
