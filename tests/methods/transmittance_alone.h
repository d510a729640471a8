// The texts of methods that approximate transmittance, for texts_alone.h, which has the rest.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "methods/depth_range.h"
#include "methods/method_alone.h"
#include "methods/transmittance_functions.h"

namespace sheer::test {

// Of lists that say nothing of how far what is drawn reaches.
inline DepthRange depth_range_of(const FragmentLists& lists)
{
    return depth_range(lists.eye, true);
}

inline float place_in(const FragmentLists& lists, const ListedFragment& f)
{
    const DepthRange range = depth_range_of(lists);
    return FloatText::warped_depth(range.is_distance, std::min(std::max(f.center, f.least), f.most),
                                   range.from, range.scale);
}

inline int brightest_exponent(const FragmentLists& lists)
{
    float most = 0;
    for (const ListedFragment& f : lists.fragments) most = std::max({most, f.red, f.green, f.blue});
    int exponent = 0;
    std::frexp(most, &exponent);
    return exponent;
}

// Floats only.
template <class L>
struct TransmittanceAlone : MethodAlone<L> {
    using T = Texts<L>;
    using real3 = typename T::real3;
    static constexpr int kPasses = 4;

    struct Store {
        typename T::StochasticStore opaque;
        Sums sums;
        State state;
        float through;
        std::array<double, 4> color;
        int pass;
    };

    const std::shared_ptr<TransmittanceFunction> function = transmittance_function(this->method);
    const double color_magic = grid_magic(brightest_exponent(this->lists) + kColorGrid);
    const double weight_magic = grid_magic(kColorGrid);

    Store clear() const
    {
        return {T::stochastic_clear(std::numeric_limits<float>::infinity()),
                Sums(function->sums()),
                State(5),
                1,
                {},
                0};
    }

    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        if (this->pass > function->passes() + 1) return s;
        for (; s.pass < this->pass; ++s.pass) finish(s);
        const ListedFragment& f = this->lists.fragments[i];
        const bool covered = this->lists.covers(i, at);
        const typename T::StochasticStore here{this->lists.depth_at(i, at), f.primitive,
                                               this->color(i)};
        if (this->pass == 0) {
            s.opaque = T::stochastic_insert(s.opaque, covered && f.opacity >= 1, here);
            return s;
        }
        if (!covered || f.opacity >= 1 || !T::stochastic_nearer(s.opaque, here)) return s;
        const float place = place_in(this->lists, f);
        if (this->pass == 1) {
            function->add(s.sums, place, FloatText::optical_depth(f.opacity));
            return s;
        }
        const float seen = function->transmittance(s.state, place);
        if (this->pass <= function->passes()) {
            function->add(s.sums, place, FloatText::optical_depth(f.opacity * seen));
        } else {
            add_color(s, FloatText::visible_alpha(seen, f.opacity), this->color(i));
        }
        return s;
    }
    void add_color(Store& s, float weight, real3 color) const
    {
        const real3 part = weight * color;
        const float channels[] = {part.x, part.y, part.z};
        for (std::size_t c = 0; c < 3; ++c) {
            s.color[c] += on_grid(static_cast<double>(channels[c]), color_magic);
        }
        s.color[3] += on_grid(static_cast<double>(weight), weight_magic);
    }
    void finish(Store& s) const
    {
        if (s.pass == 0 || s.pass > function->passes()) return;
        s.state =
            s.pass == 1 ? function->prepare(s.sums) : function->prepare_again(s.state, s.sums);
        if (s.pass == 1) s.through = FloatText::exp_of(-as_float(s.sums[0]));
        s.sums.assign(s.sums.size(), 0);
    }

    static bool is_hidden(const Store& s)
    {
        return s.opaque.depth < std::numeric_limits<float>::infinity();
    }
    static real3 resolve(const Store& s, real3 backdrop)
    {
        const real3 behind = is_hidden(s) ? s.opaque.color : backdrop;
        const auto color = FloatText::visible_resolve(
            {as_float(s.color[0]), as_float(s.color[1]), as_float(s.color[2])},
            as_float(s.color[3]), s.through, {behind.x, behind.y, behind.z});
        return {color.x, color.y, color.z};
    }
    static float transmittance(const Store& s) { return is_hidden(s) ? 0 : s.through; }
    static auto keep(const Store& s)
    {
        return TransmittanceAlone::kept({s.state[0], s.state[1], s.state[2]}, s.state[3],
                                        s.through);
    }
};

}  // namespace sheer::test
