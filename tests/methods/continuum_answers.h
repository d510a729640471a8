// What src/reference answers for the methods of the continuum.
#pragma once

#include <limits>
#include <span>
#include <string>

#include "methods/method.h"
#include "reference/layered.h"
#include "reference/z3.h"

namespace sheer {

using reference::Fragment;
using reference::Rgba;

// Where rounding decides between answers.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
inline constexpr Rgba kUnknown = {kNone, kNone, kNone, kNone};

inline reference::KBufferMerge merge_of(const std::string& name)
{
    if (name == "front") return reference::KBufferMerge::front;
    return name == "discard" ? reference::KBufferMerge::discard
                             : reference::KBufferMerge::nearest_two;
}

inline reference::HybridTail tail_of(const std::string& name)
{
    if (name == "maule") return reference::HybridTail::maule;
    return name == "total" ? reference::HybridTail::total : reference::HybridTail::none;
}

inline bool has_continuum_answer(const std::string& id)
{
    for (const char* known :
         {"mlab", "z3", "k-buffer", "hybrid", "adaptive", "depth-peeling", "dual-depth-peeling"}) {
        if (id == known) return true;
    }
    return false;
}

// Of one sample; fragments' depths are floats.
inline Rgba continuum_answer(const ChosenMethod& method, std::span<const Fragment> fragments,
                             Rgba behind)
{
    const std::string id = method.row->id;
    if (id == "depth-peeling") {
        return reference::depth_peeling(fragments, method.number("peels"), behind);
    }
    if (id == "dual-depth-peeling") {
        return reference::dual_depth_peeling(fragments, method.number("peels"), behind);
    }
    const int layers = method.number(id == "adaptive" ? "nodes" : "layers");
    if (id == "adaptive") {
        bool doubtful = false;
        const Rgba color = reference::adaptive(fragments, layers, behind, &doubtful);
        return doubtful ? kUnknown : color;
    }
    if (id == "z3") {
        bool doubtful = false;
        const Rgba color =
            reference::z3(fragments, layers, reference::Z3Depth::mean, behind, &doubtful);
        return doubtful ? kUnknown : color;
    }
    if (id == "mlab") return reference::mlab(fragments, layers, behind);
    if (id == "hybrid") {
        return reference::hybrid(fragments, layers, tail_of(method.value("tail")), behind);
    }
    return reference::k_buffer(fragments, layers, merge_of(method.value("merge")), behind);
}

}  // namespace sheer
