// What the parameters of `stochastic` say, and of `stratified-stochastic`, which is its basic
// method in one pass with tracked masks.
#pragma once

#include <string_view>

#include "methods/method.h"

namespace sheer {

// How samples become a picture.
struct StochasticSettings {
    bool corrects = false;  // alpha
    int passes = 1;         // of the samples
    bool joint = true;      // their masks are stratified together; tracked ones of frames, too
};

inline StochasticSettings stochastic_settings(const ChosenMethod& method)
{
    if (method.row->id != std::string_view("stochastic")) {
        return {.joint = method.value("frames") == "joint"};
    }
    return {method.value("correction") == "on", method.number("sample-passes"),
            method.value("pass-masks") == "joint"};
}

enum class MaskKind { naive, stratified, table };
enum class SeedBy { depth, primitive, object, object_alone };

// Of masks that are not tracked.
struct MaskSettings {
    MaskKind masks;
    SeedBy seed_by;
    bool dithered;      // xi, across a tile
    bool depth_before;  // the samples that lose the depth test are left out before R is drawn
    int passes;         // of the samples
    bool joint;         // their masks are parts of one
    int samples;        // of one pass

    int mask_samples() const { return joint ? samples * passes : samples; }
};

inline MaskSettings mask_settings(const ChosenMethod& method, int samples)
{
    const std::string &masks = method.value("masks"), &seed_by = method.value("seed-by");
    MaskSettings settings{};
    settings.masks = masks == "naive"   ? MaskKind::naive
                     : masks == "table" ? MaskKind::table
                                        : MaskKind::stratified;
    settings.seed_by = seed_by == "depth"       ? SeedBy::depth
                       : seed_by == "primitive" ? SeedBy::primitive
                       : seed_by == "object"    ? SeedBy::object
                                                : SeedBy::object_alone;
    settings.dithered = method.value("round") == "tile-dither";
    // Samples that are chosen each for itself do not know of the others' depths.
    settings.depth_before =
        method.value("depth-test") == "before" && settings.masks != MaskKind::naive;
    const StochasticSettings all = stochastic_settings(method);
    settings.passes = all.passes;
    settings.joint = all.joint;
    settings.samples = samples;
    return settings;
}

}  // namespace sheer
