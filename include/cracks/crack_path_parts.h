// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_path_parts_h
#define mixed_cracks_cracks_crack_path_parts_h

#include <cracks/crack_path_boundary.h>
#include <cracks/crack_path_field.h>

#include <vector>

/// The steps of trace_cracks(), in this order.
namespace MixedCracks
{
  using Polyline = std::vector<dealii::Point<2>>;

  /// What all the steps know.
  struct CrackPathProblem
  {
    const DamageField      &field;
    const BodyBoundary     &boundary;
    const CrackPathOptions &options;
    double                  h; ///< size of the cells in the crack, mm
  };

  /// A path along nodes.
  struct NodePath
  {
    static constexpr unsigned int no_parent = static_cast<unsigned int>(-1);
    Polyline                      points;
    /// of a branch: the path it leaves, at its first point
    unsigned int parent = no_parent;
  };

  // crack_path_graph.cc

  /// Whether damage at a point belongs to the rim of the body, or to the
  /// profile of a notch before its tip.
  bool is_at_rim(const CrackPathProblem &problem,
                 const dealii::Point<2> &point);

  /// The paths along broken nodes: in every connected part the longest, and
  /// its branches.
  std::vector<NodePath> find_node_paths(const CrackPathProblem &problem);

  // crack_path_centring.cc

  double length_of(const Polyline &points);
  double distance_to(const Polyline &points, const dealii::Point<2> &point);

  /// The points at equal distances of about @p spacing, ends included.
  Polyline resampled(const Polyline &points, double spacing);

  /// The path without what is within @p length of its last point.
  Polyline without_end(const Polyline &points, double length);

  /// From a point on the path, how far the center of the damage lies in the
  /// direction @p normal, mm; 0 where too little of it can be seen.
  double offset_of_center(const CrackPathProblem     &problem,
                          const dealii::Point<2>     &point,
                          const dealii::Tensor<1, 2> &normal);

  /// The path moved into the middle of the damage, smooth.
  Polyline centred(const CrackPathProblem &problem, const Polyline &points);

  // crack_path_ends.cc

  /// The parts of a path that do not follow the boundary within damage there.
  std::vector<Polyline> parts_off_the_rim(const CrackPathProblem &problem,
                                          const Polyline         &points);

  /// The tip of a sharp notch or slit at which the path ends, if its other end
  /// is not closer; nullptr when there is none.
  const NotchTip *tip_at_end(const CrackPathProblem &problem,
                             const Polyline         &points);

  /// Without the last points where these have turned back along the path.
  void unfold_end(const CrackPathProblem &problem, Polyline &points);

  /// Prolong the last point to the @p tip of a notch if there is one, or else
  /// to the boundary or the tip of the crack.
  CrackEnd find_end(const CrackPathProblem &problem,
                    const NotchTip         *tip,
                    Polyline               &points);

  /// Join the first point to the crack it leaves.
  CrackEnd join(const CrackPathProblem &problem,
                const Polyline         &parent,
                Polyline               &points);
} // namespace MixedCracks

#endif
