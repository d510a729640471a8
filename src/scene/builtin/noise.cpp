#include "scene/builtin/noise.h"

#include <cmath>
#include <cstdint>

#include "support/random.h"

namespace sheer {
namespace {

using shapes::Vec;

double fade(double t)
{
    return t * t * t * (t * (6 * t - 15) + 10);
}

// The product of the gradient at a lattice point, one of a cube's twelve edges, and (x, y, z).
double along_gradient(std::int64_t i, std::int64_t j, std::int64_t k, Vec p)
{
    const auto low = [](std::int64_t n) { return static_cast<std::uint32_t>(n); };
    const std::uint32_t hash = hash_u32(low(i) ^ hash_u32(low(j) ^ hash_u32(low(k) + 0x9e3779b9u)));
    const double first = (hash & 1) != 0 ? 1 : -1, second = (hash & 2) != 0 ? 1 : -1;
    switch ((hash >> 8) % 3) {
        case 0: return first * p.x + second * p.y;
        case 1: return first * p.y + second * p.z;
        default: return first * p.z + second * p.x;
    }
}

}  // namespace

double noise(Vec p)
{
    const double floors[3] = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    const auto i = static_cast<std::int64_t>(floors[0]);
    const auto j = static_cast<std::int64_t>(floors[1]);
    const auto k = static_cast<std::int64_t>(floors[2]);
    const Vec f = {p.x - floors[0], p.y - floors[1], p.z - floors[2]};
    const double u = fade(f.x), v = fade(f.y), w = fade(f.z);
    double planes[2];
    for (int z = 0; z < 2; ++z) {
        double rows[2];
        for (int y = 0; y < 2; ++y) {
            const double left = along_gradient(i, j + y, k + z, {f.x, f.y - y, f.z - z});
            const double right = along_gradient(i + 1, j + y, k + z, {f.x - 1, f.y - y, f.z - z});
            rows[y] = left + u * (right - left);
        }
        planes[z] = rows[0] + v * (rows[1] - rows[0]);
    }
    return planes[0] + w * (planes[1] - planes[0]);
}

double fractal_noise(Vec p, int octaves)
{
    double sum = 0, strength = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += strength * noise(p);
        // Off the lattice, so that the octaves' zeros do not fall together.
        p = 2.0 * p + Vec{17.3, 5.7, 11.1};
        strength /= 2;
    }
    return sum;
}

}  // namespace sheer
