// The words that the texts of this folder are written in, for GLSL 4.5 and later. Include it first.
//
// A text is pure: values go in, values come out; no bindings, no main, no loop whose length depends
// on a pixel. In C++ the same words stand for vectors, one pixel or sample a lane
// (src/lanes/text_words.h), so nothing here branches on a `mask`: `select` takes both sides.
#ifndef SHEER_PRELUDE
#define SHEER_PRELUDE

#define real float
#define real3 vec3
#define depth_real float  // what depths are compared in; the CPU has finer ones too
#define whole uint        // wraps around; compared only below 2^31
#define mask bool

#define SHEER_FN
#define SHEER_INOUT(type) inout type

float select(bool m, float a, float b)
{
    return m ? a : b;
}
vec3 select(bool m, vec3 a, vec3 b)
{
    return m ? a : b;
}
uint select(bool m, uint a, uint b)
{
    return m ? a : b;
}
uint zero_unless(bool m, uint a)
{
    return m ? a : 0u;
}

float to_real(uint a)
{
    return float(a);
}
uint to_whole(float a)
{
    return a < 0.0 ? uint(int(a)) : uint(a);
}  // towards zero; -2^31 to 2^31
float octave(float a)
{
    return uintBitsToFloat(floatBitsToUint(a) & 0x7f800000u);
}  // the largest power of 2 that is no larger; a positive and not denormal

// The same bits.
uint bits_of(float a)
{
    return floatBitsToUint(a);
}
float real_of_bits(uint a)
{
    return uintBitsToFloat(a);
}

#endif
