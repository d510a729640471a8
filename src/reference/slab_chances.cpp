// Chances of insertion, and moments over everything that is left to chance.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>

#include "reference/raw_moments.h"
#include "reference/slab.h"

namespace sheer::reference {
namespace {

// Sums over cases; the truth is taken off first, so that moments do not cancel.
class Cases {
public:
    Cases(std::span<const Fragment> fragments, SlabResolve resolve, Rgba backdrop)
        : fragments_(fragments), resolve_(resolve), backdrop_(backdrop), kept_(fragments.size())
    {
        origin_ = composite({fragments.begin(), fragments.end()}, backdrop);
    }

    void add(const SlabStore& store, double probability)
    {
        const Rgba got = slab(fragments_, store, resolve_, backdrop_);
        const double off[] = {got.r - origin_.r, got.g - origin_.g, got.b - origin_.b,
                              got.a - origin_.a};
        for (std::size_t c = 0; c < 4; ++c) {
            add_scaled(raw_[c], probability, shift({1, 0, 0, 0, 0}, off[c]));
        }
        for (const SlabLayer& layer : store.layers) {
            for (std::size_t i = 0; i < fragments_.size(); ++i) {
                const Fragment& f = fragments_[i];
                if (f.depth == layer.depth && f.id == layer.id) kept_[i] += probability;
            }
        }
    }

    SlabMoments moments() const
    {
        const double origin[] = {origin_.r, origin_.g, origin_.b, origin_.a};
        SlabMoments result{{}, kept_};
        for (std::size_t c = 0; c < 4; ++c) result.channels[c] = central(raw_[c], origin[c]);
        return result;
    }

private:
    std::span<const Fragment> fragments_;
    SlabResolve resolve_;
    Rgba backdrop_, origin_;
    std::array<RawMoments, 4> raw_ = {};
    std::vector<double> kept_;
};

struct RoundedBits {
    int bits;
    double probability;
};

std::array<RoundedBits, 2> round_bits(double bits, SlabRounding rounding)
{
    const int down = static_cast<int>(std::floor(bits)), up = static_cast<int>(std::ceil(bits));
    const double fraction = bits - down;
    switch (rounding) {
        case SlabRounding::down: return {{{down, 1}, {up, 0}}};
        case SlabRounding::up: return {{{down, 0}, {up, 1}}};
        case SlabRounding::random: break;
    }
    return {{{down, 1 - fraction}, {up, fraction}}};
}

double mean_chance(const SlabImplicit& how, double alpha_a, double alpha_b)
{
    double mean = 0;
    for (const RoundedBits& a : round_bits(alpha_a * how.b, how.round_a)) {
        if (!how.stratified && how.alpha_as_it_is) {
            mean += a.probability * slab_naive_chance(how.b, a.bits, alpha_b);
            continue;
        }
        for (const RoundedBits& b : round_bits(alpha_b * how.b, how.round_b)) {
            const double chance =
                how.stratified
                    ? slab_stratified_chance(how.b, a.bits, b.bits)
                    : slab_naive_chance(how.b, a.bits, b.bits / static_cast<double>(how.b));
            mean += a.probability * b.probability * chance;
        }
    }
    return mean;
}

// Fragments near to far, as numbers.
std::vector<std::size_t> front_to_back(std::span<const Fragment> fragments)
{
    std::vector<std::size_t> order(fragments.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return std::tie(fragments[i].depth, fragments[i].id) <
               std::tie(fragments[j].depth, fragments[j].id);
    });
    return order;
}

struct MaskListing {
    std::span<const Fragment> fragments;
    int k, b;
    SlabKeep keep;
    MaskChance chance;
    Cases cases;
};

void list(MaskListing& listing, std::vector<SlabMask>& masks, double probability)
{
    if (masks.size() == listing.fragments.size()) {
        listing.cases.add(slab_store(listing.fragments, masks, listing.k, listing.b, listing.keep),
                          probability);
        return;
    }
    const double alpha = listing.fragments[masks.size()].opacity;
    for (unsigned mask = 0; mask >> listing.b == 0; ++mask) {
        const double chance = listing.chance(mask, alpha, listing.b);
        if (chance == 0) continue;
        masks.emplace_back(mask);
        list(listing, masks, probability * chance);
        masks.pop_back();
    }
}

// A walk from near to far that has kept some layers, for the xi from `low` to `high`: there the sum
// of the chances so far plus xi has passed as many whole numbers.
struct Walk {
    double low = 0, high = 1;
    double sum = 0;
    int passed = 0;
    double through = 1;
    SlabStore store;
};

struct SystematicListing {
    std::span<const Fragment> fragments;
    std::vector<std::size_t> order;
    int k;
    const SlabChance& chance;
    Cases cases;
};

void list(SystematicListing& listing, const Walk& walk, std::size_t step)
{
    if (walk.high <= walk.low) return;
    if (step == listing.order.size() ||
        walk.store.layers.size() == static_cast<std::size_t>(listing.k)) {
        listing.cases.add(walk.store, walk.high - walk.low);
        return;
    }
    const Fragment& f = listing.fragments[listing.order[step]];
    const double sum = walk.sum + listing.chance(1 - walk.through, f.opacity);
    // The next whole number is passed from this xi on.
    const double border = std::clamp(walk.passed + 1 - sum, walk.low, walk.high);
    Walk without = walk, with = walk;
    without.high = with.low = border;
    without.sum = with.sum = sum;
    ++with.passed;
    with.through *= 1 - f.opacity;
    with.store.layers.push_back({f.depth, f.id, f.opacity, {}});
    list(listing, without, step + 1);
    list(listing, with, step + 1);
}

}  // namespace

