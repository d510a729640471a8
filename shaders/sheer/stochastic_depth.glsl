// Depth-based stochastic transparency.
// Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. I3D 2010, sections 3.4 and 3.5.
//
// Two passes over the fragments in any order. The first finds at each sample the depth that basic
// stochastic transparency would show. The second adds up all fragments that are not behind it, each
// with its own opacity, and the total alpha (alpha_correction.glsl). U, the sums' filtered mean
// over the dimmed background, is unbiased; D, corrected by total alpha, is consistent and never
// brighter than the fragments are. Exact for one layer.
//
// Needs prelude.glsl.

struct StochasticDepthStore {
    real depth;   // of the nearest fragment that took the sample; beyond any where none did
    whole id;     // below 2^31; breaks ties: the smaller is in front
    real3 color;  // sum of the premultiplied colours
    real weight;  // sum of the opacities
    real transmittance;
};

SHEER_FN StochasticDepthStore stochastic_depth_clear(real beyond_any)
{
    StochasticDepthStore s;
    s.depth = beyond_any;
    s.id = whole(0x7fffffffu);
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    s.weight = real(0.0f);
    s.transmittance = real(1.0f);
    return s;
}

// First pass. `taken`: whether the fragment's mask has this sample.
SHEER_FN StochasticDepthStore stochastic_depth_insert(StochasticDepthStore s, mask taken,
                                                      real depth, whole id)
{
    mask stays = !(taken && (depth < s.depth || (depth == s.depth && id < s.id)));
    s.depth = select(stays, s.depth, depth);
    s.id = select(stays, s.id, id);
    return s;
}

// Second pass, beside total_alpha_insert, which goes once over the fragments. The fragment that the
// first pass kept is not behind itself: depth and id must be the same bits in both.
SHEER_FN StochasticDepthStore stochastic_depth_add(StochasticDepthStore s, mask covered, real depth,
                                                   whole id, real3 straight_color, real opacity)
{
    mask behind = s.depth < depth || (depth == s.depth && s.id < id);
    real alpha = select(covered && !behind, opacity, real(0.0f));
    s.color = s.color + alpha * straight_color;
    s.weight = s.weight + alpha;
    return s;
}

// Of two stores that have gone through the same passes; after the first pass each part goes on with
// what was merged.
SHEER_FN StochasticDepthStore stochastic_depth_merge(StochasticDepthStore a, StochasticDepthStore b)
{
    a = stochastic_depth_insert(a, b.depth == b.depth, b.depth, b.id);
    a.color = a.color + b.color;
    a.weight = a.weight + b.weight;
    a.transmittance = a.transmittance * b.transmittance;
    return a;
}
