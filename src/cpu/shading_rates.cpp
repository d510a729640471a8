#include "cpu/shading_rates.h"

#include <algorithm>

namespace sheer {

namespace {

// From the point that is looked at to the nearest centre of a pixel, squared.
double nearest_squared(const Foveation& foveation, int x, int y, int side)
{
    const auto off = [side](float at, int first) {
        const double from = first + 0.5, to = first + side - 0.5, p = static_cast<double>(at);
        return std::max({from - p, p - to, 0.0});
    };
    const double across = off(foveation.x, x), down = off(foveation.y, y);
    return across * across + down * down;
}

int side_at(const Foveation& foveation, int x, int y)
{
    const double radius = static_cast<double>(foveation.radius);
    const double squared = radius * radius;
    if (nearest_squared(foveation, x & ~3, y & ~3, 4) > 4 * squared) return 4;
    return nearest_squared(foveation, x & ~1, y & ~1, 2) > squared ? 2 : 1;
}

}  // namespace

void ShadingRates::set(const Foveation& foveation, const PixelRect& rect)
{
    coarse = false;
    for (int row = rect.y0; row < rect.y1; ++row) {
        for (int column = rect.x0; column < rect.x1; ++column) {
            const int n = side_at(foveation, column, row);
            const int left = column & ~(n - 1), top = row & ~(n - 1);
            const int at = (row - rect.y0) * kTileSize + column - rect.x0;
            coarse = coarse || n > 1;
            side[at] = static_cast<float>(n);
            x[at] = static_cast<float>(left - rect.x0) + 0.5f * static_cast<float>(n - 1);
            y[at] = static_cast<float>(top - rect.y0) + 0.5f * static_cast<float>(n - 1);
            square[at] = static_cast<std::uint16_t>(std::max(top - rect.y0, 0) * kTileSize +
                                                    std::max(left - rect.x0, 0));
        }
    }
}

int ShadedSquares::list(const ShadingRates& rates, const std::uint32_t* pixels,
                        const std::uint32_t* lows, const std::uint32_t* highs, int count)
{
    ++triangle;
    int found = 0;
    for (int i = 0; i < count; ++i) {
        const std::uint16_t square = rates.square[pixels[i]];
        if (triangle_at[square] != triangle) {
            triangle_at[square] = triangle;
            number_at[square] = static_cast<std::uint16_t>(found);
            pixel[found] = pixels[i];
            low[found] = lows[i];
            high[found] = highs[i];
            ++found;
        }
        number[i] = number_at[square];
    }
    return found;
}

}  // namespace sheer
