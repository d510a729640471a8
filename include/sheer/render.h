// From a scene and a view to a picture.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sheer/image.h>
#include <sheer/scene.h>

namespace sheer {

enum class SamplePositions {
    standard,  // the multisample positions of Direct3D and Vulkan up to 16; Hammersley points above
    center,    // every sample at the pixel's centre
};

enum class Filter {
    box,       // mean of the pixel's samples
    gaussian,  // sigma 0.5 pixel, over the 3x3 pixels around, 0 from 1.5 pixels on
};

// How the smaller levels of a texture are made whose alpha is opacity.
enum class AlphaMips {
    premultiplied,  // means of colour times alpha, so that what is absent has no colour
    straight,       // means of colours as they are: halos of what artists left in absent texels
    coverage,       // premultiplied; then alpha is scaled so that of each level as large a part
                    // passes an alpha test as of the image. I. Castaño 2010
    thresholds,     // premultiplied; MASK surfaces are tested at a cutoff of each level's own, of
                    // which the same is so
};

// How MASK surfaces are rasterised. The others always are where they cover samples.
enum class Conservative {
    off,      // where they cover samples
    touched,  // a triangle covers all samples of each pixel that it touches
    area,     // the same, and its opacity there is multiplied by the part of the pixel that it has
};

// Where surfaces are shaded whose opacities a texture has. The others always are by fragments.
enum class ShadeAt {
    fragment,  // once for all samples of a pixel that a triangle covers, at their centroid
    sample,    // at each of these for itself, with textures as sharp as samples are dense
};

enum class ShadowKind {
    none,        // light goes through everything
    stochastic,  // maps of random samples: Enderton et al., Stochastic Transparency, 3.2 and 3.6
    exact,       // a ray to each light: slow, to judge maps by
    moment,      // maps of four moments of optical depth: Sharpe, Moment Transparency, for a light
};

enum class ShadowMasks {
    naive,       // every sample for itself
    stratified,  // as many samples for a fragment as its opacity says
    tracked,     // over the pieces and layers of surfaces and the texels around, too: Laine and
                 // Karras, Stratified Sampling for Stochastic Transparency
    systematic,  // the same with evenly spaced numbers
};

enum class Footprint {
    fixed,   // all texels around the point
    random,  // as many, each at random out of a place kShadowSpread times as wide
};

inline constexpr int kShadowSpread = 4;

// The sun, directional and spot lights cast shadows, each from a map of its own; point lights and
// the sky cast none. docs/numerics.md, "Shadows", has the formulas.
struct Shadows {
    ShadowKind kind = ShadowKind::none;
    // Of maps.
    int size = 1024;   // texels across, 16 to 8192
    int samples = 16;  // of a texel: 1, 2, 4, 8, 16, 32 or 64
    int filter = 1;    // texels across what is averaged around a point, 1 to 8
    // Of stochastic shadows alone.
    ShadowMasks masks = ShadowMasks::stratified;
    bool correction = false;  // by the exact total: less noise, but biased
    bool colored = false;     // coloured glass casts its colour, from three maps; else grey
    Footprint footprint = Footprint::fixed;
    // Of moments alone: from the least to the most that may lie before a point, in [0, 1]. Above 0
    // surfaces shadow themselves.
    float overestimation = 0;
};

// Where the rays of ambient occlusion go.
enum class RaySamples {
    hashed,  // by the cell of the surface that a point is in, about a pixel large: noise stays on
             // it
    random,  // anew at every point and in every frame
};

// The form of such cells: of one size, or of another along each axis, finer on surfaces seen at an
// angle. C. Wyman and M. McGuire, Improved Alpha Testing Using Hashed Sampling, listings 1 and 2.
enum class RayCells { isotropic, anisotropic };

// How much of the sky each point sees, by rays (section 9 there). docs/shadows.md says what they
// meet; the sun and lights have shadows instead.
struct AmbientOcclusion {
    int rays = 0;      // from each point that is shaded, 1 to 64; 0: all of the sky is seen
    float radius = 0;  // metres, to 1,000,000: what is farther hides nothing; 0: however far
    RaySamples samples = RaySamples::hashed;
    RayCells cells = RayCells::anisotropic;
};

// Shades at full rate within a circle alone: beyond it once for squares of 2 x 2 pixels, and of
// 4 x 4 beyond twice its radius, with textures' levels, opacities and hashed thresholds to match.
// All in pixels from the picture's top left corner, X and Y between -1,000,000 and 1,000,000, the
// radius from 0 on.
struct Foveation {
    float x, y, radius;
};

// What is seen and how it is sampled.
struct View {
    int width = 1024;  // pixels, 1 to kMaxImageSize
    int height = 768;
    int samples = 8;  // per pixel: 1, 2, 4, 8, 16, 32 or 64
    SamplePositions positions = SamplePositions::standard;
    Filter filter = Filter::box;
    std::optional<Float4> background;  // linear, premultiplied; else the scene's, else a light grey
    std::string camera;                // name or index of a camera of the scene; empty: the first
    std::optional<Float3> eye;         // with target: a camera of one's own, y up
    std::optional<Float3> target;
    std::optional<float> fov;  // full vertical angle in degrees, of that camera
    AlphaMips alpha_mips = AlphaMips::premultiplied;
    int texture_levels = 0;  // of each texture that are used, the largest first, 1 to 16; 0: all
    Conservative conservative = Conservative::off;
    ShadeAt shade_at = ShadeAt::fragment;
    // Of all samples, right and down, in 1/256 pixel, -255 to 255: what leaves a pixel on one side
    // comes back on the other. Samples at the pixel's centre stay there.
    std::array<int, 2> sample_shift = {0, 0};
    float exposure = 0;  // EV, -32 to 32; surfaces are multiplied by 2^EV, the background is not
    Shadows shadows;
    AmbientOcclusion ambient_occlusion;
    std::optional<Foveation> foveation;
};

inline constexpr int kMostFrames = 1'000'000;  // of a film

enum class Simd { best, scalar, sse4, avx2, avx512, neon };

// Frames of a random method where they are needed most, after section 6 of Enderton et al.,
// Stochastic Transparency. A few frames measure the variance around each pixel and are thrown away;
// those that count have random numbers of their own, so that choosing does not bias.
struct AdaptiveFrames {
    // Standard deviation of a pixel's channel that is aimed at, linear colour times 255: as many
    // frames as what the first few measured asks for. 0: off.
    float noise_target = 0;
    // Frames a pixel on average, 6 to 100,000, shared out in proportion to the deviation. 0: off.
    // Not both.
    float budget = 0;
    // Deviations count in proportion to what is dark: divided by luminance + 1/8.
    bool relative = false;
    int most = 1024;  // frames of a pixel, 1 to 65,535
};

// Smooths what is transparent, the part of the picture that has noise, across pixels of like total
// alpha, which has none. For methods that keep total alpha.
struct PostFilter {
    bool cross_bilateral = false;
    float sigma_s = 0.6f;   // pixels, 0.1 to 5
    float sigma_r = 0.05f;  // of total alpha, 0.001 to 1
};

struct Options {
    std::string method = "exact";  // ID[:NAME=VALUE]...
    int threads = 0;               // 0: all that the machine has
    Simd simd = Simd::best;
    std::uint64_t seed = 0;
    // Pictures to average, each with random numbers of its own, 1 to 1,000,000; where neither
    // method, shadows nor ambient occlusion are random one is enough, and one is drawn.
    int accumulate = 1;
    // The picture's number in a film, 0 to kMostFrames - 1: random methods have other numbers in
    // each frame. All others, and shadows, are the same in all; hashed ones unless they are told to
    // vary, which they do in turns of `period` frames: 1, 2, 4, 8, 16, 32 or 64.
    int frame = 0;
    int period = 8;
    AdaptiveFrames adaptive;  // instead of `accumulate`
    PostFilter post_filter;
    // What the whole process may take while it draws the picture, and then to write it to a file,
    // in bytes; 0: no limit. The picture is the same with and without. Renders at the same time
    // each count what the process takes when they begin, and not one another's growth.
    std::uint64_t memory_limit = 0;
    bool channels = false;  // Frame::channels are wanted
    // Called now and then, from one thread at a time, with the part done, in [0, 1].
    std::function<void(double)> progress;
};

struct PassTime {
    std::string name;
    double ms = 0;  // sum over threads / number of threads
};

struct Stats {
    std::string method;      // id
    std::string parameters;  // NAME=VALUE:NAME=VALUE, defaults included
    int samples = 0;
    int width = 0;
    int height = 0;
    std::string backend = "cpu";
    std::string simd;
    int threads = 0;
    std::uint64_t seed = 0;
    std::uint64_t triangles = 0;  // submitted
    // Transparent, covered at one visible sample or more. Methods whose nearest fragments hide the
    // others leave out triangles that are found hidden as a whole: their fragments are not made and
    // don't count, and how many are found so depends on `simd`. Those that are found hidden between
    // coverage and shading do, whatever their opacity, which is not known then.
    std::uint64_t fragments = 0;
    int passes = 1;
    double frames_per_pixel = 1;  // averaged or thrown away
    double bytes_per_pixel = 0;   // of the method's store
    std::uint64_t peak_memory_bytes = 0;
    double ms_geometry = 0;
    double ms_raster_shade = 0;
    double ms_store = 0;
    double ms_resolve = 0;
    double ms_total = 0;
    // Rasterising and shading, "fragments"; then what the store takes, pass by pass, those of the
    // same kind together.
    std::vector<PassTime> ms_passes;
};

// What lies under a picture, pixel by pixel; as large as the image, rows from the top. Of
// transparent fragments, in front of what is opaque.
struct Channels {
    std::vector<float> fragments;         // in the pixel
    std::vector<float> depth_complexity;  // layers over a sample, mean over the pixel's samples
    std::vector<float> coverage;          // part of the samples with a layer or more, in [0, 1]
    std::vector<float> depth;   // of the nearest, at the pixel's centre: metres from the eye along
                                // the axis of view; infinity without one
    std::vector<float> frames;  // averaged in the pixel
};

struct Frame {
    Image image;  // with alpha
    Stats stats;
    std::optional<Channels> channels;
};

// Throws sheer::Error (sheer/error.h): Fault::input when the view, the options or the scene can't
// be drawn, Fault::work when the memory limit is too low for them.
Frame render(const Scene& scene, const View& view, const Options& options);

}  // namespace sheer
