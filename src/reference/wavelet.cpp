#include "reference/wavelet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "reference/power_moments.h"

namespace sheer::reference {
namespace {

// Of [low, high), what is behind d.
double length_behind(double low, double high, double d)
{
    return std::clamp(high - d, 0.0, high - low);
}

std::size_t cells_of(int rank)
{
    return std::size_t{2} << rank;
}

double moved(double d, std::size_t n)
{
    return d * static_cast<double>(n - 1) / static_cast<double>(n);
}

}  // namespace

std::vector<double> wavelet_coefficients(std::span<const Fragment> fragments, int rank, double most)
{
    const std::size_t n = cells_of(rank);
    std::vector<double> coefficients(n);
    for (const Fragment& f : fragments) {
        const double delta = absorbance(f.opacity, most), d = moved(f.depth, n);
        std::size_t i = 0;
        for (int p = 0; p <= rank; ++p) {
            const double length = std::ldexp(1, -p), amplitude = std::sqrt(1 / length);
            for (std::size_t k = 0; k >> p == 0; ++k, ++i) {
                const double low = static_cast<double>(k) * length;
                const double middle = low + length / 2, high = low + length;
                coefficients[i] += delta * amplitude *
                                   (length_behind(middle, high, d) - length_behind(low, middle, d));
            }
        }
        coefficients[n - 1] += delta * length_behind(0, 1, d);
    }
    return coefficients;
}

std::vector<double> wavelet_cells(const std::vector<double>& coefficients)
{
    const std::size_t n = coefficients.size();
    std::vector<double> cells(n, coefficients[n - 1]);
    std::size_t i = 0;
    for (std::size_t width = n; width > 1; width /= 2) {  // of a support, in cells
        const double amplitude = std::sqrt(static_cast<double>(n) / static_cast<double>(width));
        for (std::size_t first = 0; first < n; first += width, ++i) {
            for (std::size_t j = 0; j < width; ++j) {
                cells[first + j] += (j < width / 2 ? -1 : 1) * amplitude * coefficients[i];
            }
        }
    }
    return cells;
}

std::vector<double> cell_means(std::span<const Fragment> fragments, int rank, double most)
{
    const std::size_t n = cells_of(rank);
    const double length = 1 / static_cast<double>(n);
    std::vector<double> cells(n);
    for (const Fragment& f : fragments) {
        for (std::size_t j = 0; j < n; ++j) {
            const double low = static_cast<double>(j) * length;
            cells[j] += absorbance(f.opacity, most) *
                        length_behind(low, low + length, moved(f.depth, n)) / length;
        }
    }
    return cells;
}

double wavelet_absorbance(const std::vector<double>& cells, double d, bool exact_end)
{
    const std::size_t n = cells.size();
    if (exact_end && d >= 1) return cells.back();
    const double at = moved(d, n) * static_cast<double>(n);
    const double whole = std::clamp(std::floor(at), 0.0, static_cast<double>(n - 1));
    const auto own = static_cast<std::size_t>(whole);
    const double before = own > 0 ? cells[own - 1] : 0;
    return before + (at - whole) * (cells[own] - before);
}

double wavelet_transmittance(const std::vector<double>& cells, double d, bool exact_end)
{
    return std::exp(-wavelet_absorbance(cells, d, exact_end));
}

}  // namespace sheer::reference
