// Layers treat all samples alike. So it is enough to know, layer by layer, how many samples are
// still uncovered: as many see the layer, and with what newly_covered says it takes some of them.
//
// Every estimator is a sum over layers, of terms that depend on those two numbers, and a last step
// that depends on what is left uncovered and, for D, on U1. Terms are written less what they are on
// average, or of colours less their mean, so that the sum is what is off from the truth and moments
// do not cancel.
#include "reference/stochastic_estimators.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <map>
#include <tuple>

#include "reference/raw_moments.h"

namespace sheer::reference {
namespace {

// One channel of the pixel.
struct Layer {
    double opacity, color;
    double visibility;  // vis(z)
};

struct Channel {
    std::vector<Layer> layers;  // nearest first
    double backdrop = 0;
    double transmittance = 1;  // T
    double transparent = 0;    // C without the backdrop's part
    int samples = 1;

    double total_alpha() const { return 1 - transmittance; }
    double mean_color() const { return total_alpha() > 0 ? transparent / total_alpha() : 0; }
    double truth() const { return transparent + transmittance * backdrop; }
};

Channel make_channel(const EstimatedPixel& pixel, std::size_t c)
{
    const double backdrop[] = {pixel.backdrop.r, pixel.backdrop.g, pixel.backdrop.b,
                               pixel.backdrop.a};
    std::vector<Fragment> sorted = pixel.fragments;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Fragment& a, const Fragment& b) {
        return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
    });
    Channel channel;
    channel.backdrop = backdrop[c];
    channel.samples = pixel.samples;
    for (const Fragment& fragment : sorted) {
        const double color = c < 3 ? fragment.color[c] : 1;
        channel.layers.push_back({fragment.opacity, color, channel.transmittance});
        channel.transparent += channel.transmittance * fragment.opacity * color;
        channel.transmittance *= 1 - fragment.opacity;
    }
    return channel;
}

// What a layer adds; parts of all samples see it and own it in the end.
double term(Estimator estimator, const Channel& channel, const Layer& layer, double seen,
            double owned)
{
    switch (estimator) {
        case Estimator::basic: return owned * (layer.color - channel.truth());
        case Estimator::alpha_corrected: return owned * (layer.color - channel.mean_color());
        case Estimator::depth_based:
        case Estimator::depth_based_clamped:
        case Estimator::depth_based_empty:
            return (seen - layer.visibility) * layer.opacity * layer.color;
        case Estimator::depth_based_remainder:
            return (seen - layer.visibility) * layer.opacity * (layer.color - channel.backdrop);
        case Estimator::depth_corrected:
            return seen * layer.opacity * (layer.color - channel.mean_color());
        case Estimator::depth_over_coverage: return seen * layer.opacity * layer.color;
    }
    return 0;
}

// A case: how many samples are uncovered, and how many saw layers of each kind, added up.
struct Situation {
    int uncovered = 0;
    std::vector<int> seen;
    auto operator<=>(const Situation&) const = default;
};

// Layers of one kind count alike in what the last step must know.
struct Kinds {
    std::vector<double> values;       // of each kind: an opacity, or a weight
    std::vector<std::size_t> layers;  // the kind of each; kUncounted where it does not matter
};
constexpr std::size_t kUncounted = ~std::size_t{0};

Kinds make_kinds(Estimator estimator, const Channel& channel)
{
    Kinds kinds;
    const bool clamped = estimator == Estimator::depth_based_clamped;
    for (const Layer& layer : channel.layers) {
        const double value = layer.opacity * (clamped ? layer.color : 1);
        if (value == 0 || (!clamped && estimator != Estimator::depth_corrected)) {
            kinds.layers.push_back(kUncounted);
            continue;
        }
        const auto found = std::find(kinds.values.begin(), kinds.values.end(), value);
        kinds.layers.push_back(static_cast<std::size_t>(found - kinds.values.begin()));
        if (found == kinds.values.end()) kinds.values.push_back(value);
    }
    return kinds;
}

