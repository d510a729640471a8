#include "image/resample.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "image/color.h"

namespace sheer {

namespace {

// The two old texels that a new one lies between, and the second one's part.
struct Between {
    std::size_t first, second;
    double part;
};

Between between(int i, int from, int to)
{
    const double at = (i + 0.5) * from / to - 0.5;
    const double below = std::floor(at);
    const int first = static_cast<int>(below);
    return {static_cast<std::size_t>((first + from) % from),
            static_cast<std::size_t>((first + 1) % from), at - below};
}

std::array<double, 256> make_linear_values()
{
    std::array<double, 256> values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = linear_from_srgb(static_cast<double>(i) / 255.0);
    }
    return values;
}

}  // namespace

TextureImage enlarged(const TextureImage& image, int width, int height)
{
    static const std::array<double, 256> linear = make_linear_values();
    TextureImage result;
    result.name = image.name;
    result.width = width;
    result.height = height;
    result.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto row = static_cast<std::size_t>(image.width);
    const auto value = [&](std::size_t x, std::size_t y, std::size_t c) {
        const std::uint8_t encoded = image.texels[y * row + x][c];
        return c < 3 ? linear[encoded] : encoded / 255.0;
    };
    auto* to = result.texels.data();
    for (int y = 0; y < height; ++y) {
        const Between v = between(y, image.height, height);
        for (int x = 0; x < width; ++x, ++to) {
            const Between u = between(x, image.width, width);
            for (std::size_t c = 0; c < 4; ++c) {
                const double above =
                    std::lerp(value(u.first, v.first, c), value(u.second, v.first, c), u.part);
                const double below =
                    std::lerp(value(u.first, v.second, c), value(u.second, v.second, c), u.part);
                const double mean = std::lerp(above, below, v.part);
                (*to)[c] = c < 3 ? srgb8_from_linear(mean)
                                 : static_cast<std::uint8_t>(std::floor(255 * mean + 0.5));
            }
        }
    }
    return result;
}

}  // namespace sheer
