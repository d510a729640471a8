// Alpha correction: colours that are right but for a factor, made to add up to the total alpha.
// Sintorn and Assarsson. Hair Self Shadowing and Transparency Depth Ordering Using Occupancy Maps.
// I3D 2009. Enderton, Sintorn, Shirley and Luebke. Stochastic Transparency. I3D 2010, sections 3.3
// and 3.5.
//
// Total alpha is kept as the transmittance T of each sample, and what is behind is dimmed by it
// sample by sample, since edges of both may coincide. The sums, their weights and 1 - T are
// filtered each for itself; the quotient is taken of a pixel:
//   pixel = alpha_corrected(F(sum), F(weight), F(1 - T)) + F(T backdrop)
// Needs prelude.glsl.

// T of a sample, 1 at first.
SHEER_FN real total_alpha_insert(real transmittance, mask covered, real opacity)
{
    return select(covered, transmittance * (real(1.0f) - opacity), transmittance);
}

// Nothing where there is no weight: a pixel that no fragment has won has no colour to scale.
SHEER_FN real3 alpha_corrected(real3 sum, real weight, real total_alpha)
{
    mask any = weight > real(0.0f);
    real divisor = select(any, weight, real(1.0f));
    real3 mean = real3(sum.x / divisor, sum.y / divisor, sum.z / divisor);
    real part = select(any, total_alpha, real(0.0f));
    return part * mean;
}