double slab_naive_chance(int b, int beta_a, double alpha_b)
{
    return 1 - std::pow(1 - alpha_b, b - beta_a);
}

double slab_stratified_chance(int b, int beta_a, int beta_b)
{
    if (beta_b > beta_a) return 1;
    double hidden = 1;  // C(beta_A, beta_B) / C(b, beta_B)
    for (int i = 0; i < beta_b; ++i) hidden *= static_cast<double>(beta_a - i) / (b - i);
    return 1 - hidden;
}

SlabChance slab_chance(const SlabImplicit& implicit)
{
    return [implicit](double alpha_a, double alpha_b) {
        return mean_chance(implicit, alpha_a, alpha_b);
    };
}

SlabStore slab_systematic_store(std::span<const Fragment> fragments, int k,
                                const SlabChance& chance, double xi)
{
    SlabStore store;
    double sum = xi, through = 1;
    for (const std::size_t i : front_to_back(fragments)) {
        if (store.layers.size() == static_cast<std::size_t>(k)) break;
        const Fragment& f = fragments[i];
        const double before = std::floor(sum);
        sum += chance(1 - through, f.opacity);
        if (std::floor(sum) == before) continue;
        store.layers.push_back({f.depth, f.id, f.opacity, {}});
        through *= 1 - f.opacity;
    }
    return store;
}

SlabMoments slab_moments(std::span<const Fragment> fragments, int k, int b, SlabKeep keep,
                         MaskChance chance, SlabResolve resolve, Rgba backdrop)
{
    MaskListing listing{fragments, k, b, keep, chance, Cases(fragments, resolve, backdrop)};
    std::vector<SlabMask> masks;
    list(listing, masks, 1);
    return listing.cases.moments();
}

SlabMoments slab_implicit_moments(std::span<const Fragment> fragments, int k,
                                  const SlabChance& chance, SlabResolve resolve, Rgba backdrop)
{
    Cases cases(fragments, resolve, backdrop);
    for (std::size_t decisions = 0; decisions >> fragments.size() == 0; ++decisions) {
        double probability = 1;
        const SlabStore store =
            slab_implicit_store(fragments, k, [&](std::size_t i, double alpha_a) {
                const double p = chance(alpha_a, fragments[i].opacity);
                const bool inserted = (decisions >> i & 1) != 0;
                probability *= inserted ? p : 1 - p;
                return inserted;
            });
        if (probability > 0) cases.add(store, probability);
    }
    return cases.moments();
}

SlabMoments slab_systematic_moments(std::span<const Fragment> fragments, int k,
                                    const SlabChance& chance, SlabResolve resolve, Rgba backdrop)
{
    SystematicListing listing{fragments, front_to_back(fragments), k, chance,
                              Cases(fragments, resolve, backdrop)};
    list(listing, Walk(), 0);
    return listing.cases.moments();
}

}  // namespace sheer::reference
