// Compositing of sorted fragments, the sum at the heart of an A-buffer.
// Carpenter. The A-buffer, an Antialiased Hidden Surface Method. SIGGRAPH 1984.
//
// C = sum of T_i a_i c_i, T_i = product of (1 - a_j) over the j in front of i. The fragments come
// near to far; sorting them is the includer's.
// Needs prelude.glsl, over.glsl.

struct ExactSum {
    real3 color;  // premultiplied
    real transmittance;
};

SHEER_FN ExactSum exact_clear()
{
    ExactSum s;
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    s.transmittance = real(1.0f);
    return s;
}

SHEER_FN ExactSum exact_add(ExactSum s, mask covered, real3 straight_color, real opacity)
{
    real alpha = select(covered, opacity, real(0.0f));
    s.color = s.color + (s.transmittance * alpha) * straight_color;
    s.transmittance = s.transmittance * (real(1.0f) - alpha);
    return s;
}

SHEER_FN real3 exact_resolve(ExactSum s, real3 backdrop)
{
    return over(s.color, s.transmittance, backdrop);
}

// The same where a fragment lets each channel through by itself: coloured glass.

struct ExactColoredSum {
    real3 color;  // premultiplied
    real3 transmittance;
};

SHEER_FN ExactColoredSum exact_colored_clear()
{
    ExactColoredSum s;
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    s.transmittance = real3(real(1.0f), real(1.0f), real(1.0f));
    return s;
}

// `through`: the parts of red, green and blue that pass.
SHEER_FN ExactColoredSum exact_colored_add(ExactColoredSum s, mask covered, real3 straight_color,
                                           real opacity, real3 through)
{
    real alpha = select(covered, opacity, real(0.0f));
    s.color = s.color + alpha * (s.transmittance * straight_color);
    s.transmittance = select(covered, s.transmittance * through, s.transmittance);
    return s;
}

SHEER_FN real3 exact_colored_resolve(ExactColoredSum s, real3 backdrop)
{
    return s.color + s.transmittance * backdrop;
}

// The mean over the channels.
SHEER_FN real exact_colored_transmittance(ExactColoredSum s)
{
    return (s.transmittance.x + s.transmittance.y + s.transmittance.z) * real(0.33333334f);
}
