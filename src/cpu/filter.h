// From samples to pixels (docs/numerics.md, "Resolve").
#pragma once

#include <vector>

#include <sheer/image.h>
#include <sheer/render.h>

#include "geometry/tile_grid.h"
#include "methods/method.h"
#include "raster/sample_set.h"

namespace sheer {

class SampleFilter {
public:
    SampleFilter(Filter kind, const SampleSet& samples);

    // Pixels around that the filter reaches: the tile's apron.
    int reach() const { return weights_.empty() ? 0 : 1; }

    // The pixels of `interior`, row by row, from the samples of `rect` around it.
    void apply(const SampleColors& colors, const PixelRect& rect, const PixelRect& interior,
               std::vector<Float4>& pixels) const;

private:
    std::array<float, 4> gaussian(const SampleColors& colors, const PixelRect& rect, int x,
                                  int y) const;

    int samples_;
    std::vector<float> weights_;  // Gaussian: of sample s of neighbour n (row by row) at 9 s + n
};

}  // namespace sheer
