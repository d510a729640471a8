// What the alpha tests make of a fragment, in doubles, by src/reference; integer hashes as their
// authors print them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "methods/tile_fixture.h"
#include "reference/alpha_to_coverage.h"
#include "reference/hashed_threshold.h"

namespace sheer::test {

using reference::Point3;

// pcg3d, Jarzynski and Olano 2020, listing of the supplement; .x.
inline std::uint32_t pcg3d(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
    std::uint32_t v[3] = {x, y, z};
    for (std::uint32_t& c : v) c = c * 1664525u + 1013904223u;
    v[0] += v[1] * v[2];
    v[1] += v[2] * v[0];
    v[2] += v[0] * v[1];
    for (std::uint32_t& c : v) c ^= c >> 16;
    return v[0] + v[1] * v[2];
}

// xxHash's XXH32 of twelve bytes, seed 0, as its specification goes through short inputs.
inline std::uint32_t xxh32(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
    constexpr std::uint32_t kPrime[] = {2654435761u, 2246822519u, 3266489917u, 668265263u,
                                        374761393u};
    std::uint32_t h = kPrime[4] + 12;
    for (const std::uint32_t word : {x, y, z}) h = std::rotl(h + word * kPrime[2], 17) * kPrime[3];
    h = (h ^ h >> 15) * kPrime[1];
    h = (h ^ h >> 13) * kPrime[2];
    return h ^ h >> 16;
}

// lowbias32 of the third coordinate, and each time of the sum with the one before.
inline std::uint32_t lowbias(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
    const auto hash = [](std::uint32_t h) {
        h = (h ^ h >> 16) * 0x7feb352du;
        h = (h ^ h >> 15) * 0x846ca68bu;
        return h ^ h >> 16;
    };
    return hash(x + hash(y + hash(z)));
}

inline double integer_hash(const std::string& name, const Point3& cell)
{
    std::uint32_t c[3];
    for (std::size_t i = 0; i < 3; ++i) {
        c[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(cell[i]));
    }
    const auto hash = name == "pcg" ? pcg3d : name == "lowbias" ? lowbias : xxh32;
    return (hash(c[0], c[1], c[2]) >> 8) * 0x1p-24;
}

// The mixture of eight corners, made uniform after each axis, of a point and sizes of cells.
inline double corners_threshold(const Point3& point, const Point3& scales,
                                const reference::CellHash& hash, bool uniform)
{
    Point3 cell[2], t;
    for (std::size_t i = 0; i < 3; ++i) {
        const double octave = std::log2(scales[i]);
        t[i] = octave - std::floor(octave);
        cell[0][i] = std::floor(std::exp2(std::floor(octave)) * point[i]);
        cell[1][i] = std::floor(std::exp2(std::ceil(octave)) * point[i]);
    }
    const auto mix = [&](double a, double b, double part) {
        const double x = (1 - part) * a + part * b;
        return uniform ? reference::mix_of_two_cdf(x, part) : x;
    };
    double along[4];
    for (std::size_t k = 0; k < 4; ++k) {
        const double y = cell[k % 2][1], z = cell[k / 2][2];
        along[k] = mix(hash({cell[0][0], y, z}), hash({cell[1][0], y, z}), t[0]);
    }
    return std::clamp(mix(mix(along[0], along[1], t[1]), mix(along[2], along[3], t[1]), t[2]), 1e-6,
                      1.0);
}

// Thresholds are off by that of the exact ones at most: octaves by some 1e-6 (a few roundings of
// derivatives, 2e-8 of the logarithm, near 1), the mixture by as much and its distribution by 2 /
// (1 - a) <= 4 times that.
constexpr double kThresholdError = 1e-5;

// Of a place that floats hold. `number` as other_cells has it. None: rounding decides on a cell, or
// on which size counts more.
inline std::optional<double> hashed_oracle(const ChosenMethod& method,
                                           const std::array<float, 9>& place, int number = 0)
{
    const std::string &variant = method.value("variant"), &name = method.value("hash");
    const std::string& without = method.value("without");
    reference::SurfacePoint point;
    for (std::size_t i = 0; i < 3; ++i) {
        point.position[i] = static_cast<double>(place[i]);
        point.dx[i] = static_cast<double>(place[3 + i]);
        point.dy[i] = static_cast<double>(place[6 + i]);
    }
    bool doubtful = name == "paper";  // floats have other sines
    reference::HashedThreshold how;
    how.variant = variant == "isotropic" ? reference::HashedThreshold::Variant::isotropic
                                         : reference::HashedThreshold::Variant::anisotropic;
    how.hash_scale = static_cast<double>(static_cast<float>(method.real("hash-scale")));
    how.discrete = without != "octaves";
    how.uniform = without != "uniform";
    const bool third = without != "third";
    how.hash = [&, number](Point3 cell) {
        if (!third) cell[2] = 0;
        const double offset[] = {1571, 2083, 3181};
        for (std::size_t i = 0; i < 3; ++i) cell[i] += number * offset[i];
        return name == "paper" ? 0.5 : integer_hash(name, cell);
    };
    // The sizes once more, to see what is in doubt.
    Point3 scales;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        scales[i] = std::max(std::abs(point.dx[i]), std::abs(point.dy[i]));
        most = std::max(most, scales[i]);
    }
    const double longest = std::max(std::hypot(point.dx[0], point.dx[1], point.dx[2]),
                                    std::hypot(point.dy[0], point.dy[1], point.dy[2]));
    for (std::size_t i = 0; i < 3; ++i) {
        scales[i] = variant == "isotropic"
                        ? 1 / (how.hash_scale * longest)
                        : 0.707 / (how.hash_scale * std::max(scales[i], most / 16));
        const double octave = std::log2(scales[i]);
        if (std::abs(octave - std::round(octave)) < 1e-5) doubtful = true;
        const double cell = scales[i] * point.position[i];
        const double nearest = std::abs(cell - std::round(cell));
        if (!how.discrete && nearest < 1e-5 * (1 + std::abs(cell))) doubtful = true;
        if (std::abs(cell) > 1e6) doubtful = true;
    }
    if (doubtful) return std::nullopt;
    if (variant == "eight-corners" && how.discrete) {
        return corners_threshold(point.position, scales, how.hash, how.uniform);
    }
    return reference::hashed_threshold(point, how);
}

