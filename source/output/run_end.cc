// SPDX-License-Identifier: GPL-2.0-or-later
#include <output/run_end.h>

namespace MixedCracks
{
  int
  exit_status(const RunEnd end)
  {
    switch (end)
    {
      case RunEnd::failed:
      case RunEnd::out_of_time:
        return 3;
      case RunEnd::stopped:
        return 5;
      case RunEnd::refused:
        return 2;
      default:
        return 0;
    }
  }



  std::string
  in_words(const RunEnd end)
  {
    switch (end)
    {
      case RunEnd::none:
        break;
      case RunEnd::separated:
        return "separated: the cracks join two sides";
      case RunEnd::force_fell:
        return "the force fell below the given fraction of its peak";
      case RunEnd::end_time:
        return "end time reached";
      case RunEnd::no_equilibrium:
        return "no equilibrium: the body is apart under its loads, which only "
               "the residual stiffness carries";
      case RunEnd::onset:
        return "onset: the next step makes a crack run";
      case RunEnd::failed:
        return "the smallest load step failed; the last accepted state is "
               "written";
      case RunEnd::stopped:
        return "stopped on request; continue with --resume";
      case RunEnd::out_of_time:
        return "Output/Wall time limit was over before a load step was "
               "finished; continue with --resume and a larger one";
      case RunEnd::refused:
        return "an expression of the input had no value that is allowed";
    }
    return "";
  }
} // namespace MixedCracks
