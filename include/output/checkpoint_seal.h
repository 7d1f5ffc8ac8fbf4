// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_checkpoint_seal_h
#define mixed_cracks_output_checkpoint_seal_h

#include <discretization/damage_origins.h>

#include <output/checkpoint_fields.h>

#include <cstdint>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// The format of a checkpoint; to be raised whenever what is in its files
  /// changes. Others are refused by number. (1 had no number.) In the
  /// thousands: how many quantities the list has gained since, so that who adds
  /// one need not think of it.
  unsigned int checkpoint_format();

  /// A file of a checkpoint as it was written.
  struct FileOnDisk
  {
    std::string   name;
    std::uint64_t size     = 0; ///< bytes
    std::uint64_t checksum = 0;
  };

  /// What record.txt says of the mesh and of the state.
  struct ContentsOnDisk
  {
    FieldsOnDisk            fields;
    unsigned int            mesh_checksum = 0; ///< p4est's
    std::vector<FileOnDisk> files;             ///< of the libraries
    DamageOrigins           damage_origins;
  };

  /// seal.txt, which is written last.
  struct Seal
  {
    unsigned int      format = 0; ///< 0: there is none
    unsigned long int number = 0; ///< of the checkpoint since the start
    unsigned int      step   = 0;
    FileOnDisk        record; ///< record.txt
  };

  /// Of a generation; format 0 when there is none, or nonsense.
  Seal read_seal(const std::string &directory);

  /// What deal.II and p4est may write into a generation, in order of names.
  const std::vector<std::string> &names_of_libraries();

  /// Describe the files of the libraries in a generation, in order of names.
  std::vector<FileOnDisk> files_of_libraries(const std::string &directory);

  /// Write record.txt and seal.txt into a generation, and read them back.
  /// @p run: what write_record() has written. Throws FileError.
  void write_seal(const std::string    &directory,
                  const ContentsOnDisk &contents,
                  const std::string    &run,
                  unsigned long int     number,
                  unsigned int          step);

  /// A generation that is whole, read.
  struct SealedRecord
  {
    ContentsOnDisk contents;
    std::string    run; ///< for read_record()
  };

  /// Throws FileError with what is wrong with a generation: other sizes or
  /// checksums than those recorded, files that are not there.
  SealedRecord read_sealed(const std::string &directory);

  /// The two parts of record.txt. Throws FileError.
  SealedRecord split_record(const std::string &text);
} // namespace MixedCracks

#endif
