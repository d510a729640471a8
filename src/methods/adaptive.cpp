// Adaptive transparency: shaders/sheer/adaptive.glsl at every sample. 12 bytes a node and sample,
// and 12 for the sum.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/adaptive.cpp"
#include "lanes/targets.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include <hwy/foreach_target.h>

#include "lanes/lone.h"
#include "methods/samples-inl.h"
#include "raster/sample_depth-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct AdaptiveText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/adaptive.glsl"
};

// The nodes of a pixel's samples: the first used_[pixel] have been written to.
template <int S>
class AdaptiveTile {
    using L = Lanes<S>;
    using Text = AdaptiveText<L>;
    using Node = typename Text::AdaptiveNode;
    using Fragment = typename Text::AdaptiveFragment;
    using Choice = typename Text::AdaptiveChoice;
    using real3 = typename Text::real3;
    using real = typename L::real;
    using whole = typename L::whole;
    using mask = typename L::mask;
    using LoneText = AdaptiveText<Lone<float>>;
    using LoneNode = typename LoneText::AdaptiveNode;
    static constexpr std::size_t kChannels = 3;

public:
    explicit AdaptiveTile(const StoreShape& shape)
        : set_(*shape.samples),
          most_(static_cast<std::size_t>(shape.method->number("nodes"))),
          nodes_(kTilePixels * most_ * kChannels * count()),
          sums_(set_.count)
    {
    }

    void clear(const TilePlace&)
    {
        std::fill_n(used_, kTilePixels, 0u);
        std::fill_n(sums_.values.data(), sums_.values.size(), 0.0f);
    }

    void insert(const FragmentStream& f, int pass)
    {
        for (int r = 0; r < f.run_count; ++r) {
            pass == 0 ? insert_run<true>(f, f.runs[r]) : insert_run<false>(f, f.runs[r]);
        }
    }

    // Light passes both: the product of the curves.
    void merge(const AdaptiveTile& other)
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            if (other.used_[pixel] == 0) continue;
            std::vector<std::vector<LoneNode>> merged;
            std::size_t most = 0;
            for (std::size_t s = 0; s < count(); ++s) {
                merged.push_back(product(curve(pixel, s), other.curve(pixel, s)));
                most = std::max(most, merged.back().size());
            }
            used_[pixel] = static_cast<std::uint32_t>(most);
            for (std::size_t s = 0; s < count(); ++s) save_curve(merged[s], pixel, s);
        }
    }

    void resolve(SampleColors& backdrop) const
    {
        for_each_vector<S>(set_.count, [&](std::size_t pixel, std::size_t s) HWY_ATTR {
            if (used_[pixel] == 0) return;
            const Node last = load(pixel, used_[pixel] - 1, s);
            const real3 sum = load_color<Text>(sums_.channel(pixel, 0) + s, count());
            resolve_samples<Text>(backdrop, pixel, s,
                                  [&](real3 behind, real& transmittance) HWY_ATTR {
                                      transmittance = last.transmittance;
                                      return Text::adaptive_resolve(sum, last, behind);
                                  });
        });
    }

    float transmittance_at(std::size_t pixel, float depth) const
    {
        const Fragment f{real(depth), whole(0u), real(0.0f)};
        return mean_over_samples<L>(count(),
                                    [&](std::size_t s) HWY_ATTR { return seen_at(f, pixel, s); });
    }

