#include "reference/fourier.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "reference/power_moments.h"

namespace sheer::reference {

FourierSums fourier_sums(std::span<const Fragment> fragments, int n, double most)
{
    const std::size_t terms = static_cast<std::size_t>(n) + 1;
    FourierSums sums{std::vector<double>(terms), std::vector<double>(terms)};
    for (const Fragment& f : fragments) {
        const double delta = absorbance(f.opacity, most);
        for (std::size_t k = 0; k < terms; ++k) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(k) * f.depth;
            sums.a[k] += 2 * delta * std::cos(angle);
            sums.b[k] += 2 * delta * std::sin(angle);
        }
    }
    return sums;
}

double fourier_absorbance(const FourierSums& sums, double d, bool lanczos)
{
    const auto n = static_cast<double>(sums.a.size() - 1);
    double sum = sums.a[0] * d / 2;
    for (std::size_t i = 1; i < sums.a.size(); ++i) {
        const auto k = static_cast<double>(i);
        const double w = 2 * std::numbers::pi * k, x = std::numbers::pi * k / n;
        const double factor = lanczos ? std::sin(x) / x : 1;
        sum += factor * (sums.a[i] * std::sin(w * d) + sums.b[i] * (1 - std::cos(w * d))) / w;
    }
    return sum;
}

double fourier_transmittance(const FourierSums& sums, double d, bool lanczos)
{
    return std::exp(-fourier_absorbance(sums, d, lanczos));
}

}  // namespace sheer::reference
