// The texts of peeling, for texts_alone.h, which has the rest.
#pragma once

#include "methods/layered_alone.h"

namespace sheer::test {

// Until a pass finds nothing.
template <class L>
struct DepthPeelingAlone : LayersAlone<L> {
    using T = Texts<L>;
    using Store = typename T::DepthPeel;
    static constexpr int kPasses = 4096;
    mutable int begun = 0;

    Store clear() const
    {
        begun = 0;
        return T::depth_peeling_clear(this->beyond_any());
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        if (this->pass != begun) s = T::depth_peeling_begin(s, this->beyond_any());
        begun = this->pass;
        return T::depth_peeling_insert(s, this->layer(i, at));
    }
    bool done(const Store& s) const
    {
        return this->pass + 1 == this->method.number("peels") ||
               !(s.nearest.depth < this->beyond_any());
    }
    static auto all(const Store& s)
    {
        return T::depth_peeling_begin(s, DepthPeelingAlone::beyond_any()).front;
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::layer_resolve(all(s), behind);
    }
    static auto transmittance(const Store& s) { return DepthPeelingAlone::through(all(s)); }
    static auto keep(const Store& s)
    {
        return DepthPeelingAlone::kept(all(s).color, all(s).opacity, all(s).depth);
    }
};

template <class L>
struct DualPeelingAlone : LayersAlone<L> {
    using T = Texts<L>;
    using Store = typename T::DualPeel;
    static constexpr int kPasses = 4096;
    mutable int begun = 0;

    Store clear() const
    {
        begun = 0;
        return T::dual_peeling_clear(this->beyond_any());
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        if (this->pass != begun) s = T::dual_peeling_begin(s, this->beyond_any());
        begun = this->pass;
        return T::dual_peeling_insert(s, this->layer(i, at));
    }
    bool done(const Store& s) const
    {
        return this->pass + 1 == this->method.number("peels") ||
               !(s.nearest.depth < this->beyond_any());
    }
    static auto all(const Store& s)
    {
        const Store last = T::dual_peeling_begin(s, DualPeelingAlone::beyond_any());
        return T::layer_over(last.front, last.back);
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::layer_resolve(all(s), behind);
    }
    static auto transmittance(const Store& s) { return DualPeelingAlone::through(all(s)); }
    static auto keep(const Store& s)
    {
        return DualPeelingAlone::kept(all(s).color, all(s).opacity, all(s).depth);
    }
};

}  // namespace sheer::test
