// SPDX-License-Identifier: GPL-2.0-or-later
// The split of the energy at finite strain (M15). W~ (MPa) always fades with
// g; what is chosen is the pressure p (MPa) and what drives the crack, D =
// 2 Psi+:
//
//   name                 p fades   Psi+
//   none                 always    W~ + (driving/2) p theta
//   volumetric           p > 0     W~ + (driving/2) <p> theta
//   principal stretches  always    sum over lambda_a > 1 of w(lambda_a)
//                                     + (driving/2) <p> theta
//
// driving: of FinitePressureLaw, <p> = max(p, 0), W~ = sum_a w(lambda_a) with
// w(1) = w'(1) = 0, that is with ln J = sum_a ln lambda_a shared out. The last
// is a hybrid: the momentum balance is that of 'none'.

#include <model/finite_split.h>

namespace MixedCracks
{
  namespace
  {
    template <bool splits, bool only_tension, bool only_stretches>
    std::unique_ptr<FiniteSplit>
    make_split()
    {
      return std::make_unique<FiniteSplit>(
        FiniteSplit{splits, only_tension, only_stretches});
    }
  } // namespace



  const Registry<FiniteSplit> &
  all_finite_splits()
  {
    static const Registry<FiniteSplit> list(
      "energy split at finite strain",
      {{"none",
        "the whole energy drives the crack and is degraded by it",
        make_split<false, false, false>},
       {"volumetric",
        "a pressure that compresses neither drives the crack nor fades",
        make_split<true, true, false>},
       {"principal stretches",
        "only stretches above 1 and expansion drive the crack, the whole "
        "energy is degraded by it; with neo-Hooke and Ogden",
        make_split<false, true, true>}});
    return list;
  }
} // namespace MixedCracks
