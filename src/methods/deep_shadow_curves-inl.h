// How curves of visibility are made: shaders/sheer/deep_shadow_map.glsl for a vector of samples.
#if defined(SHEER_DEEP_SHADOW_CURVES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_DEEP_SHADOW_CURVES_INL_H
#undef SHEER_DEEP_SHADOW_CURVES_INL_H
#else
#define SHEER_DEEP_SHADOW_CURVES_INL_H
#endif

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "lanes/lanes-inl.h"
#include "lanes/text.h"
#include "methods/deep_shadow_settings.h"
#include "methods/exact_layers.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct DeepShadowText {
#include "lanes/text_words.h"
#include "sheer/over.glsl"
#include "sheer/alpha_correction.glsl"
#include "sheer/deep_shadow_map.glsl"
};

// The curves at a pixel's samples s, s + 1, ..., while they are made: vertices lane by lane.
template <class L>
class CurveMaker {
public:
    using Text = DeepShadowText<L>;
    using real = typename L::real;
    using mask = typename L::mask;
    static constexpr std::size_t kLanes = L::kCount;

    // Sorted by depth, and by id: at sample s + lane.
    struct Occlusion {
        std::uint64_t key;
        float depth, opacity;
        bool operator<(const Occlusion& b) const { return key < b.key; }
    };
    std::vector<Occlusion> occlusions[kLanes];

    void clear()
    {
        for (auto& lane : occlusions) lane.clear();
    }
    void add(std::size_t lane, float depth, std::uint32_t id, float opacity)
    {
        occlusions[lane].push_back({ordered_bits(depth) << 32 | id, depth, opacity});
    }

    // Returns what passes through all.
    HWY_INLINE real make(real error)
    {
        line_up();
        for (auto& lane : vertices_) lane.clear();
        real v(1.0f);
        auto line = Text::deep_shadow_begin(real::load(depth(0)), v);
        keep(real::load(depth(0)) < beyond_any(), line);
        for (std::size_t i = 0; i < count_; ++i) {
            const real z = real::load(depth(i));
            const mask there = z < beyond_any();
            const mask first = i == 0 ? there : there & (real::load(depth(i - 1)) < z);
            go_on(line, first, z, v, error);
            v = v * (real(1.0f) - real::load(opacities_.data() + i * kLanes));
            go_on(line, there & (z < real::load(depth(i + 1))), z, v, error);
        }
        const mask ends = line.last > line.z;
        line = Text::deep_shadow_end(line, ends);
        keep(ends, line);
        return v;
    }

    const std::vector<CurveVertex>& vertices(std::size_t lane) const { return vertices_[lane]; }

private:
    static HWY_INLINE real beyond_any() { return real(std::numeric_limits<float>::infinity()); }
    const float* depth(std::size_t i) const { return depths_.data() + i * kLanes; }

    // The occlusions one a lane, beyond any and clear where there are no more.
    void line_up()
    {
        count_ = 0;
        for (auto& lane : occlusions) {
            std::sort(lane.begin(), lane.end());
            count_ = std::max(count_, lane.size());
        }
        depths_.assign((count_ + 1) * kLanes, std::numeric_limits<float>::infinity());
        opacities_.assign((count_ + 1) * kLanes, 0.0f);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            for (std::size_t i = 0; i < occlusions[lane].size(); ++i) {
                depths_[i * kLanes + lane] = occlusions[lane][i].depth;
                opacities_[i * kLanes + lane] = occlusions[lane][i].opacity;
            }
        }
    }

    HWY_INLINE void go_on(typename Text::DeepShadowLine& line, mask there, real z, real v,
                          real error)
    {
        const mask ends = Text::deep_shadow_ends(line, there, z, v, error);
        line = Text::deep_shadow_end(line, ends);
        keep(ends, line);
        const mask steps = Text::deep_shadow_steps(line, there, z, v, error);
        line = Text::deep_shadow_pass(line, there, steps, z, v, error);
        keep(steps, line);
    }

    HWY_INLINE void keep(mask those, const typename Text::DeepShadowLine& line)
    {
        std::uint32_t left = those.bits();
        if (left == 0) return;
        alignas(64) float z[16], v[16];
        line.z.store(z);
        line.v.store(v);
        for (; left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            vertices_[lane].push_back({z[lane], v[lane]});
        }
    }

    std::size_t count_ = 0;
    std::vector<float> depths_, opacities_;
    std::vector<CurveVertex> vertices_[kLanes];
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_DEEP_SHADOW_CURVES_INL_H
