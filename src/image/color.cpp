// The sRGB curve. Its two pieces meet at 0.04045 encoded; the linear value there is computed from
// that and not from the standard's rounded 0.0031308, so that the two directions agree.
#include "image/color.h"

#include <array>
#include <cstddef>

#include "support/math.h"

namespace sheer {
namespace {

constexpr double kEncodedJoint = 0.04045;
constexpr double kLinearJoint = kEncodedJoint / 12.92;

// thresholds[c]: the smallest linear value that rounds to c, for c >= 1.
std::array<double, 256> make_thresholds()
{
    std::array<double, 256> thresholds{};
    for (std::size_t c = 1; c < thresholds.size(); ++c) {
        thresholds[c] = linear_from_srgb((static_cast<double>(c) - 0.5) / 255);
    }
    return thresholds;
}

}  // namespace

double linear_from_srgb(double encoded)
{
    return encoded <= kEncodedJoint ? encoded / 12.92 : own_pow((encoded + 0.055) / 1.055, 2.4);
}

double srgb_from_linear(double linear)
{
    return linear <= kLinearJoint ? linear * 12.92 : 1.055 * own_pow(linear, 1 / 2.4) - 0.055;
}

std::uint8_t srgb8_from_linear(double linear)
{
    static const std::array<double, 256> thresholds = make_thresholds();
    std::size_t code = 0;
    for (std::size_t step = 128; step > 0; step /= 2) {
        code += linear >= thresholds[code + step] ? step : 0;  // false for NaN
    }
    return static_cast<std::uint8_t>(code);
}

}  // namespace sheer
