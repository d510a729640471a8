// The parameters of moment transparency.
#pragma once

#include <string>

#include "methods/method.h"
#include "shade/moment_part.h"

namespace sheer {

enum class MomentFormat { fp32, fp16, unorm16, nlqm };

struct MomentSettings {
    float overestimation;
    bool adapts;  // instead of that
    MomentFormat format;
    int passes;           // over the moments
    int reduction;        // pixels across that have the moments of one texel
    bool is_depth_aware;  // pixels add up two numbers of their own

    // The measure that is mixed in, for even powers 2 and 4, and how much of it.
    double bias, even2, even4;
};

inline MomentFormat moment_format(const std::string& name)
{
    if (name == "fp16") return MomentFormat::fp16;
    if (name == "unorm16") return MomentFormat::unorm16;
    return name == "nlqm" ? MomentFormat::nlqm : MomentFormat::fp32;
}

inline MomentSettings moment_settings(const ChosenMethod& method)
{
    MomentSettings s{};
    s.adapts = method.value("overestimation") == "adaptive";
    s.overestimation = s.adapts ? 0.0f : static_cast<float>(method.real("overestimation"));
    s.format = moment_format(method.value("format"));
    s.passes = method.number("moment-passes");
    const std::string& resolution = method.value("resolution");
    s.reduction = resolution == "1" ? 1 : std::stoi(resolution.substr(2));  // 1/N
    s.is_depth_aware = s.reduction > 1 && method.value("upsample") == "depth-aware";
    switch (s.format) {
        // Peters, Muenstermann, Wetzstein and Klein. Improved Moment Shadow Maps for Translucent
        // Occluders, Soft Shadows and Single Scattering. JCGT 6(1), 2017: of single precision, and
        // of 16 bits.
        case MomentFormat::fp32:
        case MomentFormat::nlqm:
            s.bias = kMomentBias;
            s.even2 = s.even4 = kMomentBiasEven;
            break;
        case MomentFormat::unorm16:
            s.bias = 6e-5;
            s.even2 = s.even4 = 0.628;
            break;
        // Halves below 1 are off by 2^-12 at most. That changes no eigenvalue of the matrix of
        // moments 0 to 4 by more than its largest sum of a row's errors, 2^-12 times 3; the least
        // one of the measure that is mixed in is 0.199.
        case MomentFormat::fp16:
            s.bias = 3 * 0x1p-12 / 0.199;
            s.even2 = s.even4 = 0.375;
            break;
    }
    return s;
}

}  // namespace sheer
