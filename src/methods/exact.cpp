// The exact answer: every fragment is kept, and sorted at each sample.
// Carpenter. The A-buffer, an Antialiased Hidden Surface Method. SIGGRAPH 1984.
//
// A pixel's fragments are sorted once, by their depth at the first sample that each covers, and
// composited with lanes over the samples; a sample at which that order proves wrong (surfaces that
// cross inside the pixel) is sorted for itself. The order is by (depth, primitive), so the picture
// does not depend on the order of arrival, to the last bit. 36 bytes a fragment, without bound.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/exact.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <bit>
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
};
static_assert(sizeof(Layer) == 36);

struct LayerRun {
    DepthPlane plane;
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

// Floats in the order of unsigned integers.
inline std::uint64_t ordered_bits(float x)
{
    const auto bits = std::bit_cast<std::uint32_t>(x + 0.0f);  // -0 becomes 0
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

template <class L>
HWY_INLINE typename L::mask covers(const Layer& layer, std::size_t s)
{
    return L::mask_of_bits((s < 32 ? layer.samples : layer.samples_high) >> (s & 31));
}

// Front to back: C = sum of T_i a_i c_i, T = product of (1 - a_i).
template <class L>
struct Composite {
    using real = typename L::real;
    real red, green, blue, transmittance;

    HWY_INLINE Composite() : red(0.0f), green(0.0f), blue(0.0f), transmittance(1.0f) {}
    HWY_INLINE void add(real r, real g, real b, real a)
    {
        const real weight = transmittance * a;
        red = red + weight * r;
        green = green + weight * g;
        blue = blue + weight * b;
        transmittance = transmittance * (real(1.0f) - a);
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
    using whole = typename L::whole;
    using mask = typename L::mask;

    const SampleSet& set;
    std::vector<Layer> layers;
    std::vector<LayerRun> runs;
    std::vector<std::uint32_t> first = std::vector<std::uint32_t>(kTilePixels + 1);
    std::vector<std::uint32_t> by_pixel;  // indices of layers
    std::vector<Sorted> order;
    // Of one group of lanes of the pixel at hand: a value a lane, layer after layer.
    std::vector<float> lane_depth;
    std::vector<std::uint32_t> lane_primitive, lane_layer;

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
            runs.push_back(
                {{run.depth_dx, run.depth_dy, run.depth_min, run.depth_max}, run.primitive});
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
                if (!composite_in_order(s, sum)) {
                    sum = Composite<L>();
                    composite_by_lane(s, sum);
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
        for (std::uint32_t i = first[pixel]; i < first[pixel + 1]; ++i) {
            const Layer& layer = layers[by_pixel[i]];
            const LayerRun& run = runs[layer.run];
            const std::uint64_t bits =
                layer.samples | static_cast<std::uint64_t>(layer.samples_high) << 32;
            const auto s = static_cast<std::size_t>(std::countr_zero(bits));
            const float offset = set.offset_x[s] * run.plane.dx + set.offset_y[s] * run.plane.dy;
            const float depth = std::clamp(layer.depth + offset, run.plane.least, run.plane.most);
            order.push_back({ordered_bits(depth) << 32 | run.primitive, &layer, &run});
        }
        if (order.size() > kInsertionSortMost) {
            std::sort(order.begin(), order.end(), nearer);
            return;
        }
        for (std::size_t i = 1; i < order.size(); ++i) {
            const Sorted moving = order[i];
            std::size_t to = i;
            for (; to > 0 && nearer(moving, order[to - 1]); --to) order[to] = order[to - 1];
            order[to] = moving;
        }
    }
    static constexpr std::size_t kInsertionSortMost = 32;

    // False when the common order is wrong at one of the samples s, s + 1, ...
    HWY_INLINE bool composite_in_order(std::size_t s, Composite<L>& sum) const
    {
        real last_depth(-std::numeric_limits<float>::infinity());
        whole last_primitive(0);
        mask wrong{L::first(0)};
        for (const Sorted& item : order) {
            const Layer& layer = *item.layer;
            const mask here = covers<L>(layer, s);
            const real depth = sample_depth<L>(item.run->plane, set, layer.depth, s);
            const whole primitive(static_cast<std::int32_t>(item.run->primitive));
            wrong = wrong |
                    (here & ((depth < last_depth) | ((depth == last_depth) &
                                                     L::less_unsigned(primitive, last_primitive))));
            last_depth = L::select(here, depth, last_depth);
            last_primitive = L::select(here, primitive, last_primitive);
            sum.add(real(layer.red), real(layer.green), real(layer.blue),
                    L::zero_unless(here, real(layer.opacity)));
        }
        return !wrong.any();
    }

    // Each lane for itself: exchanges of neighbours until every lane is in order.
    void composite_by_lane(std::size_t s, Composite<L>& sum)
    {
        fill_lanes(s);
        constexpr std::size_t kLanes = L::kCount;
        for (std::size_t end = order.size(); end > 1;) {
            std::size_t last_exchange = 0;
            for (std::size_t i = 1; i < end; ++i) {
                if (exchange((i - 1) * kLanes, i * kLanes)) last_exchange = i;
            }
            end = last_exchange;
        }
        alignas(64) float r[16], g[16], b[16], a[16];
        for (std::size_t i = 0; i < order.size(); ++i) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const Layer& layer = *order[lane_layer[i * kLanes + lane]].layer;
                const std::uint64_t bits =
                    layer.samples | static_cast<std::uint64_t>(layer.samples_high) << 32;
                r[lane] = layer.red;
                g[lane] = layer.green;
                b[lane] = layer.blue;
                a[lane] = (bits >> (s + lane) & 1) != 0 ? layer.opacity : 0.0f;
            }
            sum.add(real::load(r), real::load(g), real::load(b), real::load(a));
        }
    }

    void fill_lanes(std::size_t s)
    {
        constexpr std::size_t kLanes = L::kCount;
        const std::size_t size = order.size() * kLanes;
        lane_depth.resize(size);
        lane_primitive.resize(size);
        lane_layer.resize(size);
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Sorted& item = order[i];
            const mask here = covers<L>(*item.layer, s);
            const real depth = sample_depth<L>(item.run->plane, set, item.layer->depth, s);
            // What a sample does not see sinks to the end.
            L::select(here, depth, real(std::numeric_limits<float>::infinity()))
                .store(&lane_depth[i * kLanes]);
            whole(static_cast<std::int32_t>(item.run->primitive))
                .store(&lane_primitive[i * kLanes]);
            whole(static_cast<std::int32_t>(i)).store(&lane_layer[i * kLanes]);
        }
    }

    // True when a lane of layer `near` had to change places with that of layer `far`.
    HWY_INLINE bool exchange(std::size_t near, std::size_t far)
    {
        const real d0 = real::load(&lane_depth[near]), d1 = real::load(&lane_depth[far]);
        const whole p0 = whole::load(&lane_primitive[near]), p1 = whole::load(&lane_primitive[far]);
        const mask wrong = (d1 < d0) | ((d1 == d0) & L::less_unsigned(p1, p0));
        if (!wrong.any()) return false;
        const whole l0 = whole::load(&lane_layer[near]), l1 = whole::load(&lane_layer[far]);
        L::select(wrong, d1, d0).store(&lane_depth[near]);
        L::select(wrong, d0, d1).store(&lane_depth[far]);
        L::select(wrong, p1, p0).store(&lane_primitive[near]);
        L::select(wrong, p0, p1).store(&lane_primitive[far]);
        L::select(wrong, l1, l0).store(&lane_layer[near]);
        L::select(wrong, l0, l1).store(&lane_layer[far]);
        return true;
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
