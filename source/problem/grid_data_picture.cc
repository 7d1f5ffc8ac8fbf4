// SPDX-License-Identifier: GPL-2.0-or-later
// Gray-scale pictures in PGM: "P2" (numbers as text) or "P5" (bytes, from white
// = 256 on two of them, the high one first), then width, height and white; '#'
// begins a comment in the head. Values are pixel/white, 0 to 1, by rows from
// the top.
//
// What the head promises is compared with the size of the file before memory is
// asked for: a damaged head could promise anything.

#include <base/text.h>

#include <problem/grid_data.h>

#include <limits>

namespace MixedCracks
{
  namespace
  {
    constexpr std::size_t most_pixels    = 100 * 1000 * 1000;
    constexpr std::size_t largest_number = 65535;

    // The next unsigned integer from position on, behind blanks and comments;
    // false when there is none. Position is left behind it.
    bool
    next_integer(const std::string &text,
                 std::size_t       &position,
                 std::size_t       &number)
    {
      while (position < text.size() &&
             (is_blank(text[position]) || text[position] == '#'))
        if (text[position] == '#')
          position = std::min(text.find('\n', position), text.size());
        else
          ++position;
      const std::size_t begin = position;
      for (number = 0; position < text.size() && is_digit(text[position]);
           ++position)
        if (number < std::numeric_limits<std::size_t>::max() / 16)
          number = 10 * number + static_cast<std::size_t>(text[position] - '0');
      return position > begin;
    }

    std::string
    read_pixels(const std::string &text,
                std::size_t        position,
                const bool         is_plain,
                const std::size_t  white,
                Picture           &picture)
    {
      // of a raw pixel, the high one first; one blank ends the head
      const std::size_t n_bytes = white < 256 ? 1 : 2;
      if (!is_plain &&
          text.size() < ++position + n_bytes * picture.values.size())
        return "ends before its last pixel";
      for (double &value : picture.values)
      {
        std::size_t number = 0;
        if (is_plain && !next_integer(text, position, number))
          return "ends before its last pixel, or holds something else than "
                 "integers";
        for (std::size_t i = 0; !is_plain && i < n_bytes; ++i)
          number = 256 * number + static_cast<unsigned char>(text[position++]);
        if (number > white)
          return "has a pixel of " + std::to_string(number) +
                 ", more than its white, " + std::to_string(white);
        value = double(number) / double(white);
      }
      return "";
    }
  } // namespace



  bool
  looks_like_picture(const std::string &text)
  {
    // other pictures begin with bytes that no table has
    return text.size() >= 2 &&
           ((text[0] == 'P' && is_digit(text[1])) ||
            (static_cast<unsigned char>(text[0]) & 0x80) != 0);
  }



  std::string
  read_picture(const std::string &text, Picture &picture)
  {
    const std::string kind = text.substr(0, 2);
    if (kind != "P2" && kind != "P5")
      return "is no gray-scale picture of the format PGM (P2 or P5)";
    std::size_t position = 2, white = 0;
    if (!next_integer(text, position, picture.width) ||
        !next_integer(text, position, picture.height) ||
        !next_integer(text, position, white))
      return "has a broken head: width, height and white are expected after " +
             kind;
    if (picture.width == 0 || picture.height == 0 ||
        picture.width > most_pixels ||
        picture.height > most_pixels / picture.width)
      return "claims to have " + std::to_string(picture.width) + " x " +
             std::to_string(picture.height) + " pixels, allowed are 1 to " +
             std::to_string(most_pixels);
    if (white == 0 || white > largest_number)
      return "has the white " + std::to_string(white) + ", allowed are 1 to " +
             std::to_string(largest_number);
    // before memory is asked for: a pixel takes a byte at least
    if (text.size() - position < picture.width * picture.height)
      return "ends before its last pixel";
    picture.values.resize(picture.width * picture.height);
    return read_pixels(text, position, kind == "P2", white, picture);
  }
} // namespace MixedCracks
