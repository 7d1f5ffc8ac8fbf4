// SPDX-License-Identifier: GPL-2.0-or-later
// FNV-1a of 64 bits, s <- (s xor byte) p mod 2^64 (Fowler, Noll, Vo). It finds
// accidents, not forgery, for a multiplication per byte.

#include <base/checksum.h>

#include <fstream>

namespace MixedCracks
{
  namespace
  {
    constexpr std::uint64_t fnv_basis = 14695981039346656037ULL;
    constexpr std::uint64_t fnv_prime = 1099511628211ULL;

    std::uint64_t
    continued(std::uint64_t sum, const char *begin, const char *const end)
    {
      for (; begin != end; ++begin)
        sum = (sum ^ static_cast<unsigned char>(*begin)) * fnv_prime;
      return sum;
    }
  } // namespace



  std::uint64_t
  checksum(const char *const begin, const char *const end)
  {
    return continued(fnv_basis, begin, end);
  }



  std::uint64_t
  checksum(const std::string &text)
  {
    return checksum(text.data(), text.data() + text.size());
  }



  std::uint64_t
  file_checksum(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary);
    std::uint64_t sum = fnv_basis;
    char          buffer[65536];
    while (file.read(buffer, sizeof(buffer)) || file.gcount() > 0)
      sum = continued(sum, buffer, buffer + file.gcount());
    return sum;
  }
} // namespace MixedCracks
