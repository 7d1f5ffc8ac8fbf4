// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_memory_h
#define mixed_cracks_base_memory_h

namespace MixedCracks
{
  /// Have blocks of 8 MB and more go back to the system as soon as they are
  /// freed. The C library learns from such blocks to keep them, and a large run
  /// then needs a quarter more than it uses. Does nothing where the library
  /// cannot be told. To be called first in main().
  void return_large_blocks();

  /// Have what is free go back to the system now, small blocks too.
  void return_free_memory();
} // namespace MixedCracks

#endif
