// Trigonometric moments: values known from another program, and few layers.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "reference/moment_sets.h"
#include "reference/printed.h"
#include "reference/trigonometric_moments.h"

namespace sheer::reference {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

double transmittance(const std::vector<Fragment>& fragments, int moments, double z, double epsilon,
                     double beta)
{
    return trigonometric_transmittance(
        trigonometric_moments(fragments, moments, kUnlimited, kWrappingZone), z, epsilon, beta,
        kWrappingZone);
}

TEST(ReferenceTrigonometricMoments, KnownTransmittances)
{
    const struct {
        const std::vector<Fragment>& fragments;
        int moments;
        double z;
        std::string least_opaque, quarter;
    } rows[] = {{kFour, 2, -.25, ".440453", ".345517"},
                {kFour, 3, .25, ".250000", ".210224"},
                {kEight, 2, .125, ".543505", ".465848"},
                {kEight, 3, .125, ".425058", ".378278"},
                {kEight, 4, .125, ".473129", ".430897"}};
    for (const auto& row : rows) {
        SCOPED_TRACE(testing::Message() << row.fragments.size() << " " << row.moments);
        const double epsilon = trigonometric_bias(row.moments, MomentFormat::fp32);
        expect_printed(transmittance(row.fragments, row.moments, row.z, epsilon, 0),
                       row.least_opaque);
        expect_printed(transmittance(row.fragments, row.moments, row.z, epsilon, .25), row.quarter);
    }
}

TEST(ReferenceTrigonometricMoments, TheWrappingZone)
{
    expect_printed(kWrappingZone, ".314159265");
    expect_printed(phase_angle(0, kWrappingZone), "2.984513021");
    EXPECT_EQ(phase_angle(-1, kWrappingZone), 0);
    EXPECT_NEAR(phase_angle(1, kWrappingZone), 2 * std::numbers::pi - kWrappingZone, 1e-15);
    const double begin = circle_parameter(std::polar(1.0, -kWrappingZone));
    expect_printed(1 / (7 - begin), "2.793604493");
    expect_printed(1 - 7 / (7 - begin), "-18.555231453");
    double before = -1;
    for (int i = 1; i < 100; ++i) {
        const double t = circle_parameter(std::polar(1.0, 2 * std::numbers::pi * i / 100));
        EXPECT_GT(t, before);
        before = t;
    }
    EXPECT_LT(before, 7);
}

// Moments of m layers leave no other measure, but for a bias of which the square root counts.
TEST(ReferenceTrigonometricMoments, FewLayersAreExact)
{
    const std::vector<Fragment>* lists[] = {&kTwo, &kThree, &kFour};
    for (const int moments : {2, 3, 4}) {
        const std::vector<Fragment>& fragments = *lists[moments - 2];
        for (const double z : {-0.95, -0.4, 0.1, 0.6, 0.95}) {
            EXPECT_NEAR(transmittance(fragments, moments, z, 1e-12, 0),
                        true_transmittance(fragments, z), 1e-4);
        }
    }
}

TEST(ReferenceTrigonometricMoments, NothingLetsEverythingThrough)
{
    EXPECT_EQ(transmittance({}, 3, 0, 8e-7, 0.25), 1);
}

}  // namespace
}  // namespace sheer::reference
