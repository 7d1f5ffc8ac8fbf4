// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_sheet_h
#define mixed_cracks_cracks_crack_sheet_h

#include <cracks/damage_ridge.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A point on the front of a crack in space, with its own axes of length 1.
  struct FrontPoint
  {
    dealii::Point<3>     position; ///< mm
    dealii::Tensor<1, 3> normal;   ///< of the sheet
    /// tangent to the sheet and normal to the front, away from the crack
    dealii::Tensor<1, 3> ahead;
  };

  /// A connected piece of the front of a crack.
  struct CrackFront
  {
    std::vector<FrontPoint> points;            ///< about h apart
    bool                    is_closed = false; ///< the first follows the last
    double                  length    = 0.;    ///< mm
  };

  /// A crack in space: the mid surface of the band in which the phase field is
  /// small, as one sheet of triangles.
  struct CrackSheet
  {
    std::vector<dealii::Point<3>>            vertices;  ///< mm
    std::vector<dealii::Tensor<1, 3>>        normals;   ///< there, of length 1
    std::vector<std::array<unsigned int, 3>> triangles; ///< turned alike
    double                                   area = 0.; ///< mm^2
    std::vector<CrackFront>                  fronts;    ///< the longest first
    /// that it has come to, in alphabetical order
    std::vector<std::string> boundaries;
    /// points on each of these, mm: the one nearest to their middle first
    std::vector<std::vector<dealii::Point<3>>> contacts;
    /// where it began, as a crack or as an initial crack: a boundary,
    /// "interior", or empty where nobody knows
    std::string start;

    double front_length() const; ///< mm, of all fronts
    /// Start first: "notch to back to front to tip", with "tip" for a front in
    /// the material.
    std::string joins() const;
  };

  /// What trace_sheets() takes for a crack; as CrackPathOptions has it in the
  /// plane.
  struct CrackSheetOptions
  {
    double length_scale = 0.; ///< l, mm
    double cell_size    = 0.; ///< h, mm: the spacing of points on fronts
    /// every crack has places with a smaller phase field
    double broken = 0.3;
    /// sheets end where the phase field on them passes this ...
    double connected = 0.5;
    /// ... less this (in l), as the front lies behind: 0.52 with the profile of
    /// Wu's density, 0.59 with AT1's, 0.69 with AT2's
    double tip_lag = 0.6;
    /// cracks have an area of more than this (in l^2) ...
    double smallest = 1.;
    /// ... and of more than this (in l) times the length of their fronts: at
    /// the tip of a notch, whose own profile is none, a sheet may begin
    double narrowest = 0.5;
    /// where damage was seen first, and what was broken from the start, mm
    std::vector<dealii::Point<3>> nuclei, initial;
    /// of boundaries, by their ids; the others are "boundary"
    std::map<dealii::types::boundary_id, std::string> boundary_names;
  };

  /// The cracks of which these triangles are the ridge, the largest first. The
  /// same triangles in the same order give the same cracks.
  std::vector<CrackSheet> trace_sheets(const std::vector<RidgeTriangle> &ridge,
                                       const CrackSheetOptions &options);
} // namespace MixedCracks

#endif
