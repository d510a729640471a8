// What a pixel's samples show when it has one function of transmittance, by the function's text.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "methods/depth_range.h"
#include "methods/tile_fixture.h"
#include "methods/transmittance_functions.h"

namespace sheer::test {

// What lies over a pixel in the paper's sense: each fragment with the part that it covers.
struct CoveringFragments {
    std::vector<float> places, parts;
};

inline CoveringFragments fragments_over(const Plates& plates, const Setting& setting,
                                        std::size_t used)
{
    const DepthRange range = depth_range(setting.eye, true);
    CoveringFragments f;
    for (const Plate& plate : plates) {
        const float depth = depth_at_center(plate.depth, tile_pixel(used));
        f.places.push_back(
            FloatText::warped_depth(range.is_distance, depth, range.from, range.scale));
        const auto covered = plate.samples[used] & setting.set->all();
        f.parts.push_back(static_cast<float>(std::popcount(covered)) /
                          static_cast<float>(setting.set->count));
    }
    return f;
}

// The sums over what covers the pixel, and what is made of them.
inline State state_over(const Plates& plates, const CoveringFragments& f,
                        const TransmittanceFunction& function)
{
    State state;
    for (int pass = 0; pass < function.passes(); ++pass) {
        Sums sums(function.sums());
        for (std::size_t i = 0; i < plates.size(); ++i) {
            const float seen = pass == 0 ? 1 : function.transmittance(state, f.places[i]);
            const float depth = FloatText::optical_depth(plates[i].color[3] * seen);
            function.add(sums, f.places[i], depth * f.parts[i]);
        }
        state = pass == 0 ? function.prepare(sums) : function.prepare_again(state, sums);
    }
    return state;
}

// The colour that is scaled to each sample's total alpha.
inline std::array<double, 3> mean_color(const Plates& plates, const CoveringFragments& f,
                                        const TransmittanceFunction& function, const State& state)
{
    double sum[3] = {}, weight = 0;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        const auto through =
            static_cast<double>(std::max(function.transmittance(state, f.places[i]), 0x1p-30f));
        const double w =
            through * static_cast<double>(plates[i].color[3]) * static_cast<double>(f.parts[i]);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += w * static_cast<double>(plates[i].color[c]);
        weight += w;
    }
    const double divisor = weight > 0 ? weight : 1;
    return {sum[0] / divisor, sum[1] / divisor, sum[2] / divisor};
}

// How far at most a sample of the pixel is from its total alpha of that colour over the backdrop.
inline double largest_error(const Plates& plates, const Setting& setting, std::size_t used,
                            const std::array<double, 3>& color, const Colors& backdrop,
                            const Colors& result)
{
    double most = 0;
    for (std::size_t s = 0; s < static_cast<std::size_t>(setting.set->count); ++s) {
        double through = 1;
        for (const Plate& plate : plates) {
            if ((plate.samples[used] >> s & 1) == 0) continue;
            through *= 1 - static_cast<double>(plate.color[3]);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = color_index(*setting.set, tile_pixel(used), s, c);
            const double expected =
                (1 - through) * color[c] + through * static_cast<double>(backdrop[at]);
            most = std::max(most, std::abs(static_cast<double>(result[at]) - expected));
        }
    }
    return most;
}

}  // namespace sheer::test
