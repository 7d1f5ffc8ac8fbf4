// SPDX-License-Identifier: GPL-2.0-or-later
// Two files make a generation whole or not. Each names size and FNV-1a checksum
// of what was written before it,
//
//   seal.txt    title with the number of the format; number, step;
//      |        size and checksum of record.txt
//   record.txt  title; size and checksum of each file below, sum of the values;
//      |        what was seen of damage; then the RunRecord
//   mesh, mesh.info, mesh_fixed.data
//
// so that one chain of comparisons from the top finds any byte that has changed
// but those of the seal, whose first line and number have to be readable. They
// are written from the bottom up: a seal means that everything it vouches for
// was read back before.
//
// Format = 6 + 1000 (n - 25), n the number of quantities that rows have: with a
// new quantity old checkpoints have rows without it, and are refused by number
// rather than by a failure to parse.

#include <base/checksum.h>
#include <base/errors.h>

#include <output/checkpoint_seal.h>
#include <output/disk.h>
#include <output/quantities.h>
#include <output/text_archive.h>

#include <algorithm>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // that of all files but the rows, which had so many quantities then
    constexpr unsigned int format_of_files = 6;
    constexpr unsigned int n_quantities    = 25;

    const std::string seal_name   = "/seal.txt";
    const std::string record_name = "/record.txt";
    const std::string values_name = "mesh_fixed.data";

    // the words of the first line, before the number
    const std::string title = "mixed-cracks checkpoint, format";

    std::string
    first_line()
    {
      return title + ' ' + std::to_string(checkpoint_format()) + '\n';
    }



    // 0 for something else
    unsigned int
    read_title(std::istream &in)
    {
      std::istringstream expected(title);
      std::string        word, found;
      while (expected >> word)
        if (!(in >> found) || found != word)
          return 0;
      unsigned int format = 0;
      return in >> format ? format : 0;
    }



    // the first format began with the step and went on with names
    bool
    is_seal_without_format(std::istream &in)
    {
      unsigned int      step = 0;
      std::string       name;
      unsigned long int sum = 0;
      return in >> step >> name >> sum && name == "mesh";
    }



    void
    require(const bool condition, const std::string &what)
    {
      if (!condition)
        throw FileError(what);
    }



    FileOnDisk
    described(const std::string &path, const std::string &name)
    {
      FileOnDisk file;
      file.name     = name;
      file.size     = static_cast<std::uint64_t>(size_of_file(path));
      file.checksum = file_checksum(path);
      return file;
    }



    void
    require_as_written(const std::string &directory, const FileOnDisk &file)
    {
      const std::string  path = directory + '/' + file.name;
      const std::int64_t size = size_of_file(path);
      require(size >= 0, "'" + file.name + "' is missing");
      require(static_cast<std::uint64_t>(size) == file.size,
              "'" + file.name + "' has " + std::to_string(size) +
                " bytes, and " + std::to_string(file.size) + " were written");
      require(file_checksum(path) == file.checksum,
              "'" + file.name + "' is not what was written");
    }
  } // namespace



  MIXED_CRACKS_MEMBERS(FileOnDisk, name, size, checksum)

  MIXED_CRACKS_MEMBERS(FieldsOnDisk, cells, bytes_per_cell, sum)

  MIXED_CRACKS_MEMBERS(DamageOrigins,
                       reach,
                       known,
                       initial,
                       nuclei,
                       initial_has_grown)

  MIXED_CRACKS_MEMBERS(ContentsOnDisk,
                       fields,
                       mesh_checksum,
                       files,
                       damage_origins)



  unsigned int
  checkpoint_format()
  {
    const auto n = std::count_if(
      all_quantities().begin(),
      all_quantities().end(),
      [](const Quantity &quantity) { return quantity.is_kept(); });
    return format_of_files +
           1000 * (static_cast<unsigned int>(n) - n_quantities);
  }



  Seal
  read_seal(const std::string &directory)
  {
    const std::string  text = contents_of_file(directory + seal_name);
    std::istringstream in(text), old(text);
    Seal               seal;
    seal.format = read_title(in);
    if (is_seal_without_format(old))
      seal.format = 1;
    if (seal.format != checkpoint_format())
      return seal;
    std::string word;
    seal.record.name = record_name.substr(1);
    in >> word >> seal.number >> word >> seal.step >> word >>
      seal.record.size >> seal.record.checksum;
    return in ? seal : Seal();
  }



  const std::vector<std::string> &
  names_of_libraries()
  {
    static const std::vector<std::string> names{
      "mesh", "mesh.info", values_name, "mesh_variable.data"};
    return names;
  }



  std::vector<FileOnDisk>
  files_of_libraries(const std::string &directory)
  {
    std::vector<FileOnDisk> files;
    // whatever else lies there is of somebody else
    for (const std::string &name : names_of_libraries())
      if (size_of_file(directory + '/' + name) >= 0)
        files.push_back(described(directory + '/' + name, name));
    return files;
  }



  // record.txt is read back from the disk before it is sealed: sync_to_disk()
  // drops it from memory.
  void
  write_seal(const std::string      &directory,
             const ContentsOnDisk   &contents,
             const std::string      &run,
             const unsigned long int number,
             const unsigned int      step)
  {
    std::ostringstream record, seal;
    record << first_line();
    TextWriter writer(record);
    writer(contents);
    record << '\n' << run;
    const std::string text    = record.str();
    std::string       problem = write_durably(directory + record_name, text);
    const auto        sum     = checksum(text);
    seal << first_line() << "number " << number << "\nstep " << step
         << "\nrecord " << text.size() << ' ' << sum << '\n';
    if (problem.empty())
      problem = sync_to_disk(directory + record_name);
    if (problem.empty() && file_checksum(directory + record_name) != sum)
      problem = "'" + directory + record_name + "' is not what was written";
    if (problem.empty())
      problem = write_durably(directory + seal_name, seal.str());
    require(problem.empty(), problem);
  }



  SealedRecord
  split_record(const std::string &text)
  {
    std::istringstream in(text);
    require(read_title(in) == checkpoint_format(),
            "its record is of another format than its seal");
    SealedRecord record;
    TextReader   reader(in);
    reader(record.contents);
    std::ostringstream rest;
    rest << in.rdbuf();
    record.run = rest.str();
    return record;
  }



  // Throws at the first link of the chain that does not hold.
  SealedRecord
  read_sealed(const std::string &directory)
  {
    const Seal seal = read_seal(directory);
    require(seal.format == checkpoint_format(), "it is not sealed");
    require_as_written(directory, seal.record);
    const SealedRecord record =
      split_record(contents_of_file(directory + record_name));
    const ContentsOnDisk &contents   = record.contents;
    bool                  has_values = false, has_mesh = false;
    for (const FileOnDisk &file : contents.files)
    {
      require_as_written(directory, file);
      has_mesh   = has_mesh || file.name == "mesh";
      has_values = has_values || (file.name == values_name &&
                                  file.size == size_of_values(contents.fields));
    }
    require(has_mesh, "'mesh' is not recorded");
    require(has_values,
            "'" + values_name + "' has not the size of the values of " +
              std::to_string(contents.fields.cells) + " cells");
    return record;
  }
} // namespace MixedCracks
