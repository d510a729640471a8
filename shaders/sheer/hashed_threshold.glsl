// Thresholds that stay on the surface: a hash of the cell, about a pixel large, that a point of an
// object lies in. Noise is as coarse as in stochastic.glsl with one sample, but still.
// C. Wyman, M. McGuire. Improved Alpha Testing Using Hashed Sampling. TVCG 25(2), 2019: listings 1
// and 2, sections 5 and 6.
//
// Cells' sizes are powers of 2, so that they stay where they are while the surface comes nearer;
// the two around the wanted size are mixed, and the mixture made uniform again.
//
// In an engine: hashed_alpha_threshold(p, dFdx(p), dFdy(p), 1.0), p being the position in object
// space before skinning and instancing; discard where opacity < threshold.
//
// Departures: a cell is no more than 16 times as long along one axis as along another, for faces
// along an axis have no extent across it; derivatives are 1e-8 to 1e8; the mixture of eight corners
// is made uniform after each axis, where the sum of eight has no formula that floats bear.
// Needs prelude.glsl, random.glsl.

SHEER_FN real fraction(real x)
{
    return x - floor(x);
}

// Of |x| to some 1e5, as good as the digits of x allow. GPUs' own sines differ, and the paper's
// hash multiplies that by 10,000.
SHEER_FN real sine(real x)
{
    const real one = real(1.0f);
    real turns = floor(x * real(0.318309886f) + real(0.5f));  // 1 / pi
    // pi as three floats.
    real r = x - turns * real(3.140625f);
    r = r - turns * real(0.0009676535846665502f);
    r = r - turns * real(5.126688136514179e-12f);
    real odd = turns - real(2.0f) * floor(turns * real(0.5f));
    // r - r^3 / 3! + r^5 / 5! - ... to r^21, |r| <= pi / 2.
    real t = r * r;
    real s = one - t * (one / real(420.0f));
    s = one - t * (one / real(342.0f)) * s;
    s = one - t * (one / real(272.0f)) * s;
    s = one - t * (one / real(210.0f)) * s;
    s = one - t * (one / real(156.0f)) * s;
    s = one - t * (one / real(110.0f)) * s;
    s = one - t * (one / real(72.0f)) * s;
    s = one - t * (one / real(42.0f)) * s;
    s = one - t * (one / real(20.0f)) * s;
    s = one - t * (one / real(6.0f)) * s;
    return (one - odd - odd) * r * s;
}

SHEER_FN real paper_hash(real x, real y)
{
    const real tenth = real(1.0f) / real(10.0f);
    return fraction(real(1e4f) * sine(real(17.0f) * x + tenth * y) *
                    (tenth + abs(sine(real(13.0f) * y + x))));
}

// M. Jarzynski, M. Olano. Hash Functions for GPU Rendering. JCGT 9(3), 2020: pcg3d's first number.
SHEER_FN whole pcg_hash(whole x, whole y, whole z)
{
    x = x * whole(1664525u) + whole(1013904223u);
    y = y * whole(1664525u) + whole(1013904223u);
    z = z * whole(1664525u) + whole(1013904223u);
    x = x + y * z;
    y = y + z * x;
    z = z + x * y;
    x = x ^ (x >> 16);
    y = y ^ (y >> 16);
    z = z ^ (z >> 16);
    return x + y * z;
}

// One round and the end of Y. Collet's xxHash32 (2012).
SHEER_FN whole xxhash_round(whole h, whole x)
{
    h = h + x * whole(0xc2b2ae3du);
    return ((h << 17) | (h >> 15)) * whole(0x27d4eb2fu);
}
SHEER_FN whole xxhash(whole x, whole y, whole z)
{
    whole h = whole(0x165667b1u) + whole(12u);
    h = xxhash_round(xxhash_round(xxhash_round(h, x), y), z);
    h = (h ^ (h >> 15)) * whole(0x85ebca77u);
    h = (h ^ (h >> 13)) * whole(0xc2b2ae3du);
    return h ^ (h >> 16);
}

