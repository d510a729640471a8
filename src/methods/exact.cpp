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

#include <hwy/cache_control.h>
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

// A layer of the pixel at hand.
struct Placed {
    const Layer* layer;
    const LayerRun* run;
};

// The same at one sample.
struct PreciselyPlaced {
    double depth;
    std::uint32_t primitive;
    const Layer* layer;

    bool operator<(const PreciselyPlaced& b) const
    {
        return depth < b.depth || (depth == b.depth && primitive < b.primitive);
    }
};

// Floats in the order of unsigned integers.
inline std::uint64_t ordered_bits(float x)
{
    const auto bits = std::bit_cast<std::uint32_t>(x + 0.0f);  // -0 becomes 0
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

// The first `size` items are sorted; puts another one among them.
template <class Item>
HWY_INLINE void insert_sorted(Item* items, std::size_t size, const Item& item)
{
    for (; size > 0 && item < items[size - 1]; --size) items[size] = items[size - 1];
    items[size] = item;
}

// A Composite in memory, lane by lane.
struct CompositeLanes {
    alignas(64) float red[16], green[16], blue[16], transmittance[16];
};

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
    HWY_INLINE void load(const CompositeLanes& from)
    {
        red = real::load(from.red);
        green = real::load(from.green);
        blue = real::load(from.blue);
        transmittance = real::load(from.transmittance);
    }
    HWY_INLINE void store(CompositeLanes& to) const
    {
        red.store(to.red);
        green.store(to.green);
        blue.store(to.blue);
        transmittance.store(to.transmittance);
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
    std::vector<Layer> by_pixel;
    std::vector<std::uint64_t> keys;  // of the pixel at hand
    std::vector<Placed> order;        // its layers, near to far
    // Of its samples s, s + 1, ...: a value a lane, layer after layer.
    std::vector<float> nearest;   // the least that depth may be
    std::vector<float> furthest;  // the most that depth may be up to here
    std::vector<std::uint32_t> doubt;
    std::vector<PreciselyPlaced> sample_order;  // of one sample

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
                find_doubts(s);
                composite(s).over(backdrop, pixel, s);
            }
        }
    }

    // A counting sort: the layers of pixel p are by_pixel[first[p] .. first[p + 1]).
    void sort_by_pixel()
    {
        std::fill(first.begin(), first.end(), 0);
        for (const Layer& layer : layers) ++first[layer.pixel + 1];
        for (std::size_t p = 0; p < kTilePixels; ++p) first[p + 1] += first[p];
        if (by_pixel.size() < layers.size()) by_pixel.resize(layers.size());
        for (const Layer& layer : layers) by_pixel[first[layer.pixel]++] = layer;
        for (std::size_t p = kTilePixels; p > 0; --p) first[p] = first[p - 1];
        first[0] = 0;
    }

    // By depth at the first sample that each layer covers, and then as they came: find_doubts sees
    // to it that this is only where it begins.
    void sort_layers(std::size_t pixel)
    {
        const Layer* begin = by_pixel.data() + first[pixel];
        const std::size_t size = first[pixel + 1] - first[pixel];
        keys.resize(size);
        order.resize(size);
        for (std::size_t i = 0; i < size; ++i) {
            // The next pixel's too: they follow these.
            if (begin + i + kRunsAhead < by_pixel.data() + layers.size()) {
                hwy::Prefetch(&runs[begin[i + kRunsAhead].run]);
            }
            const Layer& layer = begin[i];
            const DepthPlane& plane = runs[layer.run].depth;
            const auto s = static_cast<std::size_t>(std::countr_zero(layer.bits()));
            const float offset = set.offset_x[s] * plane.dx + set.offset_y[s] * plane.dy;
            const float depth = std::clamp(layer.depth + offset, plane.least, plane.most);
            const std::uint64_t key = ordered_bits(depth) << 32 | i;
            if (size <= kInsertionSortMost) {
                insert_sorted(keys.data(), i, key);
            } else {
                keys[i] = key;
            }
        }
        if (size > kInsertionSortMost) std::sort(keys.begin(), keys.end());
        for (std::size_t i = 0; i < size; ++i) {
            const Layer& layer = begin[keys[i] & 0xffffffffu];
            order[i] = {&layer, &runs[layer.run]};
        }
    }
    static constexpr std::size_t kInsertionSortMost = 24;
    static constexpr std::ptrdiff_t kRunsAhead = 8;

    // doubt[i]: lanes (bits) at which one of the layers up to i may be behind one of those after i.
    HWY_INLINE void find_doubts(std::size_t s)
    {
        const real infinity(std::numeric_limits<float>::infinity());
        const std::size_t size = order.size();
        nearest.resize(size * L::kCount);
        furthest.resize(size * L::kCount);
        doubt.resize(size);
        real so_far = real(0.0f) - infinity;
        for (std::size_t i = 0; i < size; ++i) {
            const Placed& item = order[i];
            const mask here = covers(*item.layer, s);
            const real depth = sample_depth<L>(item.run->depth, set, item.layer->depth, s);
            const real slack(item.run->depth.slack);
            so_far = L::select(here, L::max(so_far, depth + slack), so_far);
            so_far.store(&furthest[i * L::kCount]);
            L::select(here, depth - slack, infinity).store(&nearest[i * L::kCount]);
        }
        real from_here = infinity;
        for (std::size_t i = size; i-- > 0;) {
            doubt[i] = (real::load(&furthest[i * L::kCount]) >= from_here).bits();
            from_here = L::min(from_here, real::load(&nearest[i * L::kCount]));
        }
    }

    HWY_INLINE Composite<L> composite(std::size_t s)
    {
        Composite<L> sum;
        for (std::size_t i = 0; i < order.size();) {
            const Composite<L> before = sum;
            const std::size_t begin = i;
            std::uint32_t doubtful = 0;
            do {
                doubtful |= doubt[i];
                const Layer& layer = *order[i].layer;
                sum.add(layer, L::zero_unless(covers(layer, s), real(layer.opacity)));
            } while (doubt[i++] != 0 && i < order.size());
            if (doubtful == 0) continue;
            CompositeLanes from, to;
            before.store(from);
            sum.store(to);
            for (; doubtful != 0; doubtful &= doubtful - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(doubtful));
                add_sorted(begin, i, s, lane, from, to);
            }
            sum.load(to);
        }
        return sum;
    }

    // Layers [begin, end) of the common order, in their precise order at sample s + lane.
    void add_sorted(std::size_t begin, std::size_t end, std::size_t s, std::size_t lane,
                    const CompositeLanes& from, CompositeLanes& to)
    {
        if (sample_order.size() < end - begin) sample_order.resize(end - begin);
        std::size_t size = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const Layer& layer = *order[i].layer;
            if ((layer.bits() >> (s + lane) & 1) == 0) continue;
            const LayerRun& run = *order[i].run;
            const PreciselyPlaced item{precise_depth(run.depth, set, layer.pixel, s + lane),
                                       run.primitive, &layer};
            if (end - begin <= kInsertionSortMost) {
                insert_sorted(sample_order.data(), size, item);
            } else {
                sample_order[size] = item;
            }
            ++size;
        }
        if (end - begin > kInsertionSortMost) {
            std::sort(sample_order.data(), sample_order.data() + size);
        }
        float red = from.red[lane], green = from.green[lane], blue = from.blue[lane];
        float transmittance = from.transmittance[lane];
        for (std::size_t i = 0; i < size; ++i) {
            const Layer& layer = *sample_order[i].layer;
            const float weight = transmittance * layer.opacity;
            red = red + weight * layer.red;
            green = green + weight * layer.green;
            blue = blue + weight * layer.blue;
            transmittance = transmittance * (1.0f - layer.opacity);
        }
        to.red[lane] = red;
        to.green[lane] = green;
        to.blue[lane] = blue;
        to.transmittance[lane] = transmittance;
    }

    HWY_INLINE mask covers(const Layer& layer, std::size_t s) const
    {
        return L::mask_of_bits(static_cast<std::uint32_t>(layer.bits() >> s));
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
