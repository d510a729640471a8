// A sample's fragments for the methods that approximate transmittance. The page says what is added
// up (kSums numbers), what is made of the sums, and what a fragment reads of that:
//   void add_sums(float place, float depth)    to `sums`, by add_exactly
//   void prepare()                             from `sums`
//   float seen_from(float place)
//   vec4 kept_numbers()
// Needs stochastic.glsl, exponential.glsl, transmittance.glsl, fragment_list.glsl.

float beyond_any = uintBitsToFloat(0x7f800000u);  // infinity

// As the stores have them: of doubles on a grid, no sum of which is rounded.
double sums[33];

// 1.5 2^52 units of 2^-38 and of 2^-48.
const double kDepthMagic = 24576.0lf;
const double kWeightMagic = 24.0lf;

double on_grid(double x, double magic)
{
    return (x + magic) - magic;
}
void add_exactly(int k, double x)
{
    sums[k] += on_grid(x, kDepthMagic);
}
double depth_divisor()
{
    return max(sums[0], 1.0lf / 274877906944.0lf);  // 2^-38
}

void add_sums(float place, float depth);
void prepare();
float seen_from(float place);
vec4 kept_numbers();

StochasticStore fragment_here(Fragment f)
{
    return StochasticStore(depth_here(f), f.primitive, color_of(f));
}

// `moment_passes` over the sums, and one over the colours.
void run_passes(int moment_passes)
{
    StochasticStore nearest = stochastic_clear(beyond_any);
    for (uint i = list_begin(); i < list_end(); ++i) {
        Fragment f = fragments[i];
        nearest = stochastic_insert(nearest, covers(f) && f.opacity >= 1, fragment_here(f));
    }
    float through = 1;
    // 2^-48 of the power of two above the tile's brightest colour.
    double color_magic = kWeightMagic * double(tile.brightest);
    double color[4] = double[](0.0lf, 0.0lf, 0.0lf, 0.0lf);
    bool any = list_begin() < list_end();
    for (int pass = 1; any && pass <= moment_passes + 1; ++pass) {
        for (int k = 0; k < 33; ++k) sums[k] = 0;
        for (uint i = list_begin(); i < list_end(); ++i) {
            Fragment f = fragments[i];
            if (!covers(f) || f.opacity >= 1 || !stochastic_nearer(nearest, fragment_here(f))) {
                continue;
            }
            float place = warped_depth(tile.orthographic != 0, clamp_depth(f, f.center), tile.from,
                                       tile.scale);
            if (pass == 1) {
                add_sums(place, optical_depth(f.opacity));
            } else if (pass <= moment_passes) {
                add_sums(place, optical_depth(f.opacity * seen_from(place)));
            } else {
                float w = visible_alpha(seen_from(place), f.opacity);
                vec3 part = w * color_of(f);
                color[0] += on_grid(part.x, color_magic);
                color[1] += on_grid(part.y, color_magic);
                color[2] += on_grid(part.z, color_magic);
                color[3] += on_grid(w, kWeightMagic);
            }
        }
        if (pass > moment_passes) continue;
        if (pass == 1) through = exp_of(-float(sums[0]));
        prepare();
    }
    vec4 numbers = any ? kept_numbers() : vec4(0);
    keep(numbers.xyz, numbers.w, through);
    bool hidden = nearest.depth < beyond_any;
    vec3 behind = hidden ? nearest.color : backdrop();
    vec3 sum = vec3(float(color[0]), float(color[1]), float(color[2]));
    put(visible_resolve(sum, float(color[3]), through, behind), hidden ? 0.0 : through);
}
