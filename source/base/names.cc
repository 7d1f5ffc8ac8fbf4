// SPDX-License-Identifier: GPL-2.0-or-later
// Names that are not known, and the one that was probably meant: the candidate
// with the smallest edit distance, if no more than half of the letters are
// wrong (or two of a short word). Upper and lower case are the same here.

#include <base/names.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace MixedCracks
{
  namespace
  {
    std::string
    normalised(const std::string &word)
    {
      std::string text = dealii::Utilities::trim(word);
      std::transform(
        text.begin(), text.end(), text.begin(), [](unsigned char c) {
          return static_cast<char>(std::tolower(c));
        });
      return text;
    }

    // Levenshtein distance: with d(i, j) that of the first i letters of a and
    // the first j of b,
    //
    //   d(i, j) = min( d(i-1, j-1) + [a_i /= b_j], d(i-1, j) + 1,
    //                  d(i, j-1) + 1 ):
    //
    // replace, leave out, put in; d(i, 0) = i, d(0, j) = j. Row i takes the
    // place of row i-1, whose entry to the upper left is kept in 'diagonal'.
    unsigned int
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<unsigned int> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0U);
      for (std::size_t i = 1; i <= a.size(); ++i)
      {
        unsigned int diagonal = row[0];
        row[0]                = static_cast<unsigned int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
          const unsigned int replaced =
            diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U);
          diagonal = row[j];
          row[j]   = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
      }
      return row.back();
    }
  } // namespace



  std::string
  nearest_name(const std::string              &word,
               const std::vector<std::string> &candidates)
  {
    const std::string wanted = normalised(word);
    std::string       best;
    // more than half of the letters wrong is no misspelling any more
    unsigned int best_distance =
      std::max<unsigned int>(2, static_cast<unsigned int>(wanted.size()) / 2);
    for (const std::string &candidate : candidates)
    {
      const unsigned int distance =
        edit_distance(wanted, normalised(candidate));
      if (distance < best_distance ||
          (best.empty() && distance == best_distance))
      {
        best          = candidate;
        best_distance = distance;
      }
    }
    return best;
  }



  std::string
  join_names(const std::vector<std::string> &names,
             const std::string              &separator)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "" : separator) + name;
    return text;
  }



  std::string
  unknown_name_message(const std::string              &word,
                       const std::vector<std::string> &allowed)
  {
    const std::string nearest = nearest_name(word, allowed);
    return "unknown '" + word + "'" +
           (nearest.empty() ? std::string(".")
                            : "; did you mean '" + nearest + "'?") +
           (allowed.empty() ? " None is known."
                            : " Allowed: " + join_names(allowed) + ".");
  }
} // namespace MixedCracks
