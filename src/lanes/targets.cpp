// Levels of vector instructions by name.
#include "lanes/targets.h"

#include <array>

#include <sheer/error.h>

namespace sheer {

namespace {

struct Level {
    Simd simd;
    const char* name;
    TargetSet target;
};

// Slowest first. EMU128 is Highway's portable emulation of a four-lane machine.
constexpr std::array<Level, 5> kLevels = {{
    {Simd::scalar, "scalar", HWY_EMU128 | HWY_SCALAR},
    {Simd::sse4, "sse4", HWY_SSE4},
    {Simd::neon, "neon", HWY_NEON},
    {Simd::avx2, "avx2", HWY_AVX2},
    {Simd::avx512, "avx512", HWY_AVX3 | HWY_AVX3_DL},
}};

// The emulation is always there where more than one target is compiled; Highway's own list of
// supported targets leaves it out.
constexpr TargetSet kEmulation = HWY_EMU128 | HWY_SCALAR;

TargetSet available()
{
    return HWY_TARGETS & (hwy::SupportedTargets() | kEmulation);
}

}  // namespace

TargetSet targets_of(Simd level)
{
    if (level == Simd::best) return available();
    for (const Level& known : kLevels) {
        if (known.simd != level) continue;
        const TargetSet found = known.target & available();
        if (found != 0) return found;
        throw Error(Fault::input, std::string("simd: this machine has no ") + known.name +
                                      "; it has " + available_simd_levels());
    }
    throw Error(Fault::input, "simd: no such level");
}

std::string name_of_targets(TargetSet targets)
{
    std::string best = "scalar";
    for (const Level& known : kLevels) {
        if ((known.target & targets & HWY_TARGETS) != 0) best = known.name;
    }
    return best;
}

std::string available_simd_levels()
{
    std::string names;
    for (const Level& known : kLevels) {
        if ((known.target & available()) == 0) continue;
        names += (names.empty() ? "" : ", ") + std::string(known.name);
    }
    return names;
}

}  // namespace sheer
