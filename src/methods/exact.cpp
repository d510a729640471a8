// The exact answer: every fragment is kept, and sorted at each sample.
// Carpenter. The A-buffer, an Antialiased Hidden Surface Method. SIGGRAPH 1984.
//
// A pixel's fragments are sorted once, by their depth at the first sample that each covers, and
// composited with lanes over the samples; a sample at which that order proves wrong (surfaces that
// cross inside the pixel), or too close to call in floats, is sorted in doubles and composited
// again for itself. The order is by (depth, primitive), so the picture does not depend on the order
// of arrival, to the last bit. 36 bytes a fragment, without bound.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/exact.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <hwy/foreach_target.h>

#include "methods/samples-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// A kept fragment.
struct Layer {
    float red, green, blue, opacity;
    float depth;  // at the pixel's centre
    std::uint32_t pixel, run;
    std::uint32_t samples, samples_high;

    std::uint64_t bits() const { return samples | static_cast<std::uint64_t>(samples_high) << 32; }
};
static_assert(sizeof(Layer) == 36);

struct LayerRun {
    DepthPlane depth;
    std::uint32_t primitive;
};

// A layer of the pixel at hand, with its place in the order.
struct Sorted {
    std::uint64_t key;  // (depth at its first sample, primitive), order-preserving
    const Layer* layer;
    const LayerRun* run;
};

inline bool nearer(const Sorted& a, const Sorted& b)
{
    return a.key < b.key;
}

// The same at one sample.
struct PreciselySorted {
    double depth;
    std::uint32_t primitive;
    const Layer* layer;
};

inline bool nearer(const PreciselySorted& a, const PreciselySorted& b)
{
    return a.depth < b.depth || (a.depth == b.depth && a.primitive < b.primitive);
}

