// Where the exact picture jumps: places at which a rounding of the renderer's floats may pick
// another order, another side of an opaque surface or of a cutoff, or another texel than doubles
// do. Comparisons leave those pixels to a looser test. What counts is docs/numerics.md,
// "Visibility".
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

// How much a sample changes at most, for a backdrop of 1, by a transparent surface's presence.
double presence_of(const Surface& surface)
{
    const double* t = surface.transmittance;
    return std::max({surface.opacity, 1 - t[0], 1 - t[1], 1 - t[2]});
}

// e_a + T_a e_b less e_b + T_b e_a, by which two surfaces' order shows; e = opacity color. It is
// opacity_a opacity_b (color_a - color_b) where T = 1 - opacity.
double swap_difference(const Surface& a, const Surface& b)
{
    double largest = 0;
    for (int c = 0; c < 3; ++c) {
        const double first = a.opacity * a.color[c] * (1 - b.transmittance[c]);
        const double second = b.opacity * b.color[c] * (1 - a.transmittance[c]);
        largest = std::max(largest, std::abs(first - second));
    }
    return largest;
}

// Of the surfaces so far, in the channel that lets most through.
struct Remaining {
    double channels[3] = {1, 1, 1};

    void pass(const Surface& surface)
    {
        for (int c = 0; c < 3; ++c) {
            channels[c] *= surface.transmittance[c];
        }
    }
    double most() const { return std::max({channels[0], channels[1], channels[2]}); }
};

// Depths further apart than this cannot swap, whichever of the list's triangles they belong to.
double widest_tolerance(const std::vector<Sighting>& sightings)
{
    double largest = 0;
    for (const Sighting& sighting : sightings) {
        largest = std::max(largest, largest_depth(*sighting.surface->triangle));
    }
    return kDepthRounding * largest;
}

// Swapping two neighbours of the sorted list changes the sample by T times swap_difference; the T
// before the nearer one bounds what is between two that are no neighbours.
bool order_may_change(const std::vector<Sighting>& visible)
{
    const double reach = widest_tolerance(visible);
    Remaining remaining;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        const Surface& near = *visible[i].surface;
        for (std::size_t j = i + 1; j < visible.size(); ++j) {
            if (visible[j].depth - visible[i].depth > reach) {
                break;
            }
            const Surface& far = *visible[j].surface;
            const double change = remaining.most() * swap_difference(near, far);
            if (change > kInvisibleChange && may_swap(visible[i], visible[j])) {
                return true;
            }
        }
        remaining.pass(near);
    }
    return false;
}

double transmittance_before(const std::vector<Sighting>& visible, const Sighting& sighting)
{
    Remaining remaining;
    for (const Sighting& other : visible) {
        if (in_front(other, sighting)) {
            remaining.pass(*other.surface);
        }
    }
    return remaining.most();
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
           transmittance_before(view.visible, sighting) * presence_of(*sighting.surface) >
               kInvisibleChange;
}

bool is_seen(const SampleView& view, const Sighting& sighting)
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
        if (is_seen(view, sighting)) {
            flags |= sighting.surface->discontinuities;
        }
    }
    return static_cast<std::uint8_t>(flags);
}

}  // namespace sheer::reference
