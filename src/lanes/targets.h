// Which instruction sets are compiled, and which of them a render runs on.
//
// Translation units with vector code are compiled once for each target by Highway. The choice among
// them is made once a render, from Options::simd, and handed down: nothing global changes, so two
// renders may run on two levels at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

// SSSE3 adds nothing over SSE4 here; SVE's vectors have no size and cannot be members of structs.
#define SHEER_USELESS_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#ifdef SHEER_FEWER_TARGETS
#define HWY_DISABLED_TARGETS (SHEER_USELESS_TARGETS | HWY_SSE4 | HWY_AVX3)
#else
#define HWY_DISABLED_TARGETS SHEER_USELESS_TARGETS
#endif
#ifdef SHEER_ONLY_SCALAR
#define HWY_COMPILE_ONLY_SCALAR
#endif

#include <hwy/targets.h>

#include <sheer/render.h>

namespace sheer {

// A set of Highway targets; one for each level that may run.
using TargetSet = std::int64_t;

// The targets of a level, for this machine and this build. Throws Error(Fault::input) when either
// does not have it.
TargetSet targets_of(Simd level);

// "scalar", "sse4", "avx2", "avx512" or "neon": what a render on these targets runs.
std::string name_of_targets(TargetSet targets);

// The levels this machine and this build have, slowest first.
std::string available_simd_levels();

}  // namespace sheer

// The function of a HWY_EXPORTed name for a TargetSet.
#if (HWY_TARGETS & (HWY_TARGETS - 1)) == 0
#define SHEER_DISPATCH(name, targets) (static_cast<void>(targets), &HWY_STATIC_DISPATCH(name))
#else
#define SHEER_DISPATCH(name, targets) HWY_DISPATCH_TABLE(name)[::sheer::target_index(targets)]

namespace sheer {
inline std::size_t target_index(TargetSet targets)
{
    hwy::ChosenTarget chosen;
    chosen.Update(targets);
    return chosen.GetIndex();
}
}  // namespace sheer
#endif