using Cases = std::map<Situation, RawMoments>;  // of the sum of terms

Cases behind_all_layers(Estimator estimator, const Channel& channel, const Kinds& kinds,
                        Masks masks)
{
    const double s = channel.samples;
    Cases cases = {{{channel.samples, std::vector<int>(kinds.values.size(), 0)}, {1, 0, 0, 0, 0}}};
    for (std::size_t i = 0; i < channel.layers.size(); ++i) {
        const Layer& layer = channel.layers[i];
        std::vector<std::vector<double>> chances;  // by the number of uncovered samples
        for (int u = 0; u <= channel.samples; ++u) {
            chances.push_back(newly_covered(u, layer.opacity, masks, channel.samples));
        }
        Cases next;
        for (const auto& [situation, raw] : cases) {
            const int u = situation.uncovered;
            Situation then = situation;
            if (kinds.layers[i] != kUncounted) then.seen[kinds.layers[i]] += u;
            for (int k = 0; k <= u; ++k) {
                const double chance =
                    chances[static_cast<std::size_t>(u)][static_cast<std::size_t>(k)];
                if (chance == 0) continue;
                then.uncovered = u - k;
                add_scaled(next[then], chance,
                           shift(raw, term(estimator, channel, layer, u / s, k / s)));
            }
        }
        cases = std::move(next);
    }
    return cases;
}

// The moments of what the pixel is off from the truth.
RawMoments last_step(Estimator estimator, const Channel& channel, const Kinds& kinds,
                     const Situation& situation, const RawMoments& raw)
{
    const double empty = static_cast<double>(situation.uncovered) / channel.samples;
    const RawMoments nothing = shift({raw[0], 0, 0, 0, 0}, -channel.transparent);
    switch (estimator) {
        case Estimator::basic: return shift(raw, empty * (channel.backdrop - channel.truth()));
        case Estimator::depth_based:
        case Estimator::depth_based_remainder: return raw;
        case Estimator::depth_based_empty:
            return shift(raw, (empty - channel.transmittance) * channel.backdrop);
        case Estimator::depth_based_clamped: {
            // The case tells all about the sum: it is its own mean.
            const double off = raw[0] > 0 ? raw[1] / raw[0] : 0;
            const double clamped = std::clamp(channel.truth() + off, 0.0, 1.0);
            return shift({raw[0], 0, 0, 0, 0}, clamped - channel.truth());
        }
        case Estimator::alpha_corrected:
            return empty < 1 ? stretch(raw, channel.total_alpha() / (1 - empty)) : nothing;
        case Estimator::depth_over_coverage:
            return empty < 1 ? shift(stretch(raw, channel.total_alpha() / (1 - empty)),
                                     -channel.transparent)
                             : nothing;
        case Estimator::depth_corrected: {
            double u1 = 0;
            for (std::size_t k = 0; k < kinds.values.size(); ++k) {
                u1 += kinds.values[k] * situation.seen[k] / channel.samples;
            }
            return u1 > 0 ? stretch(raw, channel.total_alpha() / u1) : nothing;
        }
    }
    return nothing;
}

}  // namespace

std::array<Moments, 4> estimate(Estimator estimator, const EstimatedPixel& pixel, Masks masks)
{
    std::array<Moments, 4> result;
    for (std::size_t c = 0; c < result.size(); ++c) {
        const Channel channel = make_channel(pixel, c);
        const Kinds kinds = make_kinds(estimator, channel);
        RawMoments total = {};
        for (const auto& [situation, raw] : behind_all_layers(estimator, channel, kinds, masks)) {
            add_scaled(total, 1, last_step(estimator, channel, kinds, situation, raw));
        }
        result[c] = central(total, channel.truth());
    }
    return result;
}

double rms_error(const Moments& moments, double truth)
{
    const double bias = moments.mean - truth;
    return std::sqrt(moments.variance + bias * bias);
}

}  // namespace sheer::reference