enum class Kept { no, yes, unknown };

inline Kept at_least(double opacity, double threshold, double error)
{
    if (std::abs(opacity - threshold) <= error) return Kept::unknown;
    return opacity >= threshold ? Kept::yes : Kept::no;
}

inline Kept hashed_coverage_oracle(const Setting& setting, double opacity,
                                   const std::array<float, 9>& place, int s)
{
    const ChosenMethod& method = setting.method;
    const int n = setting.set->count;
    const auto chi = hashed_oracle(method, place, 0), xi1 = hashed_oracle(method, place, 1),
               xi2 = hashed_oracle(method, place, 2);
    if (!chi || !xi1 || !xi2) return Kept::unknown;
    const bool apart = method.value("decorrelate") == "on";
    const auto in_doubt = [&](double x) {
        return std::abs(n * x - std::round(n * x)) < n * kThresholdError ||
               std::abs(n * x / 2 - std::round(n * x / 2)) < n * kThresholdError;
    };
    if (apart && (in_doubt(*xi1) || in_doubt(*xi2))) return Kept::unknown;
    double own = *chi + (method.value("jitter") == "sample" ? s * 0.618034 : 0);
    if (method.value("jitter") == "sample") {
        if (std::abs(own - std::round(own)) < 1e-4) return Kept::unknown;
        own -= std::floor(own);
    }
    const int offset = apart ? reference::decorrelated_offset(n, *xi1) : 0;
    const int increment = apart ? reference::decorrelated_increment(n, *xi2) : 1;
    return at_least(opacity, reference::decorrelated_threshold(s, n, own, offset, increment),
                    5 * kThresholdError);
}

// Bayer's matrix by its recursion: four times the quarter's, and 0 2 / 3 1 of the quarters.
inline int bayer(int x, int y, int side)
{
    if (side == 1) return 0;
    const int half = side / 2;
    const int quarter = y < half ? (x < half ? 0 : 2) : (x < half ? 3 : 1);
    return 4 * bayer(x % half, y % half, half) + quarter;
}

// Without the random part, whose oracle would be the text.
inline Kept screen_door_oracle(const ChosenMethod& method, double opacity, std::uint32_t pixel)
{
    if (method.value("decorrelate") != "off" || method.value("jitter") == "on") {
        return Kept::unknown;
    }
    const int side = method.number("square"), n = side * side;
    const int x = static_cast<int>(pixel % kTileSize), y = static_cast<int>(pixel / kTileSize);
    return at_least(opacity, reference::fixed_threshold(bayer(x % side, y % side, side), n), 0);
}

// Whether a method that is not random keeps sample s of the plate in a pixel.
inline Kept kept_by(const Setting& setting, const Plate& plate, std::uint32_t pixel, int s)
{
    const ChosenMethod& method = setting.method;
    const std::string id = method.row->id;
    const auto opacity = static_cast<double>(plate.color[3]);
    if (id == "alpha-test") {
        return opacity >= static_cast<double>(static_cast<float>(method.real("cutoff"))) ? Kept::yes
                                                                                         : Kept::no;
    }
    if (id == "alpha-to-coverage") {
        const double threshold = reference::fixed_threshold(s, setting.set->count);
        return opacity >= threshold ? Kept::yes : Kept::no;
    }
    if (id == "screen-door") return screen_door_oracle(method, opacity, pixel);
    const std::array<float, 9> place = place_at(first_place_of(plate), pixel);
    if (id == "hashed-alpha-to-coverage") {
        return hashed_coverage_oracle(setting, opacity, place, s);
    }
    auto threshold = hashed_oracle(method, place);
    if (!threshold) return Kept::unknown;
    if (method.value("fade-in") != "off") {
        const double levels = static_cast<double>(static_cast<float>(method.real("fade-in")));
        const double b = reference::fade_in(static_cast<double>(level_of(plate)), levels);
        threshold = reference::faded_threshold(*threshold, b);
    }
    return at_least(opacity, *threshold, opacity == 1 ? 0 : kThresholdError);
}

}  // namespace sheer::test
