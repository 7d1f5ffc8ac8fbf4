// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_sheet_outcome_h
#define mixed_cracks_cracks_sheet_outcome_h

#include <cracks/crack_outcome.h>
#include <cracks/crack_sheet.h>
#include <cracks/intact_parts.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// Whether two parts of the body come to two sides of it each, and are larger
  /// than a cube of 2 l. @p names: of boundaries, by their ids. @p
  /// length_scale: l, mm.
  bool
  are_separate(const std::vector<IntactPart>                           &parts,
               const std::map<dealii::types::boundary_id, std::string> &names,
               double length_scale);

  /// A hole of the body.
  struct HoleInSpace
  {
    std::string      name;
    dealii::Point<3> center; ///< mm, the mean of its faces
  };

  /// What cracks in space have done; Outcome has the words. The cracks that
  /// separate the body are those without a front in the material that join two
  /// boundaries, or else the largest. @p nuclei: where damage was seen first,
  /// in that order, mm. @p length_scale: l, mm.
  Outcome classify(const std::vector<CrackSheet>       &sheets,
                   bool                                 separate,
                   const std::optional<HoleInSpace>    &hole,
                   const std::vector<dealii::Point<3>> &nuclei,
                   double                               length_scale);
} // namespace MixedCracks

#endif
