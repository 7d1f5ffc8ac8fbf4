// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_cracks_crack_events_h
#define mixed_cracks_cracks_crack_events_h

#include <cracks/crack_observer.h>

#include <discretization/damage_origins.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// Something that the cracks of a body have come to in a load step. Numbers
  /// have ten significant digits, so that a file has all of them.
  struct CrackEvent
  {
    std::string kind; ///< "start" of the watch, or one of event_kinds()
    /// of all cracks: the length of paths, mm, or the area of sheets, mm^2
    double      crack_size = 0.;
    double      growth     = 0.; ///< of that, since the start of the watch
    std::string boundary;        ///< that a crack has met, or empty
    /// mm: where damage began, or where the boundary was met; in the plane
    /// z = 0
    std::optional<dealii::Point<3>> place;
  };

  /// In @p dim dimensions. "onset": damage that has not been there from the
  /// start. "crack length", in 3-d "crack area": all cracks together have
  /// passed another multiple of a size since then. "boundary": a crack that did
  /// not begin there has come to a named boundary. "separation": cracks have
  /// cut the body in two.
  std::vector<std::string> event_kinds(int dim);

  /// Tells what is new in the cracks of a state. What it remembers are the
  /// events themselves: who remembers the same ones goes on alike.
  class CrackEvents
  {
  public:
    /// @p kinds of event_kinds(); @p size_step: mm, in 3-d mm^2, positive.
    CrackEvents(int                             dim,
                const std::vector<std::string> &kinds,
                double                          size_step);

    /// What has come since the last events remembered; at first "start", and
    /// again for each boundary that cracks are at by then. Where cracks are
    /// known, on rank 0.
    std::vector<CrackEvent> look(const TracedCracks  &cracks,
                                 const DamageOrigins &origins) const;

    void remember(const CrackEvent &event);

  private:
    using Meeting = std::pair<std::string, dealii::Point<3>>;

    /// Boundaries that cracks have come to and not been at before.
    std::vector<Meeting> new_meetings(const TracedCracks  &cracks,
                                      const DamageOrigins &origins) const;

    /// How many multiples there are in a growth.
    double multiples(double growth) const;

    const std::string              growth_kind;
    const std::vector<std::string> kinds;
    const double                   size_step;

    std::optional<double> initial_size;      // none before the start
    double                growth    = 0.;    // of the events so far
    bool                  has_begun = false; // damage
    bool                  is_cut    = false;
    std::vector<Meeting>  meetings;
  };
} // namespace MixedCracks

#endif
