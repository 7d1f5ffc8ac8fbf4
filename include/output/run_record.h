// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_run_record_h
#define mixed_cracks_output_run_record_h

#include <output/checkpoint.h>

#include <iosfwd>

namespace MixedCracks
{
  /// As text, numbers to the last digit.
  void write_record(std::ostream &out, const RunRecord &record);

  /// Throws FileError when the text is not what write_record() writes.
  RunRecord read_record(std::istream &in);

  /// A checksum (FNV-1a, 64 bits) of a file's contents; 0 when it cannot be
  /// read.
  unsigned long long file_checksum(const std::string &file_name);
} // namespace MixedCracks

#endif
