// A Haar series of absorbance: numbers known from another program, and the means that it stands
// for.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "reference/moment_sets.h"
#include "reference/printed.h"
#include "reference/random_fragments.h"
#include "reference/wavelet.h"

namespace sheer::reference {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
const auto kLayers = at_depths({{.1, .3}, {.35, .5}, {.6, .4}, {.9, .7}});

TEST(ReferenceWavelet, OneLayerHalfWay)
{
    const auto one = at_depths({{.5, 1 - std::exp(-1.0)}});
    const auto coefficients = wavelet_coefficients(one, 3, kUnlimited);
    ASSERT_EQ(coefficients.size(), 16u);
    const std::pair<std::size_t, std::string> rows[] = {
        {0, ".46875"}, {1, ".044194"}, {4, ".0625"}, {10, ".088388"}, {15, ".53125"}};
    std::vector<double> rest = coefficients;
    for (const auto& [i, printed] : rows) {
        expect_printed(coefficients[i], printed);
        rest[i] = 0;
    }
    for (const double c : rest) EXPECT_NEAR(c, 0, 1e-15);
    const auto cells = wavelet_cells(coefficients);
    for (std::size_t j = 0; j < 16; ++j) {
        EXPECT_NEAR(cells[j], j < 7 ? 0 : j == 7 ? 0.5 : 1, 1e-14);
    }
}

TEST(ReferenceWavelet, FourLayers)
{
    const auto fine = wavelet_cells(wavelet_coefficients(kLayers, 3, kUnlimited));
    const std::pair<double, std::string> rows[] = {
        {.1, ".914691"}, {.2, ".700000"},  {.35, ".614688"}, {.5, ".350000"},
        {.6, ".350000"}, {.75, ".210000"}, {.9, ".155417"},  {1, ".063000"}};
    for (const auto& [d, printed] : rows) {
        expect_printed(wavelet_transmittance(fine, d, false), printed);
    }
    const auto coarse = wavelet_cells(wavelet_coefficients(kLayers, 2, kUnlimited));
    expect_printed(wavelet_transmittance(coarse, .2, false), ".813124");
    expect_printed(wavelet_transmittance(coarse, .5, false), ".409072");
    expect_printed(wavelet_transmittance(coarse, 1, false), ".090407");
    EXPECT_NEAR(wavelet_transmittance(coarse, 1, true), 0.063, 1e-12);
    expect_printed(coarse.back(), "2.764621");
}

TEST(ReferenceWavelet, TheSeriesIsTheMeansOfCells)
{
    RandomFragments random(1);
    for (int round = 0; round < 30; ++round) {
        const auto fragments = random.list(1 + random.below(30));
        for (const int rank : {0, 2, 3, 4}) {
            const auto cells = wavelet_cells(wavelet_coefficients(fragments, rank, 10));
            const auto means = cell_means(fragments, rank, 10);
            ASSERT_EQ(cells.size(), std::size_t{2} << rank);
            for (std::size_t j = 0; j < cells.size(); ++j) {
                EXPECT_NEAR(cells[j], means[j], 1e-12);
                EXPECT_GE(means[j], j > 0 ? means[j - 1] : 0);
            }
        }
    }
}

}  // namespace
}  // namespace sheer::reference
