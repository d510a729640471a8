// The levels of vector instructions that this machine and this build have.
#pragma once

#include <vector>

#include <sheer/error.h>
#include <sheer/render.h>

#include "lanes/targets.h"

namespace sheer {

inline std::vector<Simd> simd_levels()
{
    std::vector<Simd> found;
    for (const Simd level : {Simd::scalar, Simd::sse4, Simd::avx2, Simd::avx512, Simd::neon}) {
        try {
            targets_of(level);
            found.push_back(level);
        } catch (const Error&) {
        }
    }
    return found;
}

}  // namespace sheer
