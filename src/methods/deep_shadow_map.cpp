// Deep shadow maps: shaders/sheer/deep_shadow_map.glsl at every sample.
//
// The first pass keeps what the curves need of every fragment, 24 bytes; before the second they are
// made, 8 bytes a vertex, of which there are two for a fragment at most, and what was kept is let
// go. 20 bytes a sample for the sum and what passes.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/deep_shadow_map.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <limits>
#include <memory_resource>
#include <vector>

#include <hwy/foreach_target.h>

#include "methods/deep_shadow_curves-inl.h"
#include "methods/deep_shadow_settings.h"
#include "methods/samples-inl.h"
#include "raster/sample_depth-inl.h"
#include "support/pages.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Of a tile's fragments, what curves are made of.
struct Occluder {
    float opacity;
    float depth;  // at the pixel's centre
    std::uint32_t pixel, run;
    std::uint32_t samples, samples_high;
};

template <int S>
class DeepShadowTile {
    using L = Lanes<S>;
    using Text = DeepShadowText<L>;
    using Vertex = typename Text::DeepShadowVertex;
    using Sum = typename Text::DeepShadowSum;
    using real3 = typename Text::real3;
    using real = typename L::real;
    using mask = typename L::mask;

public:
    explicit DeepShadowTile(const StoreShape& shape)
        : set_(*shape.samples),
          settings_(deep_shadow_settings(*shape.method)),
          memory_(memory_within(shape.most_bytes)),
          sums_(set_.count),
          most_bytes_(shape.most_bytes - std::min(shape.most_bytes, sums_bytes()))
    {
    }

    void clear(const TilePlace&)
    {
        if (touched() > most_bytes_) give_back();
        pass_ = 0;
        occluders_.clear();
        runs_.clear();
        std::fill(counts_.begin(), counts_.end(), 0u);
        vertices_.clear();
        std::fill_n(lengths_, kTilePixels, 0u);
        std::fill_n(sums_.values.data(), sums_.values.size(), 0.0f);
    }

    bool insert(const FragmentStream& f, int pass)
    {
        if (pass == 0) return collect(f);
        if (pass_ == 0 && !make_curves()) return false;
        for (int r = 0; r < f.run_count; ++r) add_run(f, f.runs[r]);
        return true;
    }

    void merge(const DeepShadowTile& other)
    {
        const auto shift = static_cast<std::uint32_t>(runs_.size());
        runs_.insert(runs_.end(), other.runs_.begin(), other.runs_.end());
        for (Occluder occluder : other.occluders_) {
            occluder.run += shift;
            occluders_.push_back(occluder);
        }
        for (std::size_t p = 0; p < kTilePixels; ++p) counts_[p] += other.counts_[p];
        for_each_vector<S>(set_.count, [&](std::size_t pixel, std::size_t s) HWY_ATTR {
            save_sum(Text::deep_shadow_merge(load_sum(pixel, s), other.load_sum(pixel, s)), pixel,
                     s);
        });
    }

    void resolve(SampleColors& backdrop) const
    {
        for_each_vector<S>(set_.count, [&](std::size_t pixel, std::size_t s) HWY_ATTR {
            if (lengths_[pixel] == 0) return;
            const Sum sum = load_sum(pixel, s);
            const real through = real::load(sums_.channel(pixel, 4) + s);
            resolve_samples<Text>(
                backdrop, pixel, s, [&](real3 behind, real& transmittance) HWY_ATTR {
                    transmittance = through;
                    return Text::deep_shadow_resolve(settings_.corrects, sum, through, behind);
                });
        });
    }

    float transmittance_at(std::size_t pixel, float depth)
    {
        if (pass_ == 0 && !make_curves()) return std::numeric_limits<float>::quiet_NaN();
        if (lengths_[pixel] == 0) return 1.0f;
        return mean_over_samples<L>(
            count(), [&](std::size_t s) HWY_ATTR { return seen_at(pixel, s, real(depth)); });
    }

private:
    static constexpr float kBeyondAny = std::numeric_limits<float>::infinity();

    std::size_t count() const { return sample_count<S>(set_.count); }
    std::size_t sums_bytes() const { return sums_.values.size() * sizeof(float); }

    HWY_INLINE Sum load_sum(std::size_t pixel, std::size_t s) const
    {
        const float* at = sums_.channel(pixel, 0) + s;
        return {load_color<Text>(at, count()), real::load(at + 3 * count())};
    }
    HWY_INLINE void save_sum(const Sum& sum, std::size_t pixel, std::size_t s)
    {
        float* at = sums_.channel(pixel, 0) + s;
        save_color<Text>(sum.color, at, count());
        sum.weight.store(at + 3 * count());
    }

    // ---- the first pass -----------------------------------------------------------------------

    // A vector that grows holds its old contents beside the new for a while.
    std::size_t touched() const
    {
        return 3 * (occluders_.capacity() * sizeof(Occluder) + runs_.capacity() * sizeof(LayerRun) +
                    vertices_.capacity() * sizeof(float)) +
               by_pixel_.capacity() * sizeof(Occluder);
    }
    void give_back()
    {
        sheer::give_back(occluders_);
        sheer::give_back(by_pixel_);
        sheer::give_back(runs_);
        sheer::give_back(vertices_);
    }

    bool collect(const FragmentStream& f)
    {
        const std::size_t size = occluders_.size() + static_cast<std::size_t>(f.size);
        if (size * 4 * sizeof(Occluder) > most_bytes_) return false;
        for (std::size_t r = 0; r < static_cast<std::size_t>(f.run_count); ++r) {
            const FragmentRun& run = f.runs[r];
            const auto number = static_cast<std::uint32_t>(runs_.size());
            runs_.push_back({run.depth, run.primitive, 0});
            for (std::size_t i = run.first; i < run.first + run.count; ++i) {
                occluders_.push_back({f.opacity[i], f.depth[i], f.pixel[i], number, f.samples[i],
                                      f.samples_high[i]});
                ++counts_[f.pixel[i]];
            }
        }
        return true;
    }

