// The methods' times on one scene, measured in turns.
//
// Each round runs every method once (A B C, A B C, ...), so that a machine that slows down or is
// busy for a while does so for all of them. Beside those asked for there run `blend` and, where the
// scene has opaque surfaces, those alone: what base times are made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

namespace sheer {

// Of one value or more.
double median(std::vector<double> values);

struct TurnsRequest {
    std::vector<std::string> methods;      // ID[:NAME=VALUE]...
    int repeat = 11;                       // rounds, after one that isn't measured
    std::function<void(double)> progress;  // with the part done, in [0, 1]
};

// What was measured in round i is number i of all rounds.
struct Turns {
    std::vector<std::vector<Stats>> methods;  // the rounds of each, as asked for
    std::vector<Stats> blend;
    std::vector<Stats> opaque;  // without what is transparent; empty where nothing is opaque
    // Without MASK surfaces too, which are not opaque to methods that test them; empty where there
    // are no such methods or surfaces.
    std::vector<Stats> untested;
};

// Whether a method, ID[:NAME=VALUE]..., gets fragments of MASK surfaces and tests them itself.
bool tests_masks(const std::string& method);

// While it runs, the scene is without its transparent objects now and then. Throws Error as
// `render` does, and for what `choose_method` refuses.
Turns take_turns(Scene& scene, const View& view, const Options& options,
                 const TurnsRequest& request);

// One method, medians over the rounds; ratios are formed round by round.
struct Timing {
    Stats stats;
    std::size_t rounds;
    // That were there: the method's or those of `blend`, whichever are more. A method that leaves
    // out hidden triangles is not the slower for it.
    std::uint64_t fragments;
    double total_min, total_max;
    // Of what is opaque to the method, all of a frame but for shadow maps and resolve.
    double ms_opaque;
    double ms_fragments;     // geometry, raster and shade of what is transparent
    double ms_raster_store;  // raster, shade and store of what is transparent
    double ms_other;         // of the total what is none of those, nor shadow maps, nor the store
    double ms_base;          // NaN: nothing is transparent
    double ratio_to_blend;   // total times
    double ratio_to_base;    // the total time over the base time; NaN as that is
};

// The base time is that of one blended pass over all visible transparent geometry with full
// shading, shadow lookups too: `blend` without opaque surfaces, shadow maps and the final resolve.
// Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. IEEE TVCG 17(8), 2011, section 5.
std::vector<Timing> time_methods(const Turns& turns);

}  // namespace sheer
