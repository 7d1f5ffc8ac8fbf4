// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_lanes_h
#define mixed_cracks_base_lanes_h

#include <cstring>

namespace MixedCracks
{
  /// Four numbers of one register, or of as many as it takes; operators of the
  /// compiler (GCC, Clang).
  using Floats  = float __attribute__((vector_size(16)));
  using Doubles = double __attribute__((vector_size(32)));

  constexpr unsigned int n_lanes = 4;

  template <typename Lanes, typename Number>
  inline __attribute__((always_inline)) Lanes
  load(const Number *from)
  {
    Lanes result;
    std::memcpy(&result, from, sizeof(result));
    return result;
  }

  template <typename Lanes, typename Number>
  inline __attribute__((always_inline)) void
  store(const Lanes &lanes, Number *to)
  {
    std::memcpy(to, &lanes, sizeof(lanes));
  }

  /// A function that is compiled for processors with AVX2, called where
  /// has_avx2(): what it calls is compiled for them if it is always_inline.
#ifdef __x86_64__
#  define MIXED_CRACKS_FOR_AVX2 __attribute__((target("avx2,fma")))
#else
#  define MIXED_CRACKS_FOR_AVX2
#endif
  /// Whether this processor has AVX2 and FMA: a package for any x86-64 must not
  /// end at an instruction that the machine does not know.
  inline bool
  has_avx2()
  {
#ifdef __x86_64__
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
  }
} // namespace MixedCracks

#endif
