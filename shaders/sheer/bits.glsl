// Bits of a word.
//
// Needs prelude.glsl.

// How many there are.
SHEER_FN whole bit_count(whole x)
{
    x = x - ((x >> 1) & whole(0x55555555u));
    x = (x & whole(0x33333333u)) + ((x >> 2) & whole(0x33333333u));
    x = (x + (x >> 4)) & whole(0x0f0f0f0fu);
    return (x * whole(0x01010101u)) >> 24;
}
