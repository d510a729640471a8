// Stochastic layered alpha blending: shaders/sheer/slab.glsl at every sample of a tile.
//
// Depth based, the second pass adds up what the layers of the first let be seen: 16 bytes a sample,
// and total alpha. Else the layers show themselves.
#if defined(SHEER_SLAB_TILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_SLAB_TILE_INL_H
#undef SHEER_SLAB_TILE_INL_H
#else
#define SHEER_SLAB_TILE_INL_H
#endif

#include "methods/slab_layers-inl.h"
#include "methods/total_alpha-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// What becomes of a layer too many: it is forgotten, and so is all that lies behind the last.
struct ForgettingLayers {
    static constexpr bool kForgets = true;
    static SlabSettings settings(const ChosenMethod& method) { return slab_settings(method); }

    template <class Layers>
    static HWY_INLINE void fall(Layers&, std::size_t, std::size_t, const typename Layers::Layer&)
    {
    }
};

template <int S, int Words, class Kind = ForgettingLayers>
class SlabTile {
    using Layers = SlabLayers<S, Words>;
    using L = typename Layers::L;
    using Text = typename Layers::Text;
    using Layer = typename Layers::Layer;
    using Front = typename Layers::Front;
    using real3 = typename Text::real3;
    using real = typename L::real;
    using whole = typename L::whole;
    using mask = typename L::mask;
    using Sum = typename Text::StochasticDepthSum;
    static constexpr bool kExplicit = Layers::kExplicit;

public:
    explicit SlabTile(const StoreShape& shape)
        : set_(*shape.samples),
          settings_(Kind::settings(*shape.method)),
          draws_(settings_, set_.count),
          layers_(settings_, set_.count, settings_.in_depth ? kSlabCandidates : settings_.layers)
    {
        if (settings_.depth_based) sums_ = SampleValues<4>(set_.count);
        if (has_total_alpha()) total_alpha_ = TotalAlpha<S>(set_.count);
    }

    void clear(const TilePlace& place)
    {
        draws_.clear(place);
        layers_.clear();
        if (has_total_alpha()) total_alpha_.clear();
        std::fill_n(sums_.values.data(), sums_.values.size(), 0.0f);
        has_candidates_ = settings_.in_depth;
    }

    void insert(const FragmentStream& f, int pass)
    {
        const int last = settings_.depth_based ? 1 : 0;
        if (pass == 0) {
            for (int r = 0; r < f.run_count; ++r) insert_run(f, f.runs[r]);
        } else {
            choose_layers();
            for (int r = 0; r < f.run_count; ++r) add_run(f, f.runs[r]);
        }
        if (pass == last && has_total_alpha()) total_alpha_.insert(f);
    }

    void merge(const SlabTile& other)
    {
        layers_.merge(other.layers_, falls());
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) forget_behind(pixel);
        for (std::size_t i = 0; i < sums_.values.size(); ++i) {
            sums_.values[i] += other.sums_.values[i];
        }
        if (has_total_alpha()) total_alpha_.merge(other.total_alpha_);
    }

    void resolve(SampleColors& backdrop)
    {
        choose_layers();
        for_each_vector<S>(set_.count, [&](std::size_t pixel, std::size_t s) HWY_ATTR {
            if (layers_.layers(pixel) == 0 && !has_total_alpha()) return;
            const Shown shown = settings_.depth_based ? added_up(pixel, s) : of_layers(pixel, s);
            if (settings_.corrects) {
                return total_alpha_.dim(backdrop, pixel, s, shown.sum.color, shown.sum.weight);
            }
            resolve_samples<Text>(backdrop, pixel, s,
                                  [&](real3 behind, real& transmittance) HWY_ATTR {
                                      transmittance = shown.transmittance;
                                      return Text::over(shown.sum.color, transmittance, behind);
                                  });
        });
    }

    // What the layers let a fragment be seen; depth based.
    float transmittance_at(std::size_t pixel, float depth) requires(Kind::kForgets)
    {
        choose_layers();
        Layer there = Layers::nothing();
        there.depth = real(depth);
        there.id = whole(0u);
        const auto full = static_cast<std::size_t>(settings_.layers);
        return mean_over_samples<L>(count(), [&](std::size_t s) HWY_ATTR {
            const Front front = layers_.front_of(there, pixel, s);
            const real seen = Text::slab_visibility(kExplicit, front, settings_.bits);
            if (settings_.adds_tail) return seen;
            return L::zero_unless(!layers_.is_behind_all(there, full, pixel, s), seen);
        });
    }

