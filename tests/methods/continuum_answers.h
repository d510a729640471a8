// What src/reference answers for the methods of the continuum.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "methods/method.h"
#include "reference/bucket_peeling.h"
#include "reference/deep_shadow.h"
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
    if (name == "total") return reference::HybridTail::total;
    return name == "none" ? reference::HybridTail::none : reference::HybridTail::scaled;
}

// Whether a place among `parts` of the range may be beyond a border: depths are rounded to floats,
// 2^-24 of the largest each, and one rounding of the difference, one of the range, one of their
// quotient and one of the product leave 2^-22 of `parts`. The ends of the range are none.
inline bool may_cross_border(std::span<const Fragment> fragments, int parts)
{
    if (fragments.empty()) return false;
    const auto [least, most] =
        std::minmax_element(fragments.begin(), fragments.end(),
                            [](const auto& a, const auto& b) { return a.depth < b.depth; });
    const double nearest = least->depth, range = most->depth - nearest;
    const double largest = std::max(std::abs(nearest), std::abs(most->depth));
    // Of the depth, and of both ends of the range.
    const double rounding = 0x1p-22 + 3 * 0x1p-24 * largest / range;
    return std::any_of(fragments.begin(), fragments.end(), [&](const Fragment& f) {
        const double at = (f.depth - nearest) / range * parts;
        const double border = std::round(at);
        return border > 0 && border < parts && std::abs(at - border) < parts * rounding;
    });
}

inline Rgba bucket_answer(const ChosenMethod& method, std::span<const Fragment> fragments,
                          Rgba behind)
{
    reference::BucketPeeling how;
    how.buckets = method.number("buckets");
    how.both_ends = false;
    how.passes = method.number("peels");
    how.bins = method.value("borders") == "adaptive" ? 1024 : 0;
    if (may_cross_border(fragments, how.bins > 0 ? how.bins : how.buckets)) return kUnknown;
    return reference::bucket_peeling(fragments, how, behind);
}

inline bool has_continuum_answer(const std::string& id)
{
    for (const char* known : {"mlab", "z3", "k-buffer", "hybrid", "adaptive", "depth-peeling",
                              "dual-depth-peeling", "bucket-peeling", "deep-shadow-map"}) {
        if (id == known) return true;
    }
    return false;
}

// Of curves without an error of their own.
inline Rgba deep_shadow_answer(const ChosenMethod& method, std::span<const Fragment> fragments,
                               Rgba behind)
{
    using reference::CurveResolve;
    const bool corrects = method.value("correction") == "on";
    Rgba color =
        reference::through_curve(fragments, reference::step_curve(fragments),
                                 corrects ? CurveResolve::corrected : CurveResolve::total, behind);
    color.a = reference::composite({fragments.begin(), fragments.end()}, behind).a;  // exact
    return color;
}

// Of one sample; fragments' depths are floats, but for those that peel.
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
    if (id == "bucket-peeling") return bucket_answer(method, fragments, behind);
    if (id == "deep-shadow-map") return deep_shadow_answer(method, fragments, behind);
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