// Of a cell's whole coordinates, in [0, 1). `hash`: 0 the paper's, 1 pcg3d, 2 lowbias32 of each
// coordinate after the other (random.glsl), 3 xxHash32.
SHEER_FN real cell_hash(int hash, real3 cell)
{
    if (hash == 0) return paper_hash(paper_hash(cell.x, cell.y), cell.z);
    // What is farther out than that has no whole coordinates in floats anyway.
    const real most = real(2147483520.0f);
    whole x = to_whole(max(min(cell.x, most), real(0.0f) - most));
    whole y = to_whole(max(min(cell.y, most), real(0.0f) - most));
    whole z = to_whole(max(min(cell.z, most), real(0.0f) - most));
    whole h = whole(0u);
    if (hash == 1) h = pcg_hash(x, y, z);
    if (hash == 2) h = hash_whole(x + hash_whole(y + hash_whole(z)));
    if (hash == 3) h = xxhash(x, y, z);
    return to_real(h >> 8) * real(5.9604644775390625e-8f);  // 2^-24
}

// The cells that a point lies in, of two sizes along each axis.
struct HashCells {
    real3 coarse, fine;  // their coordinates
    real3 toward;        // how near the wanted size is to the fine one, in octaves, of [0, 1)
    real part;           // the fine cell's in the mixture
};

// log2 of a number in [1, 2): 2 / ln 2 (t + t^3 / 3 + ...), t = (x - 1) / (x + 1) <= 1 / 3. To
// 2e-8, and in [0, 1).
SHEER_FN real log2_of_mantissa(real x)
{
    const real one = real(1.0f);
    real t = (x - one) / (x + one);
    real u = t * t;
    real s = one / real(11.0f) + u * (one / real(13.0f));
    s = one / real(9.0f) + u * s;
    s = one / real(7.0f) + u * s;
    s = one / real(5.0f) + u * s;
    s = one / real(3.0f) + u * s;
    return min(real(2.885390081777927f) * t * (one + u * s), real(0.99999994f));
}

struct AxisCells {
    real coarse, fine, toward;
};

SHEER_FN AxisCells axis_cells(real place, real scale)
{
    AxisCells cells;
    real low = octave(scale);
    real high = select(scale > low, low + low, low);
    cells.coarse = floor(low * place);
    cells.fine = floor(high * place);
    cells.toward = log2_of_mantissa(scale / low);
    return cells;
}

SHEER_FN HashCells join_axes(AxisCells x, AxisCells y, AxisCells z, real part)
{
    HashCells cells;
    cells.coarse = real3(x.coarse, y.coarse, z.coarse);
    cells.fine = real3(x.fine, y.fine, z.fine);
    cells.toward = real3(x.toward, y.toward, z.toward);
    cells.part = part;
    return cells;
}

