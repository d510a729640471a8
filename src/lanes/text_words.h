// The words of shaders/sheer/prelude.glsl in C++. Included inside a class template over L, before
// the texts, which so become functions over L's lanes:
//
//   template <class L>
//   struct BlendText {
//   #include "lanes/text_words.h"
//   #include "sheer/over.glsl"
//   #include "sheer/blend.glsl"
//   };
//
// L is Lanes<S> (lanes-inl.h), or Lone<T> (lone.h) for one plain number.

using real = typename L::real;
using depth_real = typename L::depth_real;
using whole = typename L::whole;
using mask = typename L::mask;

struct real3 {
    real x, y, z;
    real3() = default;
    SHEER_INLINE real3(real a, real b, real c) : x(a), y(b), z(c) {}
    friend SHEER_INLINE real3 operator+(real3 a, real3 b)
    {
        return real3(a.x + b.x, a.y + b.y, a.z + b.z);
    }
    friend SHEER_INLINE real3 operator*(real a, real3 b)
    {
        return real3(a * b.x, a * b.y, a * b.z);
    }
    // Channel by channel.
    friend SHEER_INLINE real3 operator*(real3 a, real3 b)
    {
        return real3(a.x * b.x, a.y * b.y, a.z * b.z);
    }
};

SHEER_FN real select(mask m, real a, real b)
{
    return L::select(m, a, b);
}
SHEER_FN real3 select(mask m, real3 a, real3 b)
{
    return real3(L::select(m, a.x, b.x), L::select(m, a.y, b.y), L::select(m, a.z, b.z));
}
SHEER_FN whole select(mask m, whole a, whole b)
{
    return L::select(m, a, b);
}
// Of a depth_real that is no real.
template <class Depth>
SHEER_FN Depth select(mask m, const Depth& a, const Depth& b)
{
    return Depth::select(m, a, b);
}
SHEER_FN whole zero_unless(mask m, whole a)
{
    return L::zero_unless(m, a);
}
SHEER_FN real min(real a, real b)
{
    return L::min(a, b);
}
SHEER_FN real max(real a, real b)
{
    return L::max(a, b);
}
SHEER_FN real to_real(whole a)
{
    return L::to_real(a);
}
SHEER_FN whole to_whole(real a)
{
    return L::to_whole(a);
}
SHEER_FN whole bits_of(real a)
{
    return L::bits_of(a);
}
SHEER_FN real real_of_bits(whole a)
{
    return L::real_of_bits(a);
}
SHEER_FN real abs(real a)
{
    return L::max(a, real(0.0f) - a);
}
SHEER_FN real floor(real a)
{
    return L::floor(a);
}
SHEER_FN real octave(real a)
{
    return L::octave(a);
}
SHEER_FN real sqrt(real a)
{
    return L::sqrt(a);
}
