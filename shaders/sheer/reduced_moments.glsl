// Sums of a picture of fewer pixels, read for a pixel of the whole picture.
// Sharpe. Moment Transparency. HPG 2018, section 4.1.
//
// Sums may be mixed as they are, as their measures are then mixed: what is divided by the optical
// depth, or rounded to few bits by formulas that are not linear, may not. A pixel reads the four
// texels around it, by a texture's filter or by this:
//   reduced_mix(reduced_mix(s00, s10, x), reduced_mix(s01, s11, x), y)
//
// That loses what is narrower than a texel, so that what lies behind shines through it. To have it
// back, each pixel adds up two numbers of its own, the optical depth and its first moment. What the
// mixed sums lack of the two is a fragment that no texel has seen: it has that depth and is at that
// place. Where they have too much they are scaled.
// Needs prelude.glsl.

SHEER_FN real reduced_mix(real a, real b, real part)
{
    return a + part * (b - a);
}

struct MissingFragment {
    real keeps;  // of the mixed sums
    real depth;  // optical
    real place;  // in [-1, 1]
};

// `depth`, `first`: the mixed sums of d_i and d_i z_i; the pixel's own.
SHEER_FN MissingFragment missing_fragment(real depth, real first, real own_depth, real own_first)
{
    real more = own_depth - depth;
    real least = real(3.6379788e-12f);  // what sums are exact to
    MissingFragment m;
    m.keeps = select(more < real(0.0f), own_depth / max(depth, least), real(1.0f));
    m.depth = max(more, real(0.0f));
    m.place = min(max((own_first - first) / max(more, least), real(-1.0f)), real(1.0f));
    return m;
}
