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
    double      crack_length = 0.; ///< mm, of all cracks
    double      growth       = 0.; ///< mm, since the start of the watch
    std::string boundary;          ///< that a crack has met, or empty
    /// mm: where damage began, or where the boundary was met
    std::optional<dealii::Point<2>> place;
  };

  /// "onset": damage that has not been there from the start.
  /// "crack length": all cracks together have passed another multiple of a
  /// length since then. "boundary": a crack that did not begin there has come
  /// to a named boundary. "separation": cracks have cut the body in two.
  const std::vector<std::string> &event_kinds();

  /// Tells what is new in the cracks of a state. What it remembers are the
  /// events themselves: who remembers the same ones goes on alike.
  class CrackEvents
  {
  public:
    /// @p kinds of event_kinds(); @p length_step: mm, positive.
    CrackEvents(const std::vector<std::string> &kinds, double length_step);

    /// What has come since the last events remembered; at first "start", and
    /// again for each boundary that cracks are at by then. Where paths are
    /// known, on rank 0.
    std::vector<CrackEvent> look(const TracedCracks  &cracks,
                                 const DamageOrigins &origins) const;

    void remember(const CrackEvent &event);

  private:
    using Meeting = std::pair<std::string, dealii::Point<2>>;

    bool watches(const std::string &kind) const;

    /// Boundaries that cracks have come to and not been at before.
    std::vector<Meeting> new_meetings(const std::vector<Crack> &paths,
                                      const DamageOrigins      &origins) const;

    /// How many multiples there are in a growth.
    double multiples(double growth) const;

    const std::vector<std::string> kinds;
    const double                   length_step;

    std::optional<double> initial_length;    // mm; none before the start
    double                growth    = 0.;    // mm, of the events so far
    bool                  has_begun = false; // damage
    bool                  is_cut    = false;
    std::vector<Meeting>  meetings;
  };
} // namespace MixedCracks

#endif
