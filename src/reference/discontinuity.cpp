// Where the exact picture jumps: places at which a rounding of the renderer's floats may pick
// another order, or another side of an opaque surface or of a cutoff, than doubles do. Comparisons
// leave those pixels to a looser test. What counts is docs/numerics.md, "Visibility".
#include <algorithm>
#include <cmath>

#include "reference/fragments.h"

namespace sheer::reference {

namespace {

// The renderer's depth is a sum of three floats: its error is some half ulps, 6e-8 of the largest
// of the triangle's depths each, however small the sum. This leaves room for sixteen of them.
constexpr double kDepthRounding = 1e-6;

// Less than one ulp of a float near 1: such a change of a sample cannot be told from rounding.
constexpr double kInvisibleChange = 1e-7;

double largest_depth(const Triangle& t)
{
    return std::max({std::abs(t.depth[0]), std::abs(t.depth[1]), std::abs(t.depth[2])});
}

double depth_tolerance(const Triangle& a, const Triangle& b)
{
    return kDepthRounding * std::max(largest_depth(a), largest_depth(b));
}

bool has_constant_depth(const Triangle& t)
{
    return t.depth[0] == t.depth[1] && t.depth[0] == t.depth[2];
}

bool have_same_corners(const Triangle& a, const Triangle& b)
{
    return std::equal(a.x, a.x + 3, b.x) && std::equal(a.y, a.y + 3, b.y) &&
           std::equal(a.depth, a.depth + 3, b.depth);
}

// Constant depths come out of float arithmetic unrounded, and equal corners give equal roundings:
// there the order is certain even of a tie.
bool may_swap(const Sighting& a, const Sighting& b)
{
    const Triangle& ta = *a.surface->triangle;
    const Triangle& tb = *b.surface->triangle;
    return std::abs(a.depth - b.depth) < depth_tolerance(ta, tb) &&
           !(has_constant_depth(ta) && has_constant_depth(tb)) && !have_same_corners(ta, tb);
}

double color_difference(const Surface& a, const Surface& b)
{
    return std::max({std::abs(a.color[0] - b.color[0]), std::abs(a.color[1] - b.color[1]),
                     std::abs(a.color[2] - b.color[2])});
}

// Depths further apart than this cannot swap, whichever of the list's triangles they belong to.
double widest_tolerance(const std::vector<Sighting>& sightings)
{
    double largest = 0;
    for (const Sighting& sighting : sightings) {
        largest = std::max(largest, largest_depth(*sighting.surface->triangle));
    }
    return kDepthRounding * largest;
}

// Swapping two neighbours of the sorted list changes the sample by T a_i a_j (c_i - c_j); the T
// before the nearer one bounds what is between two that are no neighbours.
bool order_may_change(const std::vector<Sighting>& visible)
{
    const double reach = widest_tolerance(visible);
    double transmittance = 1;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        const Surface& near = *visible[i].surface;
        for (std::size_t j = i + 1; j < visible.size(); ++j) {
            if (visible[j].depth - visible[i].depth > reach) {
                break;
            }
            const Surface& far = *visible[j].surface;
            const double change =
                transmittance * near.opacity * far.opacity * color_difference(near, far);
            if (change > kInvisibleChange && may_swap(visible[i], visible[j])) {
                return true;
            }
        }
        transmittance *= 1 - near.opacity;
    }
    return false;
}

double transmittance_before(const std::vector<Sighting>& visible, const Sighting& sighting)
{
    double transmittance = 1;
    for (const Sighting& other : visible) {
        if (in_front(other, sighting)) {
            transmittance *= 1 - other.surface->opacity;
        }
    }
    return transmittance;
}

bool winner_may_change(const SampleView& view)
{
    const Sighting& winner = view.opaque.front();
    const double transmittance = transmittance_before(view.visible, winner);
    return std::any_of(view.opaque.begin() + 1, view.opaque.end(), [&](const Sighting& other) {
        const double change = transmittance * color_difference(*winner.surface, *other.surface);
        return change > kInvisibleChange && may_swap(winner, other);
    });
}

// A transparent surface that rounding may put on the other side of the opaque one.
bool may_cross(const SampleView& view, const Sighting& sighting)
{
    return may_swap(sighting, view.opaque.front()) &&
           transmittance_before(view.visible, sighting) * sighting.surface->opacity >
               kInvisibleChange;
}

bool cutoff_matters(const SampleView& view, const Sighting& sighting)
{
    const bool behind_opaque = !view.opaque.empty() && in_front(view.opaque.front(), sighting) &&
                               !may_swap(view.opaque.front(), sighting);
    return !behind_opaque && transmittance_before(view.visible, sighting) > kInvisibleChange;
}

}  // namespace

std::uint8_t discontinuities(const SampleView& view)
{
    int flags = 0;
    if (order_may_change(view.visible)) {
        flags |= kDepthsWithinRounding;
    }
    if (!view.opaque.empty()) {
        const auto crosses = [&](const Sighting& sighting) { return may_cross(view, sighting); };
        if (winner_may_change(view)) {
            flags |= kDepthsWithinRounding;
        }
        if (std::any_of(view.visible.begin(), view.visible.end(), crosses) ||
            std::any_of(view.hidden.begin(), view.hidden.end(), crosses)) {
            flags |= kCoplanarWithOpaque;
        }
    }
    for (const Sighting& sighting : view.undecided) {
        if (cutoff_matters(view, sighting)) {
            flags |= kOpacityAtCutoff;
        }
    }
    return static_cast<std::uint8_t>(flags);
}

}  // namespace sheer::reference
