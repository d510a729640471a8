// exp, log, sin, cos, tan and atan2 in double precision, from operations that IEEE 754 rounds
// correctly. Each reduces its argument to a short interval around 0, with the constant taken off in
// two or three parts so that the first products are exact (Cody and Waite, Software Manual for the
// Elementary Functions, 1980), and sums the Taylor series there. The number of terms is chosen so
// that the first one left out is below 2^-56 of the result; 1/3, 1/5! and so on need no table.
#include "support/math.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace sheer {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// log(2): the first 32 bits, so that its product with any exponent is exact, and the rest.
constexpr double kLog2High = 0x1.62e42feep-1;
constexpr double kLog2Low = 0x1.a39ef35793c76p-33;
constexpr double kInverseLog2 = 0x1.71547652b82fep+0;

// pi / 2: two parts of 33 bits, so that their products with integers up to 2^20 are exact, and the
// rest.
constexpr double kHalfPi1 = 0x1.921fb544p+0;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34;
constexpr double kHalfPi3 = 0x1.3198a2e037073p-69;
constexpr double kInverseHalfPi = 0x1.45f306dc9c883p-1;

// The double nearest to pi, and what it leaves.
constexpr double kPiHigh = 0x1.921fb54442d18p+1;
constexpr double kPiLow = 0x1.1a62633145c07p-53;

