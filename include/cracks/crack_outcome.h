// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_outcome_h
#define mixed_cracks_cracks_crack_outcome_h

#include <cracks/crack_path.h>

#include <string>
#include <vector>

namespace MixedCracks
{
  /// How a body has broken, in names of its boundaries. A side is every
  /// boundary on the outline of the body that is neither a hole nor a notch,
  /// see role_of_boundary(), with the notches and slits that open there.
  struct Outcome
  {
    enum class Kind
    {
      none,     ///< there is no crack
      arrested, ///< there are cracks, but they join no two sides
      /// cracks join two different sides; in 3-d they leave two parts, see
      /// are_separate()
      separated
    };
    /// Where the cracks that separate the body run, as seen from a hole.
    enum class Way
    {
      elsewhere, ///< there is no hole, or they do not pass it, or on both sides
      through,   ///< by way of the hole: without it they would not join
      below,     ///< without it, below its center (the mean of its edges)
      above      ///< the same above
    };
    Kind kind = Kind::none;
    Way  way  = Way::elsewhere;
    /// which the way is about; empty where there is none
    std::string hole;
    /// what each crack joins that separates the body: "left to hole", "hole to
    /// right"; "crack" is where a branch leaves another one, "tip" an end in
    /// the material. In 3-d all boundaries it comes to, CrackSheet::joins()
    std::vector<std::string> joins;
    /// Of the cracks that make the connection, or else of the longest crack,
    /// the end at which damage came first (without nuclei: the notch when one
    /// of them starts there, else the start of the longest): the name of a
    /// boundary, "corner top left" and the like within 3 l of where two sides
    /// meet, "interior" for a crack that has grown both ways, "elsewhere" in
    /// the material; "none" without a crack.
    std::string start = "none";
  };

  /// The word for the path of the cracks that stands in files, from one table:
  /// "none", "arrested", "through hole", "below hole" and so on with the name
  /// of the hole, "other" where the way has no word.
  std::string path_in_words(const Outcome &outcome);

  /// Whether the cracks of that outcome have cut the body in two.
  bool separates(const Outcome &outcome);

  /// @p edges: all of the boundary, joined at their ends. @p nuclei: where
  /// damage was seen first, in that order, mm; the crack nearest to the first
  /// of them is the first one, without any it is the longest. @p length_scale:
  /// l, mm.
  Outcome classify(const std::vector<Crack>            &cracks,
                   const std::vector<BoundaryEdge>     &edges,
                   const std::vector<dealii::Point<2>> &nuclei,
                   double                               length_scale);
} // namespace MixedCracks

#endif
