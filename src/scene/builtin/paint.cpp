#include "scene/builtin/paint.h"

#include <algorithm>
#include <cmath>

#include "image/color.h"

namespace sheer {

using shapes::Vec;

Paint over(const Paint& front, const Paint& back)
{
    const double rest = (1 - front.alpha) * back.alpha;
    const double alpha = front.alpha + rest;
    if (alpha <= 0) return {{}, 0};
    return {1 / alpha * (front.alpha * front.color + rest * back.color), alpha};
}

TextureImage paint_image(const std::string& name, int width, int height, int grid,
                         const std::function<Paint(double u, double v)>& paint,
                         Vec color_of_nothing)
{
    TextureImage image;
    image.name = name;
    image.width = width;
    image.height = height;
    const double points = grid * grid;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Vec sum;
            double alpha = 0;
            for (int i = 0; i < grid * grid; ++i) {
                const Paint at = paint((x + (i % grid + 0.5) / grid) / width,
                                       (y + (i / grid + 0.5) / grid) / height);
                sum = sum + at.alpha * at.color;
                alpha += at.alpha;
            }
            const Vec c = alpha > 0 ? 1 / alpha * sum : color_of_nothing;
            const double whole = std::floor(255 * clamp_unit(alpha / points) + 0.5);
            image.texels.push_back({srgb8_from_linear(c.x), srgb8_from_linear(c.y),
                                    srgb8_from_linear(c.z), static_cast<std::uint8_t>(whole)});
        }
    }
    return image;
}

double clamp_unit(double t)
{
    return std::clamp(t, 0.0, 1.0);
}

double mix(double a, double b, double t)
{
    return a + t * (b - a);
}

Vec mix(Vec a, Vec b, double t)
{
    return a + t * (b - a);
}

double smooth_step(double from, double to, double t)
{
    const double s = clamp_unit((t - from) / (to - from));
    return s * s * (3 - 2 * s);
}

}  // namespace sheer
