// Exact moments of stochastic transparency: E. Enderton et al., "Stochastic transparency", 2010, by
// dynamic programming over the number of samples that the layers so far left uncovered, instead of
// by listing masks.
#include "reference/methods.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "reference/raw_moments.h"

namespace sheer::reference {
namespace {

constexpr std::size_t kChannels = 4;

using State = std::array<RawMoments, kChannels>;

std::array<double, kChannels> channels(const Rgba& color)
{
    return {color.r, color.g, color.b, color.a};
}

// n over 0, 1, ..., n.
std::vector<double> binomials(std::size_t n)
{
    std::vector<double> row(n + 1, 1.0);
    for (std::size_t k = 1; k <= n; ++k) {
        row[k] = row[k - 1] * static_cast<double>(n - k + 1) / static_cast<double>(k);
    }
    return row;
}

// By the number of samples that are still uncovered. All layers treat the samples alike, so nothing
// else about the masks so far matters.
using States = std::vector<State>;

States behind(const Fragment& fragment, const States& states,
              const std::array<double, kChannels>& origin, Masks masks)
{
    const auto color = channels({fragment.color[0], fragment.color[1], fragment.color[2], 1});
    const int samples = static_cast<int>(states.size()) - 1;
    States next(states.size());
    for (std::size_t u = 0; u < states.size(); ++u) {
        const auto chance = newly_covered(static_cast<int>(u), fragment.opacity, masks, samples);
        for (std::size_t k = 0; k <= u; ++k) {
            const double fraction = static_cast<double>(k) / samples;
            for (std::size_t i = 0; i < kChannels; ++i) {
                add_scaled(next[u - k][i], chance[k],
                           shift(states[u][i], fraction * (color[i] - origin[i])));
            }
        }
    }
    return next;
}

}  // namespace

std::vector<double> newly_covered(int uncovered, double opacity, Masks masks, int samples)
{
    const auto u = static_cast<std::size_t>(uncovered);
    const auto s = static_cast<std::size_t>(samples);
    const std::vector<double> of_u = binomials(u);
    std::vector<double> probability(u + 1, 0.0);
    if (masks == Masks::naive) {
        for (std::size_t k = 0; k <= u; ++k) {
            probability[k] = of_u[k] * std::pow(opacity, static_cast<double>(k)) *
                             std::pow(1 - opacity, static_cast<double>(u - k));
        }
        return probability;
    }
    const std::vector<double> of_rest = binomials(s - u);
    const std::vector<double> of_s = binomials(s);
    const double fewer = std::floor(opacity * samples);
    const double fraction = opacity * samples - fewer;
    for (const auto& [chosen, chance] :
         {std::pair(fewer, 1 - fraction), std::pair(fewer + 1, fraction)}) {
        const auto r = static_cast<std::size_t>(chosen);
        for (std::size_t k = 0; chance > 0 && k <= std::min(u, r); ++k) {
            if (r - k <= s - u) {
                probability[k] += chance * of_u[k] * of_rest[r - k] / of_s[r];
            }
        }
    }
    return probability;
}

std::vector<Moments> uncovered(std::span<const double> opacities, Masks masks, int samples)
{
    std::vector<Moments> result;
    std::vector<double> probability(static_cast<std::size_t>(samples) + 1, 0.0);
    probability.back() = 1;
    for (const double opacity : opacities) {
        std::vector<double> next(probability.size(), 0.0);
        for (std::size_t u = 0; u < probability.size(); ++u) {
            const auto chance = newly_covered(static_cast<int>(u), opacity, masks, samples);
            for (std::size_t k = 0; k <= u; ++k) {
                next[u - k] += probability[u] * chance[k];
            }
        }
        probability = std::move(next);
        Moments moments;
        for (std::size_t u = 0; u < probability.size(); ++u) {
            moments.mean += probability[u] * static_cast<double>(u) / samples;
        }
        for (std::size_t u = 0; u < probability.size(); ++u) {
            const double off = static_cast<double>(u) / samples - moments.mean;
            moments.variance += probability[u] * off * off;
            moments.fourth += probability[u] * off * off * off * off;
        }
        result.push_back(moments);
    }
    return result;
}

std::array<Moments, 4> stochastic(std::vector<Fragment> fragments, Masks masks, int samples,
                                  Rgba backdrop)
{
    std::stable_sort(fragments.begin(), fragments.end(), [](const Fragment& a, const Fragment& b) {
        return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
    });
    // The samples' weights sum to one, so what is subtracted from every colour is subtracted from
    // the pixel. About the mean, central moments do not cancel; the method has no bias, so that is
    // `over`.
    const auto origin = channels(composite(fragments, backdrop));
    States states(static_cast<std::size_t>(samples) + 1);
    for (RawMoments& raw : states.back()) {
        raw = {1, 0, 0, 0, 0};
    }
    for (const Fragment& fragment : fragments) {
        states = behind(fragment, states, origin, masks);
    }
    std::array<Moments, 4> result;
    const auto last = channels(backdrop);
    for (std::size_t i = 0; i < kChannels; ++i) {
        RawMoments total = {};
        for (std::size_t u = 0; u < states.size(); ++u) {
            const double fraction = static_cast<double>(u) / samples;
            add_scaled(total, 1, shift(states[u][i], fraction * (last[i] - origin[i])));
        }
        result[i] = central(total, origin[i]);
    }
    return result;
}

}  // namespace sheer::reference
