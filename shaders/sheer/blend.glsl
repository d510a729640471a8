// Alpha blending in the order of arrival.
// Porter and Duff. Compositing Digital Images. SIGGRAPH 1984.
//
// Keeps the premultiplied colour and the transmittance of what has arrived so far; a fragment goes
// over it. Exact for one fragment, and for any number that arrive from far to near.
// Needs prelude.glsl, over.glsl.

struct BlendStore {
    real3 color;  // premultiplied
    real transmittance;
};

SHEER_FN BlendStore blend_clear()
{
    BlendStore s;
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    s.transmittance = real(1.0f);
    return s;
}

SHEER_FN BlendStore blend_insert(BlendStore s, mask covered, real3 straight_color, real opacity)
{
    real alpha = select(covered, opacity, real(0.0f));
    real rest = real(1.0f) - alpha;
    s.color = over(alpha * straight_color, rest, s.color);
    s.transmittance = rest * s.transmittance;
    return s;
}

// All of `later` arrived after all of `s`.
SHEER_FN BlendStore blend_merge(BlendStore s, BlendStore later)
{
    s.color = over(later.color, later.transmittance, s.color);
    s.transmittance = later.transmittance * s.transmittance;
    return s;
}

SHEER_FN real3 blend_resolve(BlendStore s, real3 backdrop)
{
    return over(s.color, s.transmittance, backdrop);
}