SHEER_FN real within_derivatives(real d)
{
    return min(max(d, real(1e-8f)), real(1e8f));
}
SHEER_FN real square_of_length(real3 v)
{
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

// Cells a pixel, 1 / hash_scale of them a side: what the position changes by in one.
SHEER_FN real isotropic_scale(real3 dx, real3 dy, real hash_scale)
{
    real most = sqrt(max(square_of_length(dx), square_of_length(dy)));
    return real(1.0f) / (hash_scale * within_derivatives(most));
}
SHEER_FN real3 anisotropic_scales(real3 dx, real3 dy, real hash_scale)
{
    real x = max(abs(dx.x), abs(dy.x));
    real y = max(abs(dx.y), abs(dy.y));
    real z = max(abs(dx.z), abs(dy.z));
    real most = within_derivatives(max(max(x, y), z));
    real least = most * real(0.0625f);
    x = min(max(x, least), most);
    y = min(max(y, least), most);
    z = min(max(z, least), most);
    const real keeps_mean_size = real(0.707f);
    return real3(keeps_mean_size / (hash_scale * x), keeps_mean_size / (hash_scale * y),
                 keeps_mean_size / (hash_scale * z));
}

// Cells of one size (listing 1).
SHEER_FN HashCells isotropic_cells(real3 place, real scale)
{
    AxisCells x = axis_cells(place.x, scale);
    return join_axes(x, axis_cells(place.y, scale), axis_cells(place.z, scale), x.toward);
}

// Of one for each axis (listing 2).
SHEER_FN HashCells anisotropic_cells(real3 place, real3 scales)
{
    AxisCells x = axis_cells(place.x, scales.x);
    AxisCells y = axis_cells(place.y, scales.y);
    AxisCells z = axis_cells(place.z, scales.z);
    const real one = real(1.0f);
    real from = sqrt(square_of_length(real3(x.toward, y.toward, z.toward)));
    real to = sqrt(square_of_length(real3(one - x.toward, one - y.toward, one - z.toward)));
    return join_axes(x, y, z, from / (from + to));
}

// Without powers of 2: what section 5.2 shows to swim.
SHEER_FN HashCells continuous_cells(real3 place, real3 scales)
{
    HashCells cells;
    const real none = real(0.0f);
    cells.coarse =
        real3(floor(scales.x * place.x), floor(scales.y * place.y), floor(scales.z * place.z));
    cells.fine = cells.coarse;
    cells.toward = real3(none, none, none);
    cells.part = none;
    return cells;
}

// Equation 2: the chance that (1 - t) U0 + t U1 is below x, of two uniform numbers.
SHEER_FN real mix_of_two_cdf(real x, real t)
{
    const real one = real(1.0f), tiny = real(1e-12f);
    real a = min(t, one - t);
    real b = one - a;
    real corner = max((a + a) * b, tiny);
    real low = x * x / corner;
    real middle = (x - a * real(0.5f)) / b;
    real high = one - (one - x) * (one - x) / corner;
    return select(x < a, low, select(x < b || a < tiny, middle, high));
}

SHEER_FN real mix_of_two(real u0, real u1, real t, bool uniform_mix)
{
    real x = (real(1.0f) - t) * u0 + t * u1;
    return uniform_mix ? mix_of_two_cdf(x, t) : x;
}

SHEER_FN real as_threshold(real x)
{
    return min(max(x, real(1e-6f)), real(1.0f));
}

// In [1e-6, 1]: what has no opacity never passes, what is opaque always does.
SHEER_FN real threshold_of_cells(HashCells cells, int hash, bool uniform_mix)
{
    return as_threshold(mix_of_two(cell_hash(hash, cells.coarse), cell_hash(hash, cells.fine),
                                   cells.part, uniform_mix));
}

// Corners that differ along x, of cells that are coarse or fine along y and z.
SHEER_FN real mix_along_x(HashCells cells, real y, real z, int hash, bool uniform_mix)
{
    return mix_of_two(cell_hash(hash, real3(cells.coarse.x, y, z)),
                      cell_hash(hash, real3(cells.fine.x, y, z)), cells.toward.x, uniform_mix);
}
SHEER_FN real threshold_of_corners(HashCells cells, int hash, bool uniform_mix)
{
    real3 c = cells.coarse;
    real3 f = cells.fine;
    real near =
        mix_of_two(mix_along_x(cells, c.y, c.z, hash, uniform_mix),
                   mix_along_x(cells, f.y, c.z, hash, uniform_mix), cells.toward.y, uniform_mix);
    real far =
        mix_of_two(mix_along_x(cells, c.y, f.z, hash, uniform_mix),
                   mix_along_x(cells, f.y, f.z, hash, uniform_mix), cells.toward.y, uniform_mix);
    return as_threshold(mix_of_two(near, far, cells.toward.z, uniform_mix));
}

// Another pattern of the same cells: `number` of them lie far from one another.
SHEER_FN HashCells other_cells(HashCells cells, whole number)
{
    real n = to_real(number);
    real3 offset = real3(n * real(1571.0f), n * real(2083.0f), n * real(3181.0f));
    cells.coarse = cells.coarse + offset;
    cells.fine = cells.fine + offset;
    return cells;
}

// All of it, with what serves best: cells of a size for each axis, and an integer hash, of which
// every processor has the same bits. `hash_scale`: the cells' size in pixels.
SHEER_FN real hashed_alpha_threshold(real3 place, real3 dx, real3 dy, real hash_scale)
{
    HashCells cells = anisotropic_cells(place, anisotropic_scales(dx, dy, hash_scale));
    return threshold_of_cells(cells, 1, true);
}
