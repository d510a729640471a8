// The reference's own parts: what a triangle is in a pixel, and what a sample makes of it.
// Only src/reference includes this.
#pragma once

#include <cstdint>
#include <vector>

#include <sheer/scene.h>

#include "geometry/triangles.h"
#include "raster/sample_pattern.h"
#include "reference/mipmap.h"
#include "reference/reference.h"

namespace sheer::reference {

struct PixelAddress {
    int x, y;
};

struct Weights {
    double b[3];
};

// Bit s: sample s of the pixel is covered.
std::uint64_t covered_samples(const Triangle& triangle, PixelAddress pixel,
                              const std::vector<SamplePoint>& pattern);

// Barycentric weights, affine on the screen, at the mean of the samples of `mask`, which is not 0.
Weights weights_at_centroid(const Triangle& triangle, PixelAddress pixel, std::uint64_t mask,
                            const std::vector<SamplePoint>& pattern);

double depth_at(const Triangle& triangle, PixelAddress pixel, SamplePoint sample);

// What a fragment does to the surfaces behind it.
enum class Presence {
    transparent,
    opaque,
    absent,  // MASK below its cutoff, or nothing to see
};

// A triangle's fragment in one pixel, shaded.
struct Surface {
    const Triangle* triangle = nullptr;
    std::uint64_t mask = 0;       // the samples that it covers
    double color[3] = {0, 0, 0};  // straight, as in Fragment; the radiance of an opaque one
    double opacity = 0;
    double transmittance[3] = {1, 1, 1};
    Presence presence = Presence::absent;
    std::uint8_t discontinuities = 0;  // its own: rounding may shade it otherwise
};

// What all fragments of a picture are shaded with.
struct Shader {
    const Scene& scene;
    const Geometry& geometry;
    Textures textures;
    double exposure_scale;
};

// Shades at `affine` weights, by docs/numerics.md, "Shading"; triangle and mask are the caller's to
// set.
Surface shade(const Shader& shader, const TriangleChunk& chunk, const Triangle& triangle,
              const Weights& affine);

// A surface as one sample sees it.
struct Sighting {
    const Surface* surface;
    double depth;
};

// In front of: the smaller (depth, primitive id).
bool in_front(const Sighting& a, const Sighting& b);

// All surfaces that cover one sample.
struct SampleView {
    std::vector<Sighting> visible;    // transparent, in front of the opaque depth, near to far
    std::vector<Sighting> hidden;     // transparent, not in front of it
    std::vector<Sighting> opaque;     // near to far; the first one wins
    std::vector<Sighting> undecided;  // with discontinuities of their own, whether present or not
};

// Bits of Discontinuity.
std::uint8_t discontinuities(const SampleView& view);

}  // namespace sheer::reference
