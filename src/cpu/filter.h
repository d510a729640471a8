// From samples to pixels (docs/numerics.md, "Resolve").
#pragma once

#include <vector>

#include <sheer/image.h>
#include <sheer/render.h>

#include "geometry/tile_grid.h"
#include "methods/method.h"
#include "raster/sample_set.h"

namespace sheer {

template <int Channels>
using PixelValue = std::array<float, static_cast<std::size_t>(Channels)>;
template <int Channels>
using PixelValues = std::vector<PixelValue<Channels>>;

class SampleFilter {
public:
    SampleFilter(Filter kind, const SampleSet& samples);

    // Pixels around that the filter reaches: the tile's apron.
    int reach() const { return weights_.empty() ? 0 : 1; }

    // The pixels of `interior`, row by row, from the samples of `rect` around it. For 4 and 5
    // channels.
    template <int Channels>
    void apply(const SampleValues<Channels>& samples, const PixelRect& rect,
               const PixelRect& interior, PixelValues<Channels>& pixels) const;

private:
    template <int Channels>
    PixelValue<Channels> gaussian(const SampleValues<Channels>& samples, const PixelRect& rect,
                                  int x, int y) const;

    int samples_;
    std::vector<float> weights_;  // Gaussian: of sample s of neighbour n (row by row) at 9 s + n
};

}  // namespace sheer
