// What the parameters of `stochastic` say of masks.
#pragma once

#include "methods/method.h"

namespace sheer {

enum class MaskKind { naive, stratified, table };
enum class SeedBy { depth, primitive, object, object_alone };

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
    settings.passes = method.number("sample-passes");
    settings.joint = method.value("pass-masks") == "joint";
    settings.samples = samples;
    return settings;
}

}  // namespace sheer
