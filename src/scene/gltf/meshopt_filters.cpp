// EXT_meshopt_compression, appendix B. Not the library's functions, which round differently with
// each set of instructions.

#include "scene/gltf/meshopt_filters.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace sheer::gltf {

namespace {

std::int32_t read_signed(const std::uint8_t* at, std::size_t size)
{
    if (size == 1) return static_cast<std::int8_t>(*at);
    return static_cast<std::int16_t>(at[0] | at[1] << 8);
}

void write_signed(std::uint8_t* at, std::size_t size, std::int32_t value)
{
    const auto bits = static_cast<std::uint32_t>(value);
    for (std::size_t i = 0; i < size; ++i) at[i] = static_cast<std::uint8_t>(bits >> (8 * i));
}

// What is no number, as a division by zero gives it, becomes 0.
std::int32_t normalized(double x, double largest)
{
    if (!(std::abs(x) <= 1)) x = std::isnan(x) ? 0 : std::copysign(1.0, x);
    return static_cast<std::int32_t>(x * largest + (x < 0 ? -0.5 : 0.5));
}

}  // namespace

void decode_octahedral(std::span<std::uint8_t> bytes, std::size_t stride)
{
    const std::size_t size = stride / 4;
    const double largest = size == 1 ? 127 : 32767;
    for (std::size_t i = 0; i + stride <= bytes.size(); i += stride) {
        std::uint8_t* const at = &bytes[i];
        const double one = read_signed(at + 2 * size, size);
        double x = read_signed(at, size) / one;
        double y = read_signed(at + size, size) / one;
        const double z = 1 - std::abs(x) - std::abs(y);
        const double fold = std::min(z, 0.0);  // the lower half lies outside of the diamond
        x += x < 0 ? -fold : fold;
        y += y < 0 ? -fold : fold;
        const double length = std::sqrt(x * x + y * y + z * z);
        write_signed(at, size, normalized(x / length, largest));
        write_signed(at + size, size, normalized(y / length, largest));
        write_signed(at + 2 * size, size, normalized(z / length, largest));
    }
}

void decode_quaternions(std::span<std::uint8_t> bytes)
{
    constexpr double kRange = 0.70710678118654752;  // no smaller component is larger: 1 / sqrt(2)
    for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
        std::uint8_t* const at = &bytes[i];
        const std::int32_t last = read_signed(at + 6, 2);
        const double one = last | 3;
        std::array<double, 3> small;
        double rest = 1;
        for (std::size_t k = 0; k < 3; ++k) {
            small[k] = read_signed(at + 2 * k, 2) / one * kRange;
            rest -= small[k] * small[k];
        }
        const auto place = static_cast<std::size_t>(last & 3);
        write_signed(at + 2 * place, 2, normalized(std::sqrt(std::max(rest, 0.0)), 32767));
        for (std::size_t k = 0; k < 3; ++k) {
            write_signed(at + 2 * ((place + 1 + k) % 4), 2, normalized(small[k], 32767));
        }
    }
}

void decode_exponential(std::span<std::uint8_t> bytes)
{
    for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) {
        std::uint8_t* const at = &bytes[i];
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 4; ++k) bits |= static_cast<std::uint32_t>(at[k]) << (8 * k);
        const std::int32_t exponent = static_cast<std::int8_t>(bits >> 24);
        const std::int32_t mantissa = static_cast<std::int32_t>(bits << 8) >> 8;
        const auto value = static_cast<float>(std::ldexp(double(mantissa), exponent));
        write_signed(at, 4, std::bit_cast<std::int32_t>(value));
    }
}

}  // namespace sheer::gltf
