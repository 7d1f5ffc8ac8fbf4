// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_bytes_h
#define mixed_cracks_problem_geometries_mesh_bytes_h

#include <base/text.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace MixedCracks
{
  namespace MeshScanning
  {
    /// Reads bytes from front to back; a read behind the end gives 0 and sets
    /// is_broken.
    class ByteReader
    {
    public:
      explicit ByteReader(const std::string &bytes)
        : bytes(bytes)
      {}

      template <typename Number>
      Number
      get()
      {
        Number number = 0;
        if (sizeof(Number) > n_left())
          is_broken = true;
        else
        {
          std::memcpy(&number, bytes.data() + place, sizeof(Number));
          place += sizeof(Number);
        }
        return number;
      }

      /// @p n, a number of things of at least @p size bytes each; 0 when there
      /// is no room for them.
      std::uint64_t
      count(const std::uint64_t n, const std::uint64_t size)
      {
        is_broken = is_broken || n > n_left() / size;
        return is_broken ? 0 : n;
      }

      std::uint64_t
      get_count(const std::uint64_t size)
      {
        return count(get<std::uint64_t>(), size);
      }

      /// Up to the end of the line, without blanks around.
      std::string
      line()
      {
        const std::size_t end = std::min(bytes.find('\n', place), bytes.size());
        const std::vector<std::string> parts =
          split_list(bytes.substr(place, end - place), '\n');
        place = std::min(end + 1, bytes.size());
        return parts.empty() ? "" : parts.front();
      }

      void
      skip_to(const std::string &text)
      {
        const std::size_t found = bytes.find(text, place);
        is_broken               = is_broken || found == std::string::npos;
        place                   = is_broken ? bytes.size() : found;
      }

      std::uint64_t
      n_left() const
      {
        return bytes.size() - place;
      }

      bool is_broken = false;

    private:
      const std::string &bytes;
      std::size_t        place = 0;
    };



    /// One line of text: numbers with blanks between them.
    class NumberLine
    {
    public:
      NumberLine &
      operator<<(const double number)
      {
        char digits[40];
        std::snprintf(digits, sizeof(digits), "%.17g", number);
        return add(digits);
      }

      template <typename Integer>
      NumberLine &
      operator<<(const Integer number)
      {
        return add(std::to_string(number));
      }

      std::string text;

    private:
      NumberLine &
      add(const std::string &word)
      {
        text += (text.empty() ? "" : " ") + word;
        return *this;
      }
    };
  } // namespace MeshScanning
} // namespace MixedCracks

#endif
