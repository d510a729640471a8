// The exact answer: every fragment is kept, and sorted at each sample.
// Carpenter. The A-buffer, an Antialiased Hidden Surface Method. SIGGRAPH 1984.
//
// A tile's triangles are put in rough order, in which their fragments come to the pixels' lists. A
// pixel's list is sorted once, by depth at the first sample that each fragment covers, and
// composited with lanes over the samples; where that order proves wrong at one of them (surfaces
// that cross inside the pixel), or too close to call in floats, those fragments are sorted in
// doubles, each sample for itself. The order is by (depth, primitive), so the picture does not
// depend on the order of arrival, to the last bit. 38 bytes a fragment, 50 where there is coloured
// glass, without bound; 8 more while a tile's are sorted.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/exact.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <type_traits>
#include <vector>

#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include "lanes/lone.h"
#include "methods/exact_doubts-inl.h"
#include "methods/exact_lists.h"
#include "methods/exact_verbs-inl.h"
#include "methods/samples-inl.h"
#include "raster/sample_depth-inl.h"
#include "support/pages.h"

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
    std::pmr::memory_resource* const memory;
    ExactLists<Layer> lists{memory};
    // Since memory was given back: the most there was of each, and the bytes of all.
    std::size_t most_layers = 0, most_runs = 0, most_in_any_pixel = 0, touched = 0;
    // Of the pixel at hand.
    std::pmr::vector<Placed<Layer>> order{memory};  // its layers, near to far
    // Of its samples s, s + 1, ...: a value a lane, layer after layer.
    std::pmr::vector<float> furthest{memory};      // the most that the layer's depth may be
    std::pmr::vector<float> nearest_from{memory};  // the least that depth may be, of any from it on
    std::pmr::vector<PreciselyPlaced<Layer>> sample_order{memory};  // of one sample

    explicit ExactStore(const StoreShape& shape)
        : set(*shape.samples), most_bytes(shape.most_bytes), memory(memory_within(most_bytes))
    {
    }

    void clear(const TilePlace&)
    {
        if (touched > most_bytes) give_back();
        lists.clear();
    }

    bool insert(const FragmentStream& f, int)
    {
        lists.count(f);
        if (!reserve(lists.layers.size() + static_cast<std::size_t>(f.size),
                     lists.runs.size() + static_cast<std::size_t>(f.run_count))) {
            return false;
        }
        lists.insert(f, set);
        return true;
    }

    // Room for as many, if that and what resolving them takes stays within most_bytes. What earlier
    // tiles have touched counts too, until `clear` gives it back.
    bool reserve(std::size_t layer_count, std::size_t run_count)
    {
        constexpr std::size_t kPixelLayerBytes =
            sizeof(order[0]) + sizeof(sample_order[0]) +
            (sizeof(furthest[0]) + sizeof(nearest_from[0])) * L::kCount;
        most_layers = std::max(most_layers, layer_count);
        most_runs = std::max(most_runs, run_count);
        most_in_any_pixel = std::max<std::size_t>(most_in_any_pixel, lists.most_in_pixel);
        touched = most_layers * lists.kBytesOfLayer + most_runs * lists.kBytesOfRun +
                  3 * most_in_any_pixel * kPixelLayerBytes;
        if (touched > most_bytes) return false;
        if (lists.layers.capacity() == 0 && most_bytes != ~std::size_t{0}) {
            lists.reserve(most_bytes);
        }
        return true;
    }

    void give_back()
    {
        lists.give_back();
        sheer::give_back(furthest);
        sheer::give_back(nearest_from);
        sheer::give_back(order);
        sheer::give_back(sample_order);
        most_layers = most_runs = most_in_any_pixel = touched = 0;
    }

    void merge(const ExactStore& other) { lists.merge(other.lists); }

    void resolve(SampleColors& backdrop)
    {
        lists.list();
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (lists.counts[pixel] == 0) continue;
            sort_layers(pixel);
            for (std::size_t s = 0; s < static_cast<std::size_t>(set.count); s += L::kCount) {
                find_extents(s);
                const Sum sum = composite(pixel, s);
                resolve_samples<Text>(backdrop, pixel, s,
                                      [&](auto behind, real& transmittance) HWY_ATTR {
                                          return Verbs::resolve(sum, behind, transmittance);
                                      });
            }
        }
    }

    // By depth at the first sample that each layer covers, and then as they came: `composite` sees
    // to it that this is only where it begins.
    void sort_layers(std::size_t pixel)
    {
        std::uint64_t* keys = lists.by_pixel.data() + lists.first[pixel];
        const std::size_t size = lists.counts[pixel];
        // About the next pixel's layers, which this one's list leaves time to bring.
        const std::size_t ahead = std::min(size, lists.layers.size() - lists.first[pixel] - size);
        for (std::size_t i = 0; i < ahead; ++i) hwy::Prefetch(&layer_of(keys[size + i]));
        std::size_t moves_left = kMovesOfLayer * size;
        for (std::size_t i = 1; i < size; ++i) {
            const std::uint64_t key = keys[i];
            std::size_t at = i;
            for (; at > 0 && key < keys[at - 1] && moves_left > 0; --at, --moves_left) {
                keys[at] = keys[at - 1];
            }
            keys[at] = key;
        }
        if (moves_left == 0) std::sort(keys, keys + size);
        order.resize(size);
        for (std::size_t i = 0; i < size; ++i) {
            const Layer& layer = layer_of(keys[i]);
            order[i] = {&layer, &lists.runs[layer.run]};
            hwy::Prefetch(order[i].run);
        }
    }
    const Layer& layer_of(std::uint64_t key) const { return lists.layers[key & 0xffffffffu]; }
    // Lists are nearly sorted where triangles are small; where they take more, sorting is faster.
    static constexpr std::size_t kMovesOfLayer = 12;

    HWY_INLINE void find_extents(std::size_t s)
    {
        const real infinity(std::numeric_limits<float>::infinity());
        const std::size_t size = order.size();
        furthest.resize(size * L::kCount);
        nearest_from.resize((size + 1) * L::kCount);
        float* const furthest_of = furthest.data();
        float* const nearest = nearest_from.data();
        real from_here = infinity;
        from_here.store(nearest + size * L::kCount);
        for (std::size_t i = size; i-- > 0;) {
            const Placed<Layer>& item = order[i];
            const mask here = covers(*item.layer, s);
            const real depth = sample_depth<L>(item.run->depth, set, item.layer->depth, s);
            const real slack(item.run->depth.slack);
            L::select(here, depth + slack, real(0.0f) - infinity)
                .store(furthest_of + i * L::kCount);
            from_here = L::select(here, L::min(from_here, depth - slack), from_here);
            from_here.store(nearest + i * L::kCount);
        }
    }

    // In the common order, as long as no layer up to one may be behind any after it.
    HWY_INLINE Sum composite(std::size_t pixel, std::size_t s)
    {
        const std::size_t size = order.size();
        const Placed<Layer>* const items = order.data();
        const float* const furthest_of = furthest.data();
        const float* const nearest_after = nearest_from.data() + L::kCount;
        Sum sum = Verbs::clear();
        real so_far = real(0.0f) - real(std::numeric_limits<float>::infinity());
        for (std::size_t i = 0; i < size;) {
            SumLanes lanes;
            save(sum, lanes);
            const std::size_t begin = i;
            bool doubtful;
            do {
                const Layer& layer = *items[i].layer;
                sum = Verbs::add(sum, covers(layer, s), layer);
                so_far = L::max(so_far, real::load(furthest_of + i * L::kCount));
                doubtful = (so_far >= real::load(nearest_after + i * L::kCount)).any();
            } while (++i < size && doubtful);
            if (i - begin == 1) continue;
            composite_precisely(begin, i, pixel, s, lanes);
            load(lanes, sum);
        }
        return sum;
    }

    // Lane by lane, which is read again as it was written: the whole at once would wait.
    static HWY_INLINE void save(const Sum& sum, SumLanes& to)
    {
        Verbs::for_each_channel(
            sum, [&](int c, const real& value) HWY_ATTR { value.store(to.channel[c]); });
    }

    static HWY_INLINE void load(const SumLanes& from, Sum& sum)
    {
        Verbs::for_each_channel(
            sum, [&](int c, real& value) HWY_ATTR { value = real::load(from.channel[c]); });
    }

    // Layers [begin, end) of the common order, at each sample in its own.
    HWY_NOINLINE void composite_precisely(std::size_t begin, std::size_t end, std::size_t pixel,
                                          std::size_t s, SumLanes& lanes)
    {
        using Doubtful = DoubtfulLayers<L, Verbs>;
        if (end - begin > Doubtful::kMost) {
            for (std::size_t lane = 0; lane < L::kCount; ++lane) {
                add_sorted(begin, end, pixel, s + lane, lane, lanes);
            }
            return;
        }
        Doubtful few;
        for (std::size_t i = begin; i < end; ++i) {
            const Placed<Layer>& item = order[i];
            few.add(*item.layer, item.run->primitive, covers(*item.layer, s),
                    DepthWords<L>(item.run->depth, set, pixel, s));
        }
        Sum sum;
        load(lanes, sum);
        save(few.composite(sum), lanes);
    }

    void add_sorted(std::size_t begin, std::size_t end, std::size_t pixel, std::size_t s,
                    std::size_t lane, SumLanes& sums)
    {
        sample_order.clear();
        for (std::size_t i = begin; i < end; ++i) {
            const Layer& layer = *order[i].layer;
            if ((layer.bits() >> s & 1) == 0) continue;
            const LayerRun& run = *order[i].run;
            sample_order.push_back(
                {precise_depth(run.depth, set, static_cast<std::uint32_t>(pixel), s), run.primitive,
                 &layer});
        }
        std::sort(sample_order.begin(), sample_order.end());
        using One = ExactVerbs<ExactText<Lone<float>>, Layer>;
        typename One::Sum sum;
        One::for_each_channel(sum, [&](int c, float& value) { value = sums.channel[c][lane]; });
        for (const PreciselyPlaced<Layer>& item : sample_order) {
            sum = One::add(sum, true, *item.layer);
        }
        One::for_each_channel(sum, [&](int c, float value) { sums.channel[c][lane] = value; });
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
