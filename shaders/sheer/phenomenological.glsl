// Phenomenological transparency.
// McGuire and Mara. Phenomenological Transparency. TVCG 23(5), 2017.
//
// As weighted blended transparency (wboit.glsl), with a weight of its own, and what is behind is
// seen through each channel by itself, exactly:
//   C = sum(w a c) / sum(w a) (1 - mean T) + T B,   T = product of what each lets through.
// Exact for one fragment, coloured or not, and for fragments of one colour. Seven sums and
// products.
//
// B may be blurred with the variance D^2 and read beside its place; both are sums over fragments.
// All distances are along the axis of view, in metres, and positive.
// Needs prelude.glsl.

// `d`: distance as a depth buffer has it, in [0, 1].
SHEER_FN real phenomenological_weight(real d, real opacity)
{
    real x = real(1.0f) - real(0.99f) * d;
    real by_depth = min(max(x * x * x * real(1e4f), real(1e-3f)), real(1.0f));
    return min(max(opacity * by_depth, real(1e-3f)), real(1.5e2f));
}

// What a fragment adds to D^2. z is its distance from the eye, `behind` how much farther what is
// behind is; `collimation` is 1 of what does not diffuse. D is 1 for 200 pixels of the paper's.
SHEER_FN real phenomenological_diffusion(real opacity, real collimation, real z, real behind)
{
    real k0 = real(8.0f);
    real k1 = real(0.1f);
    real d = k0 * opacity * (real(1.0f) - collimation) * (real(1.0f) - k1 / (k1 + behind)) / z;
    return d * d;
}

// Along what a ray that enters a surface goes on: x and y for each metre of z, more than the ray
// itself has, which is (x, y, 1). `normal`: towards the eye, of length 1; `eta`: of refraction, 1
// at least. To be seen is what is where that ray meets the distance of what is behind.
//
// Snell's law, times eta: t = i - k n, k = sqrt(eta^2 - 1 + c^2) - c, c = -i n. Written so that an
// eta of 1 turns nothing, to the bit.
SHEER_FN real3 phenomenological_refraction(real3 ray, real3 normal, real eta)
{
    real square = ray.x * ray.x + ray.y * ray.y + real(1.0f);
    real c = real(0.0f) - (ray.x * normal.x + ray.y * normal.y + normal.z);
    real more = square * (eta * eta - real(1.0f));
    c = max(c, real(1e-6f));  // the surface is not seen from behind
    real k = more / (sqrt(more + c * c) + c);
    real forward = max(real(1.0f) - k * normal.z, real(1e-3f));
    return real3(k * (ray.x * normal.z - normal.x) / forward,
                 k * (ray.y * normal.z - normal.y) / forward, real(0.0f));
}

struct PhenomenologicalStore {
    real3 color;          // sum of w a c
    real weight;          // sum of w a
    real3 transmittance;  // product, of each channel
};

SHEER_FN PhenomenologicalStore phenomenological_clear()
{
    PhenomenologicalStore s;
    s.color = real3(real(0.0f), real(0.0f), real(0.0f));
    s.weight = real(0.0f);
    s.transmittance = real3(real(1.0f), real(1.0f), real(1.0f));
    return s;
}

// `through`: the parts of red, green and blue that pass, of which 1 - opacity is the mean.
SHEER_FN PhenomenologicalStore phenomenological_insert(PhenomenologicalStore s, mask covered,
                                                       real3 straight_color, real opacity,
                                                       real3 through, real weight)
{
    real amount = select(covered, weight * opacity, real(0.0f));
    s.color = s.color + amount * straight_color;
    s.weight = s.weight + amount;
    s.transmittance = select(covered, s.transmittance * through, s.transmittance);
    return s;
}

SHEER_FN PhenomenologicalStore phenomenological_merge(PhenomenologicalStore a,
                                                      PhenomenologicalStore b)
{
    a.color = a.color + b.color;
    a.weight = a.weight + b.weight;
    a.transmittance = a.transmittance * b.transmittance;
    return a;
}

// The mean over the channels.
SHEER_FN real phenomenological_transmittance(PhenomenologicalStore s)
{
    return (s.transmittance.x + s.transmittance.y + s.transmittance.z) * real(0.33333334f);
}

// What is added is as much as is taken away, on the mean of the channels: each channel's own part
// would give light of the complementary colour to what coloured glass reflects.
SHEER_FN real3 phenomenological_resolve(PhenomenologicalStore s, real3 backdrop)
{
    real divisor = select(s.weight > real(0.0f), s.weight, real(1.0f));
    real part = (real(1.0f) - phenomenological_transmittance(s)) / divisor;
    return part * s.color + s.transmittance * backdrop;
}