private:
    struct Shown {
        Sum sum;
        real transmittance;  // of what is behind all, if nothing is corrected
    };

    std::size_t count() const { return layers_.count(); }
    bool has_total_alpha() const { return settings_.depth_based || settings_.corrects; }

    HWY_INLINE Layer fragment_at(const FragmentStream& f, const DepthPlane& plane, whole id,
                                 std::size_t i, std::size_t s) const
    {
        Layer fragment = Layers::nothing();
        const mask covered = sample_mask<L>(f, i, s);
        const real depth = sample_depth<L>(plane, set_, f.depth[i], s);
        fragment.depth = L::select(covered, depth, fragment.depth);
        fragment.id = L::select(covered, id, fragment.id);
        return fragment;
    }

    void insert_run(const FragmentStream& f, const FragmentRun& run)
    {
        const DepthPlane plane = run.depth;  // a copy, which what is stored cannot alias
        const whole id(run.primitive);
        draws_.for_each(f, run, [&](std::size_t i, std::size_t k) HWY_ATTR {
            const std::size_t pixel = f.pixel[i];
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                Layer fragment = fragment_at(f, plane, id, i, s);
                draw(fragment, f, i, k, s);
                layers_.put(fragment, pixel, s, falls());
            }
            forget_behind(pixel);
        });
    }
    HWY_INLINE void draw(Layer& fragment, const FragmentStream& f, std::size_t i, std::size_t k,
                         std::size_t s) const
    {
        const mask covered = Layers::there(fragment);
        if constexpr (kExplicit) {
            const auto word = [&](std::size_t which) HWY_ATTR {
                return L::zero_unless(covered, whole::load(draws_.word(k, s, which)));
            };
            fragment.bits.a = word(0);
            if constexpr (Words > 1) fragment.bits.b = word(1);
            if constexpr (Words > 2) fragment.bits.c = word(2);
            if constexpr (Words > 2) fragment.bits.d = word(3);
        } else {
            fragment.limit = L::zero_unless(covered, real::load(draws_.limit(k, s)));
            fragment.opacity = L::zero_unless(covered, real(f.opacity[i]));
        }
        if (!settings_.depth_based) fragment.color = color_of<Text>(f, i);
    }
    HWY_INLINE auto falls()
    {
        return [this](std::size_t pixel, std::size_t s, const Layer& fallen)
                   HWY_ATTR { Kind::fall(layers_, pixel, s, fallen); };
    }
    HWY_INLINE void forget_behind(std::size_t pixel)
    {
        if constexpr (!Kind::kForgets) return;
        draws_.farthest.data()[pixel] = layers_.farthest(pixel);
    }

    // Second pass.
    void add_run(const FragmentStream& f, const FragmentRun& run)
    {
        const DepthPlane plane = run.depth;
        const whole id(run.primitive);
        const auto full = static_cast<std::size_t>(settings_.layers);
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            const std::size_t pixel = f.pixel[i];
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                const Layer fragment = fragment_at(f, plane, id, i, s);
                mask added = Layers::there(fragment);
                if (!settings_.adds_tail) {
                    added = added && !layers_.is_behind_all(fragment, full, pixel, s);
                }
                const Front front = layers_.front_of(fragment, pixel, s);
                const real seen = Text::slab_visibility(kExplicit, front, settings_.bits);
                const real alpha = L::zero_unless(added, seen * real(f.opacity[i]));
                float* at = sums_.channel(pixel, 0) + s;
                const Sum sum =
                    Text::stochastic_depth_add(load_sum(at), alpha, color_of<Text>(f, i));
                save_color<Text>(sum.color, at, count());
                sum.weight.store(at + 3 * count());
            }
        }
    }
    HWY_INLINE Sum load_sum(const float* at) const
    {
        return {load_color<Text>(at, count()), real::load(at + 3 * count())};
    }

    HWY_INLINE Shown added_up(std::size_t pixel, std::size_t s) const
    {
        return {load_sum(sums_.channel(pixel, 0) + s), total_alpha_.load(pixel, s)};
    }
    HWY_INLINE Shown of_layers(std::size_t pixel, std::size_t s) const
    {
        Front front = Text::slab_no_front();
        Sum sum = Text::stochastic_depth_no_sum();
        for (std::size_t j = 0; j < layers_.layers(pixel); ++j) {
            const Layer layer = layers_.load(pixel, j, s);
            const real part = Text::slab_part(kExplicit, front, layer, settings_.bits);
            sum = Text::stochastic_depth_add(sum, part, layer.color);
            front = Text::slab_behind(front, Layers::there(layer), layer);
        }
        return {sum, Text::slab_visibility(kExplicit, front, settings_.bits)};
    }

    // When all candidates are there.
    void choose_layers()
    {
        if (!has_candidates_) return;
        has_candidates_ = false;
        const auto most = static_cast<std::size_t>(settings_.layers);
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (layers_.layers(pixel) == 0) continue;
            for (std::size_t s = 0; s < count(); s += L::kCount) choose_at(pixel, s, most);
            layers_.shorten(pixel, most);
        }
    }
    HWY_INLINE void choose_at(std::size_t pixel, std::size_t s, std::size_t most)
    {
        Front front = Text::slab_no_front();
        real sum = draws_.template xi_of_pixel<L>(pixel, s);
        layers_.thin_out(pixel, s, most, [&](const Layer& layer) HWY_ATTR {
            const real alpha = real(1.0f) - front.transmittance;
            const real chance =
                Text::slab_chance(settings_.stratified, alpha, layer.opacity, settings_.bits);
            const mask kept = Text::slab_passes(sum, L::zero_unless(Layers::there(layer), chance));
            front = Text::slab_behind(front, kept, layer);
            return kept;
        });
    }

    const SampleSet& set_;
    SlabSettings settings_;
    SlabDraws<Words> draws_;
    Layers layers_;
    SampleValues<4> sums_;  // depth based
    TotalAlpha<S> total_alpha_{0};
    bool has_candidates_ = false;  // of which layers are still to be chosen
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_SLAB_TILE_INL_H