    // ---- curves -------------------------------------------------------------------------------

    // False: there is no room.
    bool make_curves()
    {
        pass_ = 1;
        sort_by_pixel();
        CurveMaker<L> maker;
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (counts_[pixel] == 0) continue;
            make_curves_of(pixel, maker);
            if (touched() > most_bytes_) return false;
        }
        sheer::give_back(occluders_);
        sheer::give_back(by_pixel_);
        return true;
    }

    // A counting sort.
    void sort_by_pixel()
    {
        std::vector<std::uint32_t> next(kTilePixels);
        std::uint32_t first = 0;
        for (std::size_t p = 0; p < kTilePixels; ++p) {
            next[p] = first;
            first += counts_[p];
        }
        by_pixel_.resize(occluders_.size());
        for (const Occluder& occluder : occluders_) by_pixel_[next[occluder.pixel]++] = occluder;
        std::copy(next.begin(), next.end(), ends_);
    }

    void make_curves_of(std::size_t pixel, CurveMaker<L>& maker)
    {
        curves_.resize(count());
        std::size_t longest = 0;
        for (std::size_t s = 0; s < count(); s += L::kCount) {
            maker.clear();
            for (std::size_t i = ends_[pixel] - counts_[pixel]; i < ends_[pixel]; ++i) {
                add_occluder(by_pixel_[i], s, maker);
            }
            maker.make(real(settings_.error)).store(sums_.channel(pixel, 4) + s);
            for (std::size_t lane = 0; lane < L::kCount; ++lane) {
                curves_[s + lane] = maker.vertices(lane);
                longest = std::max(longest, curves_[s + lane].size());
            }
        }
        lengths_[pixel] = static_cast<std::uint32_t>(longest);
        firsts_[pixel] = vertices_.size();
        for (std::size_t k = 0; k < longest; ++k) {
            for (const auto& curve : curves_) {
                vertices_.push_back(k < curve.size() ? curve[k].z : kBeyondAny);
            }
            for (const auto& curve : curves_) {
                vertices_.push_back(curve.empty()      ? 1.0f
                                    : k < curve.size() ? curve[k].v
                                                       : curve.back().v);
            }
        }
    }

    void add_occluder(const Occluder& o, std::size_t s, CurveMaker<L>& maker)
    {
        const LayerRun& run = runs_[o.run];
        const std::uint32_t word = s < 32 ? o.samples : o.samples_high;
        const auto lanes = static_cast<std::uint32_t>(word >> (s & 31) & ((1ull << L::kCount) - 1));
        for (std::uint32_t left = lanes; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            maker.add(lane, sample_depth_at(run.depth, set_, o.depth, s + lane), run.primitive,
                      o.opacity);
        }
    }

    // ---- the second pass ----------------------------------------------------------------------

    HWY_INLINE void add_run(const FragmentStream& f, const FragmentRun& run)
    {
        const DepthPlane plane = run.depth;  // a copy, which what is stored cannot alias
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            const std::size_t pixel = f.pixel[i];
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                const real seen = seen_at(pixel, s, sample_depth<L>(plane, set_, f.depth[i], s));
                save_sum(Text::deep_shadow_add(load_sum(pixel, s), sample_mask<L>(f, i, s),
                                               color_of<Text>(f, i), real(f.opacity[i]), seen),
                         pixel, s);
            }
        }
    }

    HWY_INLINE real seen_at(std::size_t pixel, std::size_t s, real z) const
    {
        real seen(1.0f);
        const float* at = vertices_.data() + firsts_[pixel] + s;
        Vertex a = {real::load(at), real::load(at + count())};
        for (std::uint32_t k = 1; k < lengths_[pixel]; ++k) {
            if (!(z > a.z).any()) return seen;
            at += 2 * count();
            const Vertex b = {real::load(at), real::load(at + count())};
            seen = Text::deep_shadow_seen(seen, a, b, z);
            a = b;
        }
        return seen;
    }

    const SampleSet& set_;
    const DeepShadowSettings settings_;
    std::pmr::memory_resource* const memory_;
    std::pmr::vector<Occluder> occluders_{memory_}, by_pixel_{memory_};
    std::pmr::vector<LayerRun> runs_{memory_};
    std::vector<std::uint32_t> counts_ = std::vector<std::uint32_t>(kTilePixels);
    std::uint32_t ends_[kTilePixels] = {};  // of each pixel in by_pixel_
    // A pixel's curves: vertex after vertex, the z of all samples and then their v, from firsts_
    // on; the longest of them has as many vertices as lengths_ says, the others have vertices
    // beyond any depth at their end.
    std::pmr::vector<float> vertices_{memory_};
    std::size_t firsts_[kTilePixels] = {};
    std::uint32_t lengths_[kTilePixels] = {};
    std::vector<std::vector<CurveVertex>> curves_;  // of the pixel at hand
    SampleValues<5> sums_;          // colours, their weight, and what passes through all
    const std::size_t most_bytes_;  // for what grows
    int pass_ = 0;
};

StoreVerbs deep_shadow_map_store(int samples)
{
    return verbs_for_samples<DeepShadowTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(deep_shadow_map_store);

StoreVerbs deep_shadow_map_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(deep_shadow_map_store, targets)(samples);
}

}  // namespace sheer
#endif