double power_of_two(int exponent)  // -1022 to 1023
{
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// c[0] + c[1] x + ...
template <std::size_t N>
double polynomial(const std::array<double, N>& c, double x)
{
    double sum = c[N - 1];
    for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + c[i];
    return sum;
}

// 1/first!, sign/(first + step)!, 1/(first + 2 step)!, ...
template <std::size_t N>
constexpr std::array<double, N> inverse_factorials(int first, int step, double sign)
{
    std::array<double, N> c{};
    double factorial = 1;  // exact up to 18!, the largest used here
    double s = 1;
    int n = 1;
    for (std::size_t i = 0; i < N; ++i) {
        for (; n <= first + static_cast<int>(i) * step; ++n) factorial *= n;
        c[i] = s / factorial;
        s *= sign;
    }
    return c;
}

// 1/first, sign/(first + 2), 1/(first + 4), ...
template <std::size_t N>
constexpr std::array<double, N> inverse_odds(int first, double sign)
{
    std::array<double, N> c{};
    double s = 1;
    for (std::size_t i = 0; i < N; ++i) {
        c[i] = s / (first + 2 * static_cast<int>(i));
        s *= sign;
    }
    return c;
}

// x = 2^exponent (1 + f), 1 + f in [sqrt(1/2), sqrt(2)), for finite x > 0.
struct Split {
    int exponent;
    double f;  // exact: 1 + f is a double within a factor 2 of 1
};

Split split(double x)
{
    int exponent = -1023;
    if (x < std::numeric_limits<double>::min()) {
        x *= 0x1p54;
        exponent -= 54;
    }
    const auto bits = std::bit_cast<std::uint64_t>(x);
    exponent += static_cast<int>(bits >> 52);
    constexpr std::uint64_t kMantissa = (std::uint64_t{1} << 52) - 1;
    double m = std::bit_cast<double>((bits & kMantissa) | (std::uint64_t{1023} << 52));
    if (m > 0x1.6a09e667f3bcdp+0) {
        m *= 0.5;
        ++exponent;
    }
    return {exponent, m - 1};
}

// log(1 + f) = f - log1p_tail(f). With s = f / (2 + f) it is 2 atanh(s) = 2s + s R(s^2), and since
// 2s = f - s f the largest term, f, carries no rounding error.
double log1p_tail(double f)
{
    static constexpr auto kOdds = inverse_odds<11>(3, 1);
    const double s = f / (2 + f);
    const double s2 = s * s;
    return s * (f - 2 * s2 * polynomial(kOdds, s2));
}

// What log and log2 have in common outside the positive finite numbers.
bool special_log(double x, double& result)
{
    if (x > 0 && x < kInfinity) return false;
    result = x == 0 ? -kInfinity : x > 0 ? x : kNaN;
    return true;
}

// x = k pi / 2 + high + low, |high| <= pi / 4 and a little.
struct Reduced {
    int quadrant;  // k modulo 4
    double high, low;
};

Reduced reduce(double x)
{
    const double k = std::floor(x * kInverseHalfPi + 0.5);
    // The first difference is exact, as its terms are within a factor 2 of each other or k is 0.
    // That of the second is kept in two parts (Knuth's two-sum).
    const double a = x - k * kHalfPi1;
    const double b = k * kHalfPi2;
    const double difference = a - b;
    const double b_seen = a - difference;
    const double lost = (a - (difference + b_seen)) + (b_seen - b);
    const double rest = lost - k * kHalfPi3;
    const double high = difference + rest;
    return {static_cast<int>(k - 4 * std::floor(k * 0.25)), high, (difference - high) + rest};
}

double sin_reduced(double high, double low)
{
    static constexpr auto kTerms = inverse_factorials<8>(3, 2, -1);
    const double h2 = high * high;
    return high - (high * h2 * polynomial(kTerms, h2) - low * (1 - 0.5 * h2));
}

double cos_reduced(double high, double low)
{
    static constexpr auto kTerms = inverse_factorials<8>(4, 2, -1);
    const double h2 = high * high;
    return 1 - (0.5 * h2 - (h2 * h2 * polynomial(kTerms, h2) - high * low));
}

constexpr double kLargestAngle = 0x1p20;

// sin(x + shift pi / 2)
double sin_shifted(double x, int shift)
{
    if (!(std::abs(x) <= kLargestAngle)) return kNaN;
    const Reduced r = reduce(x);
    const int quadrant = (r.quadrant + shift) & 3;
    const double value = quadrant & 1 ? cos_reduced(r.high, r.low) : sin_reduced(r.high, r.low);
    return quadrant & 2 ? -value : value;
}

// atan(t) for t in [0, 1]: atan(c) + atan((t - c) / (1 + t c)), c the nearest quarter.
double atan_unit(double t)
{
    struct Part {
        double high, low;
    };
    static constexpr Part kQuarters[5] = {{0, 0},
                                          {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                          {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                          {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                          {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
    static constexpr auto kOdds = inverse_odds<8>(3, -1);
    const int i = static_cast<int>(4 * t + 0.5);
    const double c = 0.25 * i;
    const double u = (t - c) / (1 + t * c);
    const double u2 = u * u;
    return kQuarters[i].high + (u - (u * u2 * polynomial(kOdds, u2) - kQuarters[i].low));
}

}  // namespace

double own_exp(double x)
{
    if (std::isnan(x)) return x;
    if (x > 710) return kInfinity;
    if (x < -746) return 0;
    // x = k log 2 + r; exp(r) = 1 + (high + low) + r^2 (1/2! + r/3! + ...)
    static constexpr auto kTerms = inverse_factorials<13>(2, 1, 1);
    const double k = std::floor(x * kInverseLog2 + 0.5);
    const double high = x - k * kLog2High;
    const double low = k * kLog2Low;
    const double r = high - low;
    const double value = 1 + (high + (r * r * polynomial(kTerms, r) - low));
    // In two steps, as 2^k itself may be too large or too small for a double.
    const int exponent = static_cast<int>(k);
    const int half = exponent / 2;
    return value * power_of_two(half) * power_of_two(exponent - half);
}

double own_log(double x)
{
    double result = 0;
    if (special_log(x, result)) return result;
    const Split part = split(x);
    const double e = part.exponent;
    return e * kLog2High + (part.f - (log1p_tail(part.f) - e * kLog2Low));
}

double own_log2(double x)
{
    double result = 0;
    if (special_log(x, result)) return result;
    const Split part = split(x);
    return part.exponent + (part.f - log1p_tail(part.f)) * kInverseLog2;
}

double own_sin(double x)
{
    return x == 0 ? x : sin_shifted(x, 0);
}

double own_cos(double x)
{
    return sin_shifted(x, 1);
}

double own_tan(double x)
{
    return own_sin(x) / own_cos(x);
}

double own_atan2(double y, double x)
{
    if (std::isnan(x) || std::isnan(y)) return kNaN;
    const double along = std::abs(x);
    const double across = std::abs(y);
    const double longer = along > across ? along : across;
    const double shorter = along > across ? across : along;
    // Equal infinities count as equal lengths, and 0 over 0 as 0.
    const double ratio = longer == 0 ? 0 : shorter == longer ? 1 : shorter / longer;
    const bool steep = across > along;
    const bool behind = std::signbit(x);
    // The nearest half axis is at k pi / 2, and the angle from it as far as the ratio says.
    const double half_k = steep ? 0.5 : behind ? 1 : 0;
    const double from_axis = steep == behind ? atan_unit(ratio) : -atan_unit(ratio);
    const double angle = half_k * kPiHigh + (from_axis + half_k * kPiLow);
    return std::copysign(angle, y);
}

double own_pow(double base, double exponent)
{
    if (exponent == 0 || base == 1) return 1;
    if (base == 0) return exponent > 0 ? 0 : exponent < 0 ? kInfinity : kNaN;
    return own_exp(exponent * own_log(base));
}

}  // namespace sheer
