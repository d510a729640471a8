// Where a frame's samples are, for averages over frames.
#include <cstddef>
#include <utility>

#include <sheer/film.h>

#include "raster/sample_pattern.h"

namespace sheer {

namespace {

// The last `bits` bits of i in the opposite order.
std::size_t reversed(std::size_t i, int period)
{
    std::size_t result = 0;
    for (int k = 1; k < period; k *= 2, i >>= 1) result = 2 * result + (i & 1);
    return result;
}

}  // namespace

std::array<int, 2> sample_shift(int period, int frame)
{
    // As many points as a pixel of that many samples has, and in an order in which neighbours are
    // not near: the small patterns have one, of the large ones x grows with the number.
    const std::vector<SamplePoint> points = sample_pattern(period, SamplePositions::standard);
    const auto i = static_cast<std::size_t>(frame % period);
    const SamplePoint point = points[period > 16 ? reversed(i, period) : i];
    return {point.x - 128, point.y - 128};
}

}  // namespace sheer
