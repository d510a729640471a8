// What a method divides after the filter.
#pragma once

#include <array>

#include <sheer/image.h>

#include "lanes/lone.h"

namespace sheer {

struct QuotientText {
    using L = Lone<float>;
#include "lanes/text_words.h"
#include "sheer/alpha_correction.glsl"
};

// Of a sum of colours, its weight and total alpha: what is added to the dimmed background, and
// total alpha again.
inline Float4 quotient(const std::array<float, 5>& fraction)
{
    const auto& [red, green, blue, weight, total_alpha] = fraction;
    const auto corrected = QuotientText::alpha_corrected({red, green, blue}, weight, total_alpha);
    return {corrected.x, corrected.y, corrected.z, total_alpha};
}

}  // namespace sheer
