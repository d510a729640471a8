// What the parameters of `slab` say.
#pragma once

#include "methods/method.h"

namespace sheer {

inline constexpr int kSlabCandidates = 32;  // of which those to be kept are sampled in depth

enum class SlabKeep { purged, visible, nearest };

struct SlabSettings {
    int layers;
    int bits;  // 0: more than any number
    bool is_explicit;
    bool stratified;  // implicit coverage: the bits that there would be
    bool in_depth;    // implicit coverage: layers are sampled in the order of depth
    SlabKeep keep;
    bool depth_based;  // or layers have colours
    bool adds_tail;  // depth based: of fragments behind the last of as many layers as there may be
    bool corrects;   // alpha

    bool is_endless() const { return bits == 0; }
    // Of bits without number only opacity is left.
    bool has_masks() const { return is_explicit && !is_endless(); }
    // Layers are asked whether they are seen: when they arrive, and again when others do.
    bool asks() const { return keep != SlabKeep::nearest && !in_depth && !is_endless(); }
    bool asks_again() const { return asks() && keep == SlabKeep::purged; }
    // What is kept and what each pass adds do not depend on the order of arrival.
    bool keeps_in_any_order() const
    {
        if (in_depth || is_endless() || keep == SlabKeep::nearest || layers == 1) return true;
        return is_explicit && (bits == 1 || (keep == SlabKeep::purged && layers >= bits));
    }
};

inline SlabSettings slab_settings(const ChosenMethod& method)
{
    const std::string &bits = method.value("bits"), &keep = method.value("keep");
    SlabSettings settings{};
    settings.layers = method.number("layers");
    settings.bits = bits == "infinity" ? 0 : method.number("bits");
    settings.is_explicit = method.value("coverage") == "explicit";
    settings.stratified = method.value("probability") == "stratified";
    settings.in_depth = method.value("sampling") == "in-depth";
    settings.keep = keep == "purged"    ? SlabKeep::purged
                    : keep == "visible" ? SlabKeep::visible
                                        : SlabKeep::nearest;
    settings.depth_based = method.value("depth-based") == "on";
    settings.adds_tail = method.value("tail") == "added";
    settings.corrects = method.value("correction") == "on";
    return settings;
}

// Words of 32 bits that a layer's mask takes: 1, 2 or 4.
inline int slab_mask_words(int bits)
{
    return bits <= 32 ? 1 : bits <= 64 ? 2 : 4;
}

}  // namespace sheer
