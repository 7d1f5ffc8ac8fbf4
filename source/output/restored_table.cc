// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>

#include <deal.II/base/mpi.h>

#include <output/restored_table.h>
#include <output/small_file.h>

namespace MixedCracks
{
  void
  RestoredTable::write(const std::string &content, const bool append) const
  {
    if (header.empty())
      return;
    on_first_rank(communicator, [&]() {
      if (!append)
        replace_small_file(name, content);
      else if (!content.empty())
        append_to_file(name, content);
    });
  }



  void
  RestoredTable::open()
  {
    restore("");
  }



  // Written from the rows of the checkpoint, not continued: rows of steps
  // behind it, which will be computed again, must not stay.
  void
  RestoredTable::restore(const std::string &earlier)
  {
    all_rows = earlier;
    if (earlier.empty() &&
        dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      all_rows = header;
    write(all_rows, /*append=*/false);
  }



  void
  RestoredTable::add(const std::string &lines)
  {
    // for checkpoints, of which the first rank knows
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      all_rows += lines;
    write(lines, /*append=*/true);
  }
} // namespace MixedCracks
