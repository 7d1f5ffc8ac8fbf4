// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_run_record_h
#define mixed_cracks_output_run_record_h

#include <output/checkpoint.h>

#include <iosfwd>

namespace MixedCracks
{
  /// As text, numbers to the last digit.
  void write_record(std::ostream &out, const RunRecord &record);

  /// Throws FileError when the text is not what write_record() writes, or is
  /// of no run: without rows, with gaps in their numbers, with times or steps
  /// that are none.
  RunRecord read_record(std::istream &in);
} // namespace MixedCracks

#endif
