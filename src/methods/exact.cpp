// The exact answer: every fragment is kept, and sorted at each sample.
// Carpenter. The A-buffer, an Antialiased Hidden Surface Method. SIGGRAPH 1984.
//
// A pixel's fragments are sorted once, by their depth at the first sample that each covers, and
// composited with lanes over the samples; a sample at which that order proves wrong (surfaces that
// cross inside the pixel), or too close to call in floats, is sorted in doubles and composited
// again for itself. The order is by (depth, primitive), so the picture does not depend on the order
// of arrival, to the last bit. 36 bytes a fragment, 48
// where there is coloured glass, without bound.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/exact.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include "lanes/lone.h"
#include "methods/exact_layers.h"
#include "methods/exact_verbs-inl.h"
#include "methods/samples-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <int S, class Layer>
struct ExactStore {
    using L = Lanes<S>;
    using real = typename L::real;
    using mask = typename L::mask;
    using Text = ExactText<L>;
    using Verbs = ExactVerbs<Text, Layer>;
    using Sum = typename Verbs::Sum;
    // A sum in memory, lane by lane.
    struct SumLanes {
        alignas(64) float channel[Verbs::kChannels][16];
    };

    const SampleSet& set;
    const std::size_t most_bytes;
    std::vector<Layer> layers;
    std::vector<LayerRun> runs;
    std::vector<std::uint32_t> counts = std::vector<std::uint32_t>(kTilePixels);  // of the layers
    std::uint32_t most_in_pixel = 0;
    // Since memory was given back: the most there was of each, and the bytes of all.
    std::size_t most_layers = 0, most_runs = 0, most_in_any_pixel = 0, touched = 0;
    std::vector<std::uint32_t> first = std::vector<std::uint32_t>(kTilePixels + 1);
    std::vector<Layer> by_pixel;
    std::vector<std::uint64_t> keys;   // of the pixel at hand
    std::vector<Placed<Layer>> order;  // its layers, near to far
    // Of its samples s, s + 1, ...: a value a lane, layer after layer.
    std::vector<float> nearest;   // the least that depth may be
    std::vector<float> furthest;  // the most that depth may be up to here
    std::vector<std::uint32_t> doubt;
    std::vector<PreciselyPlaced<Layer>> sample_order;  // of one sample

    explicit ExactStore(const StoreShape& shape) : set(*shape.samples), most_bytes(shape.most_bytes)
    {
    }

    void clear(const TilePlace&)
    {
        if (touched > most_bytes) give_back();
        layers.clear();
        runs.clear();
        std::fill(counts.begin(), counts.end(), 0);
        most_in_pixel = 0;
    }

    bool insert(const FragmentStream& f, int)
    {
        count(f);
        const std::size_t old = layers.size();
        if (!reserve(old + static_cast<std::size_t>(f.size),
                     runs.size() + static_cast<std::size_t>(f.run_count))) {
            return false;
        }
        layers.resize(old + static_cast<std::size_t>(f.size));
        Layer* to = layers.data() + old;
        for (std::size_t r = 0; r < static_cast<std::size_t>(f.run_count); ++r) {
            const FragmentRun& run = f.runs[r];
            const auto number = static_cast<std::uint32_t>(runs.size());
            runs.push_back({run.depth, run.primitive});
            for (std::size_t i = run.first; i < run.first + run.count; ++i) {
                static_cast<PlainLayer&>(*to) = {f.red[i],     f.green[i],   f.blue[i],
                                                 f.opacity[i], f.depth[i],   f.pixel[i],
                                                 number,       f.samples[i], f.samples_high[i]};
                if constexpr (std::is_same_v<Layer, ColoredLayer>) {
                    to->through_red = f.through_red[i];
                    to->through_green = f.through_green[i];
                    to->through_blue = f.through_blue[i];
                }
                ++to;
            }
        }
        return true;
    }