// Floats in the order of unsigned integers.
inline std::uint64_t ordered_bits(float x)
{
    const auto bits = std::bit_cast<std::uint32_t>(x + 0.0f);  // -0 becomes 0
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

template <class Item>
void insert_sorted(std::vector<Item>& sorted, const Item& item)
{
    sorted.push_back(item);
    std::size_t to = sorted.size() - 1;
    for (; to > 0 && nearer(item, sorted[to - 1]); --to) sorted[to] = sorted[to - 1];
    sorted[to] = item;
}

// Front to back: C = sum of T_i a_i c_i, T = product of (1 - a_i).
template <class L>
struct Composite {
    using real = typename L::real;
    real red, green, blue, transmittance;

    HWY_INLINE Composite() : red(0.0f), green(0.0f), blue(0.0f), transmittance(1.0f) {}
    HWY_INLINE void add(const Layer& layer, real opacity)
    {
        const real weight = transmittance * opacity;
        red = red + weight * real(layer.red);
        green = green + weight * real(layer.green);
        blue = blue + weight * real(layer.blue);
        transmittance = transmittance * (real(1.0f) - opacity);
    }
    HWY_INLINE void replace(std::size_t lane, const Composite<Lanes<1>>& by)
    {
        const auto put = [lane](real& into, Lanes<1>::real value) HWY_ATTR {
            float lanes[16];
            into.store(lanes);
            value.store(lanes + lane);
            into = real::load(lanes);
        };
        put(red, by.red);
        put(green, by.green);
        put(blue, by.blue);
        put(transmittance, by.transmittance);
    }
    HWY_INLINE void over(SampleColors& backdrop, std::size_t pixel, std::size_t s) const
    {
        const real front[3] = {red, green, blue};
        for (std::size_t c = 0; c < 3; ++c) {
            float* color = backdrop.channel(pixel, c) + s;
            (front[c] + transmittance * real::load(color)).store(color);
        }
        over_alpha<L>(transmittance, backdrop.channel(pixel, 3) + s);
    }
};

template <int S>
struct ExactStore {
    using L = Lanes<S>;
    using real = typename L::real;
    using mask = typename L::mask;

    const SampleSet& set;
    std::vector<Layer> layers;
    std::vector<LayerRun> runs;
    std::vector<std::uint32_t> first = std::vector<std::uint32_t>(kTilePixels + 1);
    std::vector<std::uint32_t> by_pixel;  // indices of layers
    std::vector<Sorted> order;
    std::vector<PreciselySorted> sample_order;  // of one sample of it

    explicit ExactStore(const StoreShape& shape) : set(*shape.samples) {}

    void clear()
    {
        layers.clear();
        runs.clear();
    }

    void insert(const FragmentStream& f, int)
    {
        const std::size_t old = layers.size();
        layers.resize(old + static_cast<std::size_t>(f.size));
        Layer* to = layers.data() + old;
        for (std::size_t r = 0; r < static_cast<std::size_t>(f.run_count); ++r) {
            const FragmentRun& run = f.runs[r];
            const auto number = static_cast<std::uint32_t>(runs.size());
            runs.push_back({run.depth, run.primitive});
            for (std::size_t i = run.first; i < run.first + run.count; ++i) {
                *to++ = {f.red[i],   f.green[i], f.blue[i],    f.opacity[i],     f.depth[i],
                         f.pixel[i], number,     f.samples[i], f.samples_high[i]};
            }
        }
    }

    void merge(const ExactStore& other)
    {
        const auto shift = static_cast<std::uint32_t>(runs.size());
        runs.insert(runs.end(), other.runs.begin(), other.runs.end());
        for (Layer layer : other.layers) {
            layer.run += shift;
            layers.push_back(layer);
        }
    }

    void resolve(SampleColors& backdrop)
    {
        sort_by_pixel();
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (first[pixel] == first[pixel + 1]) continue;
            sort_layers(pixel);
            for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); s += L::kCount) {
                Composite<L> sum;
                std::uint32_t wrong = composite_in_order(s, sum);
                for (; wrong != 0; wrong &= wrong - 1) {
                    const auto lane = static_cast<std::size_t>(std::countr_zero(wrong));
                    sum.replace(lane, composite_sample(s + lane));
                }
                sum.over(backdrop, pixel, s);
            }
        }
    }

    // A counting sort.
    void sort_by_pixel()
    {
        std::fill(first.begin(), first.end(), 0);
        for (const Layer& layer : layers) ++first[layer.pixel + 1];
        for (std::size_t p = 0; p < kTilePixels; ++p) first[p + 1] += first[p];
        by_pixel.resize(layers.size());
        for (std::uint32_t i = 0; i < layers.size(); ++i) {
            by_pixel[first[layers[i].pixel]++] = i;
        }
        for (std::size_t p = kTilePixels; p > 0; --p) first[p] = first[p - 1];
        first[0] = 0;
    }

    void sort_layers(std::size_t pixel)
    {
        order.clear();
        const bool few = first[pixel + 1] - first[pixel] <= kInsertionSortMost;
        for (std::uint32_t i = first[pixel]; i < first[pixel + 1]; ++i) {
            const Layer& layer = layers[by_pixel[i]];
            const LayerRun& run = runs[layer.run];
            const auto s = static_cast<std::size_t>(std::countr_zero(layer.bits()));
            const float offset = set.offset_x[s] * run.depth.dx + set.offset_y[s] * run.depth.dy;
            const float depth = std::clamp(layer.depth + offset, run.depth.least, run.depth.most);
            const Sorted item{ordered_bits(depth) << 32 | run.primitive, &layer, &run};
            if (few) {
                insert_sorted(order, item);
            } else {
                order.push_back(item);
            }
        }
        if (!few)
            std::sort(order.begin(), order.end(),
                      [](const Sorted& a, const Sorted& b) { return nearer(a, b); });
    }
    static constexpr std::size_t kInsertionSortMost = 32;

    // Lanes (bits) at which the common order is wrong or in doubt.
    HWY_INLINE std::uint32_t composite_in_order(std::size_t s, Composite<L>& sum) const
    {
        real last_depth(-std::numeric_limits<float>::infinity());
        mask doubtful{L::first(0)};
        for (const Sorted& item : order) {
            const Layer& layer = *item.layer;
            const mask here = L::mask_of_bits(static_cast<std::uint32_t>(layer.bits() >> s));
            const real depth = sample_depth<L>(item.run->depth, set, layer.depth, s);
            const real slack(item.run->depth.slack);
            doubtful = doubtful | (here & (depth - slack <= last_depth));
            last_depth = L::select(here, depth + slack, last_depth);
            sum.add(layer, L::zero_unless(here, real(layer.opacity)));
        }
        return doubtful.bits();
    }

    // The common order is nearly right at the sample: insertion takes few moves.
    Composite<Lanes<1>> composite_sample(std::size_t s)
    {
        sample_order.clear();
        for (const Sorted& item : order) {
            if ((item.layer->bits() >> s & 1) == 0) continue;
            insert_sorted(sample_order, {precise_depth(item.run->depth, set, item.layer->pixel, s),
                                         item.run->primitive, item.layer});
        }
        Composite<Lanes<1>> sum;
        for (const PreciselySorted& item : sample_order) {
            sum.add(*item.layer, Lanes<1>::real(item.layer->opacity));
        }
        return sum;
    }
};

StoreVerbs exact_store(int samples)
{
    return verbs_for_samples<ExactStore>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(exact_store);

StoreVerbs exact_verbs(TargetSet targets, int samples)
{
    return SHEER_DISPATCH(exact_store, targets)(samples);
}

}  // namespace sheer
#endif
