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

struct StochasticDepth {
    real depth;  // of the nearest fragment that took the sample; beyond any where none did
    whole id;    // below 2^31; breaks ties: the smaller is in front
};

SHEER_FN StochasticDepth stochastic_depth_clear(real beyond_any)
{
    StochasticDepth s;
    s.depth = beyond_any;
    s.id = whole(0x7fffffffu);
    return s;
}

SHEER_FN mask stochastic_depth_before(StochasticDepth a, StochasticDepth b)
{
    return a.depth < b.depth || (a.depth == b.depth && a.id < b.id);
}

// First pass. `taken`: whether the fragment's mask has this sample.
SHEER_FN StochasticDepth stochastic_depth_insert(StochasticDepth s, mask taken, StochasticDepth f)
{
    mask stays = !(taken && stochastic_depth_before(f, s));
    s.depth = select(stays, s.depth, f.depth);
    s.id = select(stays, s.id, f.id);
    return s;
}

// Second pass: whether a fragment that covers the sample is added up. That which the first pass
// kept is not behind itself: depth and id must be the same bits in both.
SHEER_FN mask stochastic_depth_shows(StochasticDepth s, mask covered, StochasticDepth f)
{
    return covered && !stochastic_depth_before(s, f);
}

// Of a sample, and alpha is the opacity or 0. Or of a pixel, where the filter is the mean of each
// pixel's own samples: alpha is then opacity times the number of samples at which the fragment is
// added up, and the sums are as many times larger as the pixel has samples.
struct StochasticDepthSum {
    real3 color;  // of the premultiplied colours
    real weight;  // of the opacities
};

SHEER_FN StochasticDepthSum stochastic_depth_no_sum()
{
    StochasticDepthSum sum;
    sum.color = real3(real(0.0f), real(0.0f), real(0.0f));
    sum.weight = real(0.0f);
    return sum;
}

SHEER_FN StochasticDepthSum stochastic_depth_add(StochasticDepthSum sum, real alpha,
                                                 real3 straight_color)
{
    sum.color = sum.color + alpha * straight_color;
    sum.weight = sum.weight + alpha;
    return sum;
}
