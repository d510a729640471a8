// Over: what is in front, over what is behind.
// Porter and Duff. Compositing Digital Images. SIGGRAPH 1984.
//
// Needs prelude.glsl.

// `front` is premultiplied; `transmittance` is the part of the light that passes through it.
SHEER_FN real3 over(real3 front, real transmittance, real3 behind)
{
    return front + transmittance * behind;
}

// Alpha A behind transmittance T becomes 1 - T (1 - A), written so that T = 1 leaves A as it is,
// bit for bit.
SHEER_FN real over_alpha(real transmittance, real behind)
{
    return behind + (real(1.0f) - transmittance) * (real(1.0f) - behind);
}
