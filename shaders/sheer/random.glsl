// Random numbers by counting: each is a hash of what it is for, so that no order shows.
//
// Needs prelude.glsl.

// "lowbias32", found by Christopher Wellons's search for the two-round xorshift-multiply hash with
// the least bias (Prospecting for Hash Functions, 2018). A bijection; 0 goes to 0.
SHEER_FN whole hash_whole(whole x)
{
    x = x ^ (x >> 16);
    x = x * whole(0x7feb352du);
    x = x ^ (x >> 15);
    x = x * whole(0x846ca68bu);
    x = x ^ (x >> 16);
    return x;
}

// Of what `identity` names; `key` is a frame's.
SHEER_FN whole identity_seed(whole identity, whole key)
{
    return hash_whole(identity + hash_whole(key));
}

// Where the sequence of that in pixel (x, y) of the picture begins, both below 2^14. Numbers on the
// way to being hashed: of two pixels that share some, one is thousands of rows below the other.
SHEER_FN whole fragment_seed(whole x, whole y, whole identity)
{
    return x + (y << 14) + identity;
}

// The next number of the sequence that begins at a seed: 32 bits.
SHEER_FN whole next_hash(SHEER_INOUT(whole) state)
{
    // Weyl's sequence (2^32 / golden ratio, odd) goes through all states and keeps them apart.
    state = state + whole(0x9e3779b9u);
    return hash_whole(state);
}

// The same with 24 bits, so that it compares and multiplies without overflow.
SHEER_FN whole next_random(SHEER_INOUT(whole) state)
{
    return next_hash(state) >> 8;
}

// The same as a real in [0, 1).
SHEER_FN real next_random_real(SHEER_INOUT(whole) state)
{
    return to_real(next_random(state)) * real(5.9604644775390625e-8f);  // 2^-24
}
