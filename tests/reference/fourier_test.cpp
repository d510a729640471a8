// A Fourier series of absorbance: numbers known from another program.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "reference/fourier.h"
#include "reference/moment_sets.h"
#include "reference/printed.h"

namespace sheer::reference {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
const auto kLayers = at_depths({{.25, .5}, {.5, .4}, {.75, .3}});

TEST(ReferenceFourier, ThreeLayers)
{
    const FourierSums sums = fourier_sums(kLayers, 3, kUnlimited);
    const std::string a[] = {"3.121295", "-1.021651", "-1.077993", "-1.021651"};
    const std::string b[] = {"0.000000", ".672944", "0.000000", "-.672944"};
    for (std::size_t k = 0; k < 4; ++k) {
        expect_printed(sums.a[k], a[k]);
        expect_printed(sums.b[k], b[k]);
    }
    const std::pair<double, std::string> rows[] = {
        {0, "1.000000"},   {.1, "1.103979"}, {.25, ".702463"}, {.375, ".501524"}, {.5, ".397275"},
        {.625, ".296621"}, {.75, ".259166"}, {.9, ".200486"},  {1, ".210000"}};
    for (const auto& [d, printed] : rows) {
        expect_printed(fourier_transmittance(sums, d, false), printed);
    }
    const FourierSums more = fourier_sums(kLayers, 7, kUnlimited);
    expect_printed(fourier_transmittance(more, .1, false), ".964843");
    expect_printed(fourier_transmittance(more, .375, false), ".506068");
    expect_printed(fourier_transmittance(more, .625, false), ".305859");
}

TEST(ReferenceFourier, LanczosTakesTheLastTermAway)
{
    // Of one term nothing but the straight line is left.
    const FourierSums one = fourier_sums(kLayers, 1, kUnlimited);
    EXPECT_NEAR(fourier_absorbance(one, .3, true), one.a[0] / 2 * .3, 1e-12);
    // Of two, the first times sin(pi / 2) / (pi / 2).
    const FourierSums two = fourier_sums(kLayers, 2, kUnlimited);
    const double line = two.a[0] / 2 * .3;
    EXPECT_NEAR(fourier_absorbance(two, .3, true) - line,
                (fourier_absorbance(one, .3, false) - line) * 2 / std::numbers::pi, 1e-12);
    // It rings less, and is exact at the end as before.
    const FourierSums sums = fourier_sums(kLayers, 3, kUnlimited);
    EXPECT_LT(std::abs(fourier_transmittance(sums, .1, true) - 1),
              std::abs(fourier_transmittance(sums, .1, false) - 1));
    EXPECT_NEAR(fourier_transmittance(sums, 1, true), .21, 1e-12);
}

}  // namespace
}  // namespace sheer::reference
