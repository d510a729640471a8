// All masks of all layers, one after another, and the paper's formulas as they stand, sample by
// sample.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "reference/raw_moments.h"
#include "reference/stochastic_estimators.h"

namespace sheer::reference {
namespace {

using Channels = std::array<double, 4>;

Channels channels(const Fragment& fragment)
{
    return {fragment.color[0], fragment.color[1], fragment.color[2], 1};
}

// Sums over the samples of what section 4 of the paper calls B, B1, U and U1, divided by S.
struct Sums {
    Channels b = {}, u = {};
    double b1 = 0, u1 = 0;
};

// The nearest fragment whose mask has the sample; as many as there are fragments if it is empty.
std::size_t winner(const std::vector<unsigned>& masks, int sample)
{
    const auto has_it = [sample](unsigned mask) { return (mask >> sample & 1) != 0; };
    return static_cast<std::size_t>(std::find_if(masks.begin(), masks.end(), has_it) -
                                    masks.begin());
}

Sums sum_over_samples(const EstimatedPixel& pixel, const std::vector<unsigned>& masks)
{
    Sums sums;
    const double s = pixel.samples;
    for (int sample = 0; sample < pixel.samples; ++sample) {
        const std::size_t w = winner(masks, sample);
        for (std::size_t i = 0; i < pixel.fragments.size() && i <= w; ++i) {
            const Fragment& fragment = pixel.fragments[i];
            const Channels color = channels(fragment);
            for (std::size_t c = 0; c < 4; ++c) {
                sums.u[c] += fragment.opacity * color[c] / s;
                if (i == w) sums.b[c] += color[c] / s;
            }
            sums.u1 += fragment.opacity / s;
            if (i == w) sums.b1 += 1 / s;
        }
    }
    return sums;
}

double pixel_value(Estimator estimator, const Sums& sums, double transmittance, double backdrop,
                   std::size_t c)
{
    const double alpha = 1 - transmittance;
    switch (estimator) {
        case Estimator::basic: return sums.b[c] + (1 - sums.b1) * backdrop;
        case Estimator::alpha_corrected:
            return (sums.b1 > 0 ? alpha * sums.b[c] / sums.b1 : 0) + transmittance * backdrop;
        case Estimator::depth_based: return sums.u[c] + transmittance * backdrop;
        case Estimator::depth_based_clamped:
            return std::clamp(sums.u[c] + transmittance * backdrop, 0.0, 1.0);
        case Estimator::depth_based_empty: return sums.u[c] + (1 - sums.b1) * backdrop;
        case Estimator::depth_based_remainder: return sums.u[c] + (1 - sums.u1) * backdrop;
        case Estimator::depth_corrected:
            return (sums.u1 > 0 ? alpha * sums.u[c] / sums.u1 : 0) + transmittance * backdrop;
        case Estimator::depth_over_coverage:
            return (sums.b1 > 0 ? alpha * sums.u[c] / sums.b1 : 0) + transmittance * backdrop;
    }
    return 0;
}

double fraction(double x)
{
    return x - std::floor(x);
}

// Of R = floor(opacity S + xi) being `count`.
double count_chance(int count, double opacity, int samples)
{
    const double fewer = std::floor(opacity * samples);
    if (count == fewer) return 1 - fraction(opacity * samples);
    return count == fewer + 1 ? fraction(opacity * samples) : 0;
}

struct Listing {
    Estimator estimator;
    EstimatedPixel pixel;  // nearest first
    MaskChance chance;
    double transmittance = 1;
    Channels origin = {}, backdrop = {};
    std::array<RawMoments, 4> total = {};
};

void list(Listing& listing, std::vector<unsigned>& masks, double probability)
{
    const EstimatedPixel& pixel = listing.pixel;
    if (masks.size() == pixel.fragments.size()) {
        const Sums sums = sum_over_samples(pixel, masks);
        for (std::size_t c = 0; c < 4; ++c) {
            const double value =
                pixel_value(listing.estimator, sums, listing.transmittance, listing.backdrop[c], c);
            add_scaled(listing.total[c], probability,
                       shift({1, 0, 0, 0, 0}, value - listing.origin[c]));
        }
        return;
    }
    const double opacity = pixel.fragments[masks.size()].opacity;
    for (unsigned mask = 0; mask >> pixel.samples == 0; ++mask) {
        const double chance = listing.chance(mask, opacity, pixel.samples);
        if (chance == 0) continue;
        masks.push_back(mask);
        list(listing, masks, probability * chance);
        masks.pop_back();
    }
}

}  // namespace

double naive_chance(unsigned mask, double opacity, int samples)
{
    const int kept = std::popcount(mask);
    return std::pow(opacity, kept) * std::pow(1 - opacity, samples - kept);
}

double stratified_chance(unsigned mask, double opacity, int samples)
{
    const int kept = std::popcount(mask);
    double sets = 1;  // of that size
    for (int i = 0; i < kept; ++i) sets = sets * (samples - i) / (i + 1);
    return count_chance(kept, opacity, samples) / sets;
}

double contiguous_chance(unsigned mask, double opacity, int samples)
{
    const int kept = std::popcount(mask);
    const double chance = count_chance(kept, opacity, samples);
    if (kept == 0 || kept == samples) return chance;
    const unsigned turned = (mask << 1 | mask >> (samples - 1)) & ((1u << samples) - 1);
    const bool is_one_run = std::popcount(mask & ~turned) == 1;  // it begins once
    return is_one_run ? chance / samples : 0;
}

std::array<Moments, 4> estimate_by_listing(Estimator estimator, const EstimatedPixel& pixel,
                                           MaskChance chance)
{
    Listing listing{estimator, pixel, chance};
    auto& fragments = listing.pixel.fragments;
    std::stable_sort(fragments.begin(), fragments.end(), [](const Fragment& a, const Fragment& b) {
        return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
    });
    for (const Fragment& fragment : fragments) listing.transmittance *= 1 - fragment.opacity;
    const Rgba over = composite(fragments, pixel.backdrop);
    listing.origin = {over.r, over.g, over.b, over.a};
    listing.backdrop = {pixel.backdrop.r, pixel.backdrop.g, pixel.backdrop.b, pixel.backdrop.a};
    std::vector<unsigned> masks;
    list(listing, masks, 1);
    std::array<Moments, 4> result;
    for (std::size_t c = 0; c < 4; ++c) {
        result[c] = central(listing.total[c], listing.origin[c]);
    }
    return result;
}

}  // namespace sheer::reference
