// Three-component vectors over lanes.
#if defined(SHEER_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_VECTORS_INL_H
#undef SHEER_VECTORS_INL_H
#else
#define SHEER_VECTORS_INL_H
#endif

#include <sheer/scene.h>

#include "lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct Vector {
    using real = typename L::real;
    real x, y, z;

    static HWY_INLINE Vector of(const Float3& v) { return {real(v[0]), real(v[1]), real(v[2])}; }
    static HWY_INLINE Vector all(float v) { return {real(v), real(v), real(v)}; }
    friend HWY_ATTR HWY_INLINE Vector operator+(Vector a, Vector b)
    {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend HWY_ATTR HWY_INLINE Vector operator-(Vector a, Vector b)
    {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    // Channel by channel.
    friend HWY_ATTR HWY_INLINE Vector operator*(Vector a, Vector b)
    {
        return {a.x * b.x, a.y * b.y, a.z * b.z};
    }
    friend HWY_ATTR HWY_INLINE Vector operator*(real s, Vector v)
    {
        return {s * v.x, s * v.y, s * v.z};
    }
};

template <class L>
HWY_INLINE typename L::real dot(const Vector<L>& a, const Vector<L>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class L>
HWY_INLINE Vector<L> cross(const Vector<L>& a, const Vector<L>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class L>
HWY_INLINE Vector<L> select(typename L::mask m, const Vector<L>& a, const Vector<L>& b)
{
    return {L::select(m, a.x, b.x), L::select(m, a.y, b.y), L::select(m, a.z, b.z)};
}

// Of length 1; zero where it is shorter than 1e-10 (docs/numerics.md).
template <class L>
HWY_INLINE Vector<L> normalized(const Vector<L>& v)
{
    using real = typename L::real;
    const real squared = dot(v, v);
    return L::zero_unless(squared >= real(1e-20f), real(1.0f) / L::sqrt(squared)) * v;
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_VECTORS_INL_H
