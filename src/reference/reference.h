// The oracle: every fragment of a sample in double precision, sorted, composited with `over`.
//
// Slow and plain on purpose. It shares the scene, the decoded images and the posed, clipped,
// snapped triangles with the renderer, and the positions of the samples, nothing else;
// docs/numerics.md is its specification.
#pragma once

#include <cstdint>
#include <vector>

#include <sheer/render.h>
#include <sheer/scene.h>

#include "geometry/triangles.h"
#include "raster/sample_pattern.h"

namespace sheer::reference {

// One fragment as one sample sees it.
struct Fragment {
    double depth = 0;
    double opacity = 0;           // in [0, 1]
    double color[3] = {0, 0, 0};  // straight, linear
    std::uint32_t id = 0;
    // Of each channel; of coloured glass the mean is 1 - opacity.
    double transmittance[3] = {1 - opacity, 1 - opacity, 1 - opacity};
};

struct Rgba {
    double r = 0, g = 0, b = 0, a = 0;  // premultiplied, linear
};

// The exact colour of one sample: fragments in any order over a backdrop (docs/numerics.md,
// "Resolve"), each channel by its own transmittance, alpha by the mean of what they all let
// through. Ties in depth: the smaller id is in front.
Rgba composite(std::vector<Fragment> fragments, Rgba backdrop);

// Why a pixel's exact answer may jump under the renderer's rounding. Two depths are within rounding
// when they differ by less than 1e-6 of the largest depth, in magnitude, of the two triangles'
// vertices. That includes depths that are equal here, for floats may part them, but never two
// triangles of constant depth nor two with the same corners: floats are exact or equally wrong
// there, and a tie goes by id on both sides. A jump that changes the sample by less than 1e-7 is
// none.
enum Discontinuity : std::uint8_t {
    kDepthsWithinRounding = 1,  // of two visible transparent fragments, or of two opaque ones
    kOpacityAtCutoff = 2,       // a visible MASK fragment's opacity within 1e-6 of its cutoff, 1e-4
                                // where it is textured
    kCoplanarWithOpaque = 4,    // of a transparent fragment and the opaque one
    kNearestTexel = 8,          // a visible fragment's texture is read within 1e-3 texel of where
                                // the nearest texel changes, or its level is within 1e-4 of where
                                // the nearest level or the filter does
    kProbeCount = 16,           // a visible fragment's texture is read with a number of probes that
                                // changes within 1e-4 of the ratio of its footprint's sides
    kSteepColor = 32,           // a visible fragment's colour changes by more than a quarter of
                                // 1e-4 max(1, |C|) when its texture coordinates change by 2^-23 of
                                // themselves or its unit normal by 2^-21: a sharp highlight
};

struct Picture {
    int width = 0, height = 0;
    std::vector<Rgba> pixels;                   // rows from the top
    std::vector<std::uint8_t> discontinuities;  // one for each pixel: Discontinuity bits of any of
                                                // the samples that its filter reaches
};

// The picture that docs/numerics.md defines. `background` is premultiplied; view.exposure, samples,
// positions, filter, width and height are used, its camera is not (the triangles are projected).
Picture render(const Scene& scene, const Geometry& geometry, const View& view, Float4 background);

}  // namespace sheer::reference