    void count(const FragmentStream& f)
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(f.size); ++i) {
            most_in_pixel = std::max(most_in_pixel, ++counts[f.pixel[i]]);
        }
    }

    // Room for as many, if that and what resolving them takes stays within most_bytes. What earlier
    // tiles have touched counts too, until `clear` gives it back. Vectors that grow hold their old
    // contents beside the new for a while: where memory is short, they get the room that they may
    // need at once, which costs nothing before it is used.
    bool reserve(std::size_t layer_count, std::size_t run_count)
    {
        constexpr std::size_t kLayerBytes = 2 * sizeof(Layer);  // as they came, and by pixel
        constexpr std::size_t kPixelLayerBytes =
            sizeof(keys[0]) + sizeof(order[0]) + sizeof(doubt[0]) + sizeof(sample_order[0]) +
            (sizeof(nearest[0]) + sizeof(furthest[0])) * L::kCount;
        most_layers = std::max(most_layers, layer_count);
        most_runs = std::max(most_runs, run_count);
        most_in_any_pixel = std::max<std::size_t>(most_in_any_pixel, most_in_pixel);
        touched = most_layers * kLayerBytes + most_runs * sizeof(LayerRun) +
                  3 * most_in_any_pixel * kPixelLayerBytes;
        if (touched > most_bytes) return false;
        if (layers.capacity() == 0 && most_bytes != ~std::size_t{0}) {
            layers.reserve(most_bytes / kLayerBytes);
            by_pixel.reserve(most_bytes / kLayerBytes);
            runs.reserve(most_bytes / sizeof(LayerRun));
        }
        return true;
    }

    void give_back()
    {
        for (std::vector<Layer>* v : {&layers, &by_pixel}) std::vector<Layer>().swap(*v);
        for (std::vector<float>* v : {&nearest, &furthest}) std::vector<float>().swap(*v);
        std::vector<LayerRun>().swap(runs);
        std::vector<std::uint64_t>().swap(keys);
        std::vector<Placed<Layer>>().swap(order);
        std::vector<std::uint32_t>().swap(doubt);
        std::vector<PreciselyPlaced<Layer>>().swap(sample_order);
        most_layers = most_runs = most_in_any_pixel = touched = 0;
    }

    void merge(const ExactStore& other)
    {
        for (std::size_t p = 0; p < kTilePixels; ++p) {
            counts[p] += other.counts[p];
            most_in_pixel = std::max(most_in_pixel, counts[p]);
        }
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
                const Sum sum = composite(s);
                resolve_samples<Text>(backdrop, pixel, s,
                                      [&](auto behind, real& transmittance) HWY_ATTR {
                                          return Verbs::resolve(sum, behind, transmittance);
                                      });
            }
        }
    }

    // A counting sort: the layers of pixel p are by_pixel[first[p] .. first[p + 1]).
    void sort_by_pixel()
    {
        first[0] = 0;
        for (std::size_t p = 0; p < kTilePixels; ++p) first[p + 1] = first[p] + counts[p];
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
            const float depth = sample_depth_at(plane, set, layer.depth, s);
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
            const Placed<Layer>& item = order[i];
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

    HWY_INLINE Sum composite(std::size_t s)
    {
        Sum sum = Verbs::clear();
        for (std::size_t i = 0; i < order.size();) {
            const Sum before = sum;
            const std::size_t begin = i;
            std::uint32_t doubtful = 0;
            do {
                doubtful |= doubt[i];
                const Layer& layer = *order[i].layer;
                sum = Verbs::add(sum, covers(layer, s), layer);
            } while (doubt[i++] != 0 && i < order.size());
            if (doubtful == 0) continue;
            SumLanes from, to;
            save(before, from);
            save(sum, to);
            for (; doubtful != 0; doubtful &= doubtful - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(doubtful));
                add_sorted(begin, i, s, lane, from, to);
            }
            Verbs::for_each_channel(
                sum, [&](int c, real& value) HWY_ATTR { value = real::load(to.channel[c]); });
        }
        return sum;
    }

    static HWY_INLINE void save(const Sum& sum, SumLanes& to)
    {
        Verbs::for_each_channel(
            sum, [&](int c, const real& value) HWY_ATTR { value.store(to.channel[c]); });
    }

    // Layers [begin, end) of the common order, in their precise order at sample s + lane.
    void add_sorted(std::size_t begin, std::size_t end, std::size_t s, std::size_t lane,
                    const SumLanes& from, SumLanes& to)
    {
        if (sample_order.size() < end - begin) sample_order.resize(end - begin);
        std::size_t size = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const Layer& layer = *order[i].layer;
            if ((layer.bits() >> (s + lane) & 1) == 0) continue;
            const LayerRun& run = *order[i].run;
            const PreciselyPlaced<Layer> item{precise_depth(run.depth, set, layer.pixel, s + lane),
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
        using One = ExactVerbs<ExactText<Lone<float>>, Layer>;
        typename One::Sum sum;
        One::for_each_channel(sum, [&](int c, float& value) { value = from.channel[c][lane]; });
        for (std::size_t i = 0; i < size; ++i) {
            sum = One::add(sum, true, *sample_order[i].layer);
        }
        One::for_each_channel(sum, [&](int c, float value) { to.channel[c][lane] = value; });
    }

    HWY_INLINE mask covers(const Layer& layer, std::size_t s) const
    {
        return L::mask_of_bits(static_cast<std::uint32_t>(layer.bits() >> s));
    }
};

template <int S>
using PlainExactStore = ExactStore<S, PlainLayer>;
template <int S>
using ColoredExactStore = ExactStore<S, ColoredLayer>;

StoreVerbs exact_store(int samples)
{
    return verbs_for_samples<PlainExactStore>(samples);
}

StoreVerbs exact_colored_store(int samples)
{
    return verbs_for_samples<ColoredExactStore>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(exact_store);
HWY_EXPORT(exact_colored_store);

StoreVerbs exact_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(exact_store, targets)(samples);
}

StoreVerbs exact_colored_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(exact_colored_store, targets)(samples);
}

}  // namespace sheer
#endif
