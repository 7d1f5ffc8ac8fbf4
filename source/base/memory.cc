// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/memory.h>

#include <cstdlib>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace MixedCracks
{
  // Vectors of a million unknowns; what is smaller is fast to reuse.
  void
  return_large_blocks()
  {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 8 << 20);
#endif
  }



  void
  return_free_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
} // namespace MixedCracks
