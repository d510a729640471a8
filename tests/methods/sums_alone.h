// The texts of methods that add up all fragments, for texts_alone.h, which has the rest.
#pragma once

#include "methods/fragment_lists.h"

namespace sheer::test {

template <class L>
struct Texts;
template <class L>
struct MethodAlone;

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

}  // namespace sheer::test
