// The texts of methods that add up all fragments, for texts_alone.h, which has the rest.
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "methods/deep_shadow_settings.h"
#include "methods/method_alone.h"

namespace sheer::test {

// Distance as a depth buffer between znear and zfar has it.
inline float in_buffer(const EyeSpace& eye, float z)
{
    const float near = eye.znear, far = eye.zfar;
    if (eye.orthographic) return far > near ? (z - near) / (far - near) : 0.0f;
    return far > 0 ? (near * far / z - far) / (near - far) : 1.0f - near / z;
}

template <class L>
struct PhenomenologicalAlone : MethodAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using Store = typename T::PhenomenologicalStore;

    static Store clear() { return T::phenomenological_clear(); }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const EyeSpace& eye = this->lists.eye;
        const real d(in_buffer(eye, this->lists.distance_of(i)));
        const real through = real(1.0f) - this->opacity(i);
        return T::phenomenological_insert(s, this->lists.covers(i, at), this->color(i),
                                          this->opacity(i), {through, through, through},
                                          T::phenomenological_weight(d, this->opacity(i)));
    }
    static auto resolve(Store s, typename T::real3 behind)
    {
        return T::phenomenological_resolve(s, behind);
    }
    static auto transmittance(Store s) { return T::phenomenological_transmittance(s); }
    static auto keep(Store s)
    {
        return PhenomenologicalAlone::kept(s.color, s.weight, s.transmittance.x);
    }
};

template <class L>
struct DeepShadowAlone : MethodAlone<L> {
    using T = Texts<L>;
    using real = typename L::real;
    using Line = typename T::DeepShadowLine;
    static constexpr int kPasses = 2;
    struct Occluder {
        float depth;
        std::uint32_t id;
        real opacity;
    };
    struct Store {
        std::vector<Occluder> occluders;
        std::vector<typename T::DeepShadowVertex> curve;
        real through;
        typename T::DeepShadowSum sum;
        bool corrects;
    };
    const DeepShadowSettings settings = deep_shadow_settings(this->method);

    Store clear() const { return {{}, {}, real(1.0f), T::deep_shadow_no_sum(), settings.corrects}; }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        const bool covered = this->lists.covers(i, at);
        const float depth = this->lists.depth_at(i, at);
        if (this->pass == 0) {
            if (!covered) return s;
            s.occluders.push_back({depth, this->lists.fragments[i].primitive, this->opacity(i)});
            return s;
        }
        if (s.curve.empty() && !s.occluders.empty()) make_curve(s);
        real seen(1.0f);
        for (std::size_t k = 0; k + 1 < s.curve.size(); ++k) {
            seen = T::deep_shadow_seen(seen, s.curve[k], s.curve[k + 1], real(depth));
        }
        s.sum = T::deep_shadow_add(s.sum, covered, this->color(i), this->opacity(i), seen);
        return s;
    }
    void make_curve(Store& s) const
    {
        auto& all = s.occluders;
        std::sort(all.begin(), all.end(), [](const Occluder& a, const Occluder& b) {
            return std::tie(a.depth, a.id) < std::tie(b.depth, b.id);
        });
        Line line = T::deep_shadow_begin(real(all[0].depth), real(1.0f));
        s.curve.push_back({line.z, line.v});
        for (std::size_t i = 0; i < all.size(); ++i) {
            const float z = all[i].depth;
            if (i == 0 || all[i - 1].depth < z) go_on(s, line, real(z));
            s.through = s.through * (real(1.0f) - all[i].opacity);
            if (i + 1 == all.size() || z < all[i + 1].depth) go_on(s, line, real(z));
        }
        const bool ends = line.last > line.z;
        line = T::deep_shadow_end(line, ends);
        if (ends) s.curve.push_back({line.z, line.v});
    }
    void go_on(Store& s, Line& line, real z) const
    {
        const real error(settings.error);
        const bool ends = T::deep_shadow_ends(line, true, z, s.through, error);
        line = T::deep_shadow_end(line, ends);
        if (ends) s.curve.push_back({line.z, line.v});
        const bool steps = T::deep_shadow_steps(line, true, z, s.through, error);
        line = T::deep_shadow_pass(line, true, steps, z, s.through, error);
        if (steps) s.curve.push_back({line.z, line.v});
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::deep_shadow_resolve(s.corrects, s.sum, s.through, behind);
    }
    static real transmittance(const Store& s) { return s.through; }
    static auto keep(const Store& s)
    {
        const auto vertices = static_cast<float>(s.curve.size());
        return DeepShadowAlone::kept(s.sum.color, s.sum.weight, real(vertices));
    }
};

}  // namespace sheer::test