private:
    static constexpr float kBeyondAny = std::numeric_limits<float>::infinity();

    std::size_t count() const { return sample_count<S>(set_.count); }
    float* at(std::size_t pixel, std::size_t node, std::size_t s)
    {
        return nodes_.data() + (pixel * most_ + node) * kChannels * count() + s;
    }
    const float* at(std::size_t pixel, std::size_t node, std::size_t s) const
    {
        return nodes_.data() + (pixel * most_ + node) * kChannels * count() + s;
    }
    HWY_INLINE Node load(std::size_t pixel, std::size_t node, std::size_t s) const
    {
        const float* from = at(pixel, node, s);
        return {real::load(from), whole::bits_of(real::load(from + count())),
                real::load(from + 2 * count())};
    }
    HWY_INLINE void save(const Node& n, std::size_t pixel, std::size_t node, std::size_t s)
    {
        float* to = at(pixel, node, s);
        n.depth.store(to);
        n.id.as_real().store(to + count());
        n.transmittance.store(to + 2 * count());
    }

    // Into the curve, or added up as far as the curve lets it be seen.
    template <bool IntoCurve>
    HWY_INLINE void insert_run(const FragmentStream& f, const FragmentRun& run)
    {
        const DepthPlane plane = run.depth;  // a copy, which what is stored cannot alias
        const whole id(run.primitive);
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            const std::size_t pixel = f.pixel[i];
            for (std::size_t s = 0; s < count(); s += L::kCount) {
                const Fragment fragment = Text::adaptive_fragment(
                    sample_mask<L>(f, i, s), real(kBeyondAny),
                    sample_depth<L>(plane, set_, f.depth[i], s), id, real(f.opacity[i]));
                if constexpr (IntoCurve) {
                    lower(fragment, pixel, s);
                } else {
                    add(fragment, color_of<Text>(f, i), pixel, s);
                }
            }
            if (IntoCurve && used_[pixel] < most_) ++used_[pixel];
        }
    }

    // adaptive_exchange with all nodes, from the far end, as most fragments pass by few of them.
    HWY_INLINE void lower(const Fragment& f, std::size_t pixel, std::size_t s)
    {
        const std::size_t used = used_[pixel];
        if (used == 0) return save(Text::adaptive_node(f), pixel, 0, s);
        std::size_t i = used - 1;
        Node here = load(pixel, i, s);
        const Node carried = Text::adaptive_next(here, f);
        mask behind = Text::adaptive_behind(here, f);
        for (; i > 0 && behind.any(); --i) {
            const Node before = load(pixel, i - 1, s);
            save(Text::adaptive_select(behind, Text::adaptive_next(before, f), here), pixel, i, s);
            here = before;
            behind = Text::adaptive_behind(before, f);
        }
        if (i == 0) {
            save(Text::adaptive_select(behind, Text::adaptive_node(f), here), pixel, 0, s);
        }
        if (used < most_) return save(carried, pixel, used, s);
        remove(carried, pixel, s);
    }

    HWY_INLINE void remove(const Node& carried, std::size_t pixel, std::size_t s)
    {
        Choice choice = Text::adaptive_no_choice();
        Node before = load(pixel, 0, s);
        for (std::size_t i = 1; i < most_; ++i) {
            const Node n = load(pixel, i, s);
            choice = Text::adaptive_choose(choice, number(i), before, n);
            before = n;
        }
        choice =
            Text::adaptive_choose_last(choice, number(most_), before, carried, real(kBeyondAny));
        for (std::size_t i = 0; i < most_; ++i) {
            const Node next = i + 1 < most_ ? load(pixel, i + 1, s) : carried;
            save(Text::adaptive_remove(choice, number(i), load(pixel, i, s), next), pixel, i, s);
        }
    }
    static HWY_INLINE whole number(std::size_t i) { return whole(static_cast<std::uint32_t>(i)); }

    HWY_INLINE real seen_at(const Fragment& f, std::size_t pixel, std::size_t s) const
    {
        real seen(1.0f);
        for (std::size_t i = 0; i < used_[pixel]; ++i) {
            seen = Text::adaptive_seen(seen, load(pixel, i, s), f);
        }
        return seen;
    }
    HWY_INLINE void add(const Fragment& f, real3 color, std::size_t pixel, std::size_t s)
    {
        const real seen = seen_at(f, pixel, s);
        float* sum = sums_.channel(pixel, 0) + s;
        save_color<Text>(Text::adaptive_add(load_color<Text>(sum, count()), seen, f, color), sum,
                         count());
    }

    // Of one sample, without what is beyond any.
    std::vector<LoneNode> curve(std::size_t pixel, std::size_t s) const
    {
        std::vector<LoneNode> nodes;
        for (std::size_t i = 0; i < used_[pixel]; ++i) {
            const float* from = at(pixel, i, s);
            if (from[0] == kBeyondAny) break;
            nodes.push_back(
                {from[0], std::bit_cast<std::uint32_t>(from[count()]), from[2 * count()]});
        }
        return nodes;
    }
    void save_curve(const std::vector<LoneNode>& nodes, std::size_t pixel, std::size_t s)
    {
        LoneNode node = LoneText::adaptive_clear(kBeyondAny);
        for (std::size_t i = 0; i < used_[pixel]; ++i) {
            const float through = node.transmittance;
            node = i < nodes.size() ? nodes[i] : LoneText::adaptive_clear(kBeyondAny);
            if (i >= nodes.size()) node.transmittance = through;
            float* to = at(pixel, i, s);
            to[0] = node.depth;
            to[count()] = std::bit_cast<float>(node.id);
            to[2 * count()] = node.transmittance;
        }
    }
    std::vector<LoneNode> product(const std::vector<LoneNode>& a,
                                  const std::vector<LoneNode>& b) const
    {
        std::vector<LoneNode> nodes;
        float through_a = 1, through_b = 1;
        for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
            const bool takes_a =
                j == b.size() ||
                (i < a.size() && LoneText::adaptive_behind(b[j], {a[i].depth, a[i].id, 0}));
            nodes.push_back(takes_a ? a[i++] : b[j++]);
            (takes_a ? through_a : through_b) = nodes.back().transmittance;
            nodes.back().transmittance = through_a * through_b;
        }
        while (nodes.size() > most_) {
            auto choice = LoneText::adaptive_no_choice();
            for (std::uint32_t i = 1; i < nodes.size(); ++i) {
                choice = LoneText::adaptive_choose(choice, i, nodes[i - 1], nodes[i]);
            }
            nodes[choice.node - 1].transmittance = nodes[choice.node].transmittance;
            nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(choice.node));
        }
        return nodes;
    }

    const SampleSet& set_;
    std::size_t most_;
    AlignedArray<float> nodes_;
    SampleValues<3> sums_;
    std::uint32_t used_[kTilePixels] = {};
};

StoreVerbs adaptive_store(int samples)
{
    return verbs_for_samples<AdaptiveTile>(samples);
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sheer {

HWY_EXPORT(adaptive_store);

StoreVerbs adaptive_verbs(TargetSet targets, const ChosenMethod&, int samples)
{
    return SHEER_DISPATCH(adaptive_store, targets)(samples);
}

}  // namespace sheer
#endif
