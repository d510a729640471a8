// Colours from transmittances: where these are exact, and how they are put together.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "reference/five_layers.h"
#include "reference/methods.h"
#include "reference/moment_sets.h"
#include "reference/moment_transparency.h"
#include "reference/printed.h"

namespace sheer::reference {
namespace {

constexpr Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

const std::vector<Fragment> kColored = {{0.25, 0.5, {1, 0.5, 0}, 1}, {0.75, 0.6, {0, 0.5, 1}, 2}};

TEST(ReferenceMomentTransparency, DepthsByTheirLogarithm)
{
    const double distances[] = {0.1, 1, 10, 100, 1000};
    for (int i = 0; i < 5; ++i) {
        EXPECT_NEAR(log_warp(distances[i], 0.1, 1000), 0.25 * i, 1e-12);
    }
}

TEST(ReferenceMomentTransparency, TrueTransmittancesMakeTrueColors)
{
    for_every_order([](const auto& f) {
        const auto truth = [&](double z) { return true_transmittance(f, z); };
        expect_same(weigh_by_transmittance(f, truth, kBackdrop), composite(f, kBackdrop));
    });
}

TEST(ReferenceMomentTransparency, WithoutTransmittanceItIsWboitWithoutWeights)
{
    const auto one = [](double) { return 1.0; };
    expect_same(weigh_by_transmittance(kFiveLayers, one, kBackdrop),
                wboit(kFiveLayers, WboitWeight::uniform, 0, 0, kBackdrop));
    expect_same(weigh_by_transmittance({}, one, kBackdrop), kBackdrop);
}

TEST(ReferenceMomentTransparency, TwoFragmentsAreExact)
{
    MomentTransparency exactly;
    exactly.bias = {};
    expect_same(moment_transparency(kColored, exactly, kBackdrop), composite(kColored, kBackdrop),
                1e-9);
    // In two passes the farther is occluded twice.
    exactly.passes = 2;
    const auto twice = [&](double z) { return std::pow(true_transmittance(kColored, z), 2); };
    expect_same(moment_transparency(kColored, exactly, kBackdrop),
                weigh_by_transmittance(kColored, twice, kBackdrop), 1e-9);
    // The bias makes a small difference, a quarter of overestimation a large one.
    const Rgba exact = composite(kColored, kBackdrop);
    MomentTransparency how;
    expect_same(moment_transparency(kColored, how, kBackdrop), exact, 1e-4);
    how.beta = 0.25;
    EXPECT_GT(std::abs(moment_transparency(kColored, how, kBackdrop).r - exact.r), 0.01);
}

TEST(ReferenceMomentTransparency, ASecondPassSeesWhatTheFirstLeaves)
{
    MomentTransparency how;
    how.beta = 0.25;
    const auto transmittance_of = [&](const std::vector<Fragment>& fragments) {
        const MomentSums sums = power_moments(fragments, 4, how.most_absorbance);
        return [=](double z) { return power_transmittance(sums, z, how.bias, how.beta); };
    };
    const auto first = transmittance_of(kFiveLayers);
    std::vector<Fragment> left;
    for (const Fragment& f : kFiveLayers) {
        left.push_back({f.depth, f.opacity * first(f.depth), {}, f.id});
    }
    expect_same(moment_transparency(kFiveLayers, how, kBackdrop),
                weigh_by_transmittance(kFiveLayers, first, kBackdrop));
    how.passes = 2;
    const Rgba two = moment_transparency(kFiveLayers, how, kBackdrop);
    const auto second = transmittance_of(left);
    const auto both = [&](double z) { return first(z) * second(z); };
    expect_same(two, weigh_by_transmittance(kFiveLayers, both, kBackdrop));
    // Less is hidden by what is left than by all.
    EXPECT_GT(second(0.9), first(0.9));
    EXPECT_NEAR(two.a, 1 - 0.0672 / 2, 1e-12);
}

}  // namespace
}  // namespace sheer::reference
