// Stratified stochastic transparency: which samples a fragment takes.
// Laine and Karras. Stratified Sampling for Stochastic Transparency. EGSR 2011.
//
// A fragment takes a sample where its opacity exceeds a reference value. The values come from one
// sequence in which every aligned span of 2^k numbers has one value in each 2^-k of [0, 1); it is
// laid along a curve through the pixels, and a surface takes one span of it in each pixel, however
// many fragments it consists of. The samples, which hold what stochastic.glsl says, take their
// numbers by the depths that they already keep, so that each surface that was drawn before gives up
// its share. Unbiased for every order of the fragments, which shows in the noise alone.
//
// Systematic numbers, which are not the paper's, spread the same way over any span.
//
// For each fragment: its open samples are those that it covers and where it is stochastic_nearer;
// with none, nothing happens. stratified_begin says which number the first of them gets; they count
// on from there in the order of stratified_before, and take what stratified_takes says, or
// systematic_takes.
// Needs prelude.glsl, bits.glsl, random.glsl.

SHEER_FN whole reversed_bits(whole x)
{
    x = ((x >> 1) & whole(0x55555555u)) | ((x & whole(0x55555555u)) << 1);
    x = ((x >> 2) & whole(0x33333333u)) | ((x & whole(0x33333333u)) << 2);
    x = ((x >> 4) & whole(0x0f0f0f0fu)) | ((x & whole(0x0f0f0f0fu)) << 4);
    x = ((x >> 8) & whole(0x00ff00ffu)) | ((x & whole(0x00ff00ffu)) << 8);
    return (x >> 16) | (x << 16);
}

// Where pixel (x, y) lies on Hilbert's curve through 2^14 x 2^14 pixels, whose first steps are to
// the right from (0, 0): the same for pictures of all sizes.
SHEER_FN whole hilbert_index(whole x, whole y)
{
    whole index = whole(0u);
    for (int bit = 13; bit >= 0; --bit) {
        whole right = (x >> bit) & whole(1u);
        whole below = (y >> bit) & whole(1u);
        index = (index << 2) + ((right + right + right) ^ below);
        // The curve in the upper quarters is turned: x and y exchanged, in the right one reversed.
        whole turned = below - whole(1u);
        whole flipped = turned & (whole(0u) - right);
        whole exchanged = ((x ^ y) & turned);
        x = (x ^ exchanged) ^ flipped;
        y = (y ^ exchanged) ^ flipped;
    }
    return index;
}

// The same of Morton's curve, x in the lower bits. Its squares are all alike inside, which
// shows as stripes.
SHEER_FN whole morton_index(whole x, whole y)
{
    whole index = whole(0u);
    for (int bit = 13; bit >= 0; --bit) {
        whole right = (x >> bit) & whole(1u);
        whole below = (y >> bit) & whole(1u);
        index = (index << 2) + right + below + below;
    }
    return index;
}

// Every bit is flipped by what the bits below it say. The paper's constants, figure 4.
SHEER_FN whole scrambled(whole x)
{
    x = x ^ (x * whole(0x6c50b47cu));
    x = x ^ (x * whole(0xb82f1e52u));
    x = x ^ (x * whole(0xc7afe638u));
    x = x ^ (x * whole(0x8d22f6e6u));
    return x;
}

// The same with less structure left over. Vegdahl. Building a Better LK Hash. 2021.
SHEER_FN whole scrambled_by(whole x, whole seed)
{
    x = x ^ (x * whole(0x3d20adeau));
    x = x + seed;
    x = x * ((seed >> 16) | whole(1u));
    x = x ^ (x * whole(0x05526c56u));
    x = x ^ (x * whole(0x53a22864u));
    return x;
}

// The second dimension of Sobol's sequence (The Distribution of Points in a Cube. 1967): every bit
// is flipped by the parity of some of those below it. The matrix is Pascal's triangle modulo 2.
SHEER_FN whole sobol_scrambled(whole x)
{
    x = x ^ ((x & whole(0x55555555u)) << 1);
    x = x ^ ((x & whole(0x33333333u)) << 2);
    x = x ^ ((x & whole(0x0f0f0f0fu)) << 4);
    x = x ^ ((x & whole(0x00ff00ffu)) << 8);
    return x ^ (x << 16);
}

// The reference value, 32 bits of [0, 1), of a number: `reversed` is number + pixel's index times S
// with its bits reversed. `sequence`: 0, the paper's; 1, Vegdahl's; 2, Sobol's, in which surfaces
// know of one another, for comparison; 3, independent numbers, which are not stratified.
SHEER_FN whole reference_bits(int sequence, whole reversed, whole surface)
{
    if (sequence == 1) return scrambled_by(reversed, hash_whole(surface));
    if (sequence == 2) return sobol_scrambled(reversed + surface);
    if (sequence == 3) return identity_seed(reversed, surface);
    return scrambled(reversed + surface);
}

// Strictly: an opacity of 0 takes nothing, and 1 is above all reference values.
SHEER_FN mask stratified_takes(real opacity, whole bits)
{
    return opacity > to_real(bits >> 8) * real(5.9604644775390625e-8f);  // 2^-24
}

// Systematic numbers instead of such a sequence: number n takes its sample where a multiple of 1
// lies above start + n opacity and not above start + (n + 1) opacity. Of any consecutive numbers
// floor or ceil of opacity times how many they are take theirs, not only of 2^k of them; a random
// start makes each as likely as the opacity says. Madow and Madow. On the Theory of Systematic
// Sampling. 1944. `start`, in 2^-24: the reference value of the pixel, which has one number here.
SHEER_FN mask systematic_takes(real opacity, whole start, whole number)
{
    real scaled = opacity * real(16777216.0f);  // 2^24
    whole least = to_whole(scaled);
    // Rounded up, as stratified_takes does.
    whole step = least + zero_unless(to_real(least) < scaled, whole(1u));
    whole before = (start + number * step) & whole(0xffffffu);
    return !(before + step < whole(0x1000000u));
}

// What a pixel knows of the surface that is being drawn.
struct StratifiedSurface {
    whole low, high;  // samples 0 to 31 and 32 to 63 that it has had
    whole id;         // of its reference values; starts at the frame's key
};

SHEER_FN StratifiedSurface stratified_clear(whole key)
{
    StratifiedSurface surface;
    surface.low = whole(0u);
    surface.high = whole(0u);
    surface.id = key;
    return surface;
}

// A fragment's open samples arrive, at least one; if the surface has had one of them already, or
// always where surfaces are not tracked, a new surface begins. Returns the number of the first.
SHEER_FN whole stratified_begin(SHEER_INOUT(StratifiedSurface) surface, whole low, whole high,
                                bool tracked)
{
    whole again = (surface.low & low) | (surface.high & high);
    if (!tracked) again = low | high;
    mask goes_on = again == whole(0u);
    surface.low = zero_unless(goes_on, surface.low);
    surface.high = zero_unless(goes_on, surface.high);
    surface.id = select(goes_on, surface.id, surface.id + whole(1u));
    whole number = bit_count(surface.low) + bit_count(surface.high);
    surface.low = surface.low | low;
    surface.high = surface.high | high;
    return number;
}

// Whether sample i, which keeps depth a, gets its number before sample j, which keeps depth b.
SHEER_FN mask stratified_before(real a, whole i, real b, whole j)
{
    return a < b || (a == b && i < j);
}
