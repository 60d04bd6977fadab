#pragma once
/// Choice of the best version of a function for this processor, by Highway's tables but without its library,
/// which measures a clock for six milliseconds whenever it is loaded.

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

namespace dashpad {

/// Instruction sets of processor and system as Highway's bits; without x86 those known when compiling.
inline std::int64_t instruction_sets() {
  std::int64_t sets = HWY_ENABLED_BASELINE;
#if HWY_ARCH_X86
  __builtin_cpu_init();
  if (__builtin_cpu_supports("ssse3")) sets |= HWY_SSSE3;
  if (__builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes"))
    sets |= HWY_SSE4;
  // Without its fused operations, so that all sets give the same bits; those of AVX-512 cannot be left out.
  if (__builtin_cpu_supports("avx2")) sets |= HWY_AVX2;
#endif
  return sets;
}

/// The best version in a table made by DASHPAD_VERSIONS_OF(function).
template <class Function, std::size_t size>
Function* for_this_processor(Function* const (&versions)[size]) {
  hwy::ChosenTarget chosen;
  chosen.Update(instruction_sets());
  return versions[chosen.GetIndex()];
}

}  // namespace dashpad

#define DASHPAD_VERSIONS_OF(function) \
  { nullptr, HWY_CHOOSE_TARGET_LIST(function), HWY_CHOOSE_FALLBACK(function) }
