// Stochastic shadow maps: how much of a light reaches a point.
// Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. IEEE TVCG 17(8), 2011, sections
// 3.2 and 3.6.
//
// A map holds at each of a texel's samples the depth of the nearest fragment whose random mask has
// the sample (stochastic_masks.glsl). The part of the samples around a point that are not nearer to
// the light than the point is, on average, the part of the light that reaches it.
// Needs prelude.glsl.

// Whether light reaches `depth` at a sample that holds `stored`.
SHEER_FN mask shadow_is_lit(real depth, real stored)
{
    return depth <= stored;
}

// The depth of a flat surface at a sample (x, y) texels from where it is `depth`.
SHEER_FN real shadow_depth_at(real depth, real x, real y, real depth_x, real depth_y)
{
    return depth + x * depth_x + y * depth_y;
}

// A footprint is as wide as `filter` texels and lies over filter + 1 of them: `part` of the first
// is outside, and so the rest of the last inside. Of a row of texels' counts, and of rows.
SHEER_FN real shadow_sum(real first, real between, real last, real part)
{
    return (real(1.0f) - part) * first + between + part * last;
}

// A texel of a wide footprint, one out of each of its cells: along one axis, `xi` in [0, 1) is
// random and `from` the footprint's edge.
SHEER_FN real shadow_random_place(real from, real cell, real xi, real spread)
{
    return from + (cell + xi) * spread;
}

// Corrected by the total: `seen` of the light by counting, `seen_at_end` the same behind
// everything, `through` what truly passes through everything.
SHEER_FN real shadow_corrected(real seen, real seen_at_end, real through)
{
    real one = real(1.0f);
    mask any = seen_at_end < one;
    // No sample was taken away: there is nothing to correct.
    real stopped = select(any, one - seen_at_end, one);
    real scale = select(any, (one - through) / stopped, real(0.0f));
    return one - (one - seen) * scale;
}
