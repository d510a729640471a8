// What the parameters of the hashed methods say of thresholds.
#pragma once

#include "methods/method.h"

namespace sheer {

enum class HashVariant { isotropic, anisotropic, eight_corners };

// What becomes of thresholds from frame to frame.
enum class HashFrames { still, offsets, linear, alternating, van_der_corput };

struct HashedSettings {
    HashVariant variant;
    float hash_scale;  // cells, in pixels
    int hash;          // as shaders/sheer/hashed_threshold.glsl numbers them
    bool octaves = true, uniform = true, third = true;
    HashFrames frames = HashFrames::still;
};

inline HashFrames hash_frames(const ChosenMethod& method)
{
    const std::string& frames = method.value("frames");
    return frames == "still"         ? HashFrames::still
           : frames == "offsets"     ? HashFrames::offsets
           : frames == "linear"      ? HashFrames::linear
           : frames == "alternating" ? HashFrames::alternating
                                     : HashFrames::van_der_corput;
}

inline HashedSettings hashed_settings(const ChosenMethod& method)
{
    const std::string &variant = method.value("variant"), &hash = method.value("hash");
    const std::string& without = method.value("without");
    return {variant == "isotropic"     ? HashVariant::isotropic
            : variant == "anisotropic" ? HashVariant::anisotropic
                                       : HashVariant::eight_corners,
            static_cast<float>(method.real("hash-scale")),
            hash == "paper"     ? 0
            : hash == "pcg"     ? 1
            : hash == "lowbias" ? 2
                                : 3,
            without != "octaves",
            without != "uniform",
            without != "third",
            hash_frames(method)};
}

// Of hashed-alpha-test: the level from which on there is noise alone; 0: from the first.
inline float fade_in_levels(const ChosenMethod& method)
{
    const bool off = method.value("fade-in") == "off";
    return off ? 0.0f : static_cast<float>(method.real("fade-in"));
}

}  // namespace sheer
