// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_checksum_h
#define mixed_cracks_base_checksum_h

#include <cstdint>
#include <string>

namespace MixedCracks
{
  /// A checksum (FNV-1a, 64 bits) of bytes, or of a file's contents; that of
  /// nothing when the file cannot be read.
  std::uint64_t checksum(const char *begin, const char *end);
  std::uint64_t checksum(const std::string &text);
  std::uint64_t file_checksum(const std::string &path);
} // namespace MixedCracks

#endif
