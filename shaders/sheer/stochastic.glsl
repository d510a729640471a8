// Stochastic transparency, basic.
// Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. I3D 2010, sections 3.1 and 4.
//
// Each fragment takes a random part of its samples, in proportion to its opacity, and at each of
// them the nearest fragment stays: unbiased, with an error that falls as samples grow.
// Depth, id and colour for each sample.
// Which samples a fragment takes is for stochastic_masks.glsl to say.
// Needs prelude.glsl.

struct StochasticStore {
    real depth;   // of the nearest fragment; beyond any where there is none
    whole id;     // below 2^31; breaks ties: the smaller is in front
    real3 color;  // straight
};

SHEER_FN StochasticStore stochastic_clear(real beyond_any)
{
    StochasticStore s;
    s.depth = beyond_any;
    s.id = whole(0x7fffffffu);
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    return s;
}

SHEER_FN mask stochastic_nearer(StochasticStore s, StochasticStore f)
{
    return f.depth < s.depth || (f.depth == s.depth && f.id < s.id);
}

// Whether the fragment takes the sample; `taken`: whether its mask does.
SHEER_FN mask stochastic_wins(StochasticStore s, mask taken, StochasticStore f)
{
    return taken && stochastic_nearer(s, f);
}

// The nearer of the two.
SHEER_FN StochasticStore stochastic_insert(StochasticStore s, mask taken, StochasticStore f)
{
    // Not "wins": where s lies in memory, what is kept can then be an instruction's own operand.
    mask stays = !stochastic_wins(s, taken, f);
    s.depth = select(stays, s.depth, f.depth);
    s.id = select(stays, s.id, f.id);
    s.color = select(stays, s.color, f.color);
    return s;
}

SHEER_FN real3 stochastic_resolve(StochasticStore s, real beyond_any, real3 backdrop)
{
    return select(s.depth < beyond_any, s.color, backdrop);
}

SHEER_FN real stochastic_transmittance(StochasticStore s, real beyond_any)
{
    return select(s.depth < beyond_any, real(0.0f), real(1.0f));
}
