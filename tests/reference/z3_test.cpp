// Z3: five layers in every order against errors known from elsewhere, and pixels worked out by
// hand.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "reference/five_layers.h"
#include "reference/printed.h"
#include "reference/z3.h"

namespace sheer::reference {
namespace {

constexpr Rgba kBackdrop = {0.1, 0.2, 0.3, 0.5};

TEST(ReferenceZ3, FiveLayersInEveryOrder)
{
    const Spread two = spread_of([](const auto& f) { return z3(f, 2, Z3Depth::mean, {}); });
    expect_printed(two.mean, ".0073");
    expect_printed(two.most, ".0490");
    // At the nearer's place it is another method.
    const Spread front = spread_of([](const auto& f) { return z3(f, 2, Z3Depth::front, {}); });
    EXPECT_GT(front.mean, 1.5 * two.mean);
    for (const int layers : {3, 4, 5}) {
        for_every_order([&](const auto& f) {
            for (const Z3Depth depth : {Z3Depth::mean, Z3Depth::front}) {
                expect_same(z3(f, layers, depth, kBackdrop), composite(f, kBackdrop));
            }
        });
    }
}

TEST(ReferenceZ3, WhatPassesIsAlwaysExact)
{
    for_every_order([](const auto& f) {
        EXPECT_NEAR(z3(f, 1, Z3Depth::mean, {}).a, 1 - 0.0672, 1e-12);
        EXPECT_NEAR(z3(f, 2, Z3Depth::mean, {}).a, 1 - 0.0672, 1e-12);
    });
}

TEST(ReferenceZ3, ALayerGoesBetweenWhereTheMeanSays)
{
    // Red at 1 and green at 2 are joined at 1.5; blue at 1.4 is in front of both.
    const std::vector<Fragment> fragments = {{1, 0.5, {1, 0, 0}, 1},
                                             {2, 0.5, {0, 1, 0}, 2},
                                             {4, 0.5, {0, 0, 0}, 3},
                                             {1.4, 0.5, {0, 0, 1}, 4}};
    const std::vector<Fragment> first(fragments.begin(), fragments.begin() + 3);
    expect_same(z3(first, 2, Z3Depth::mean, {}), {0.5, 0.25, 0, 0.875});
    expect_same(z3(fragments, 3, Z3Depth::mean, {}), {0.5, 0.125, 0.25, 0.9375});  // 1, 1.4: joined
    expect_same(z3(fragments, 2, Z3Depth::mean, {}), {0.25, 0.125, 0.5, 0.9375});
    expect_same(z3(fragments, 2, Z3Depth::front, {}), {0.5, 0.25, 0.125, 0.9375});
}

const std::vector<SamplePoint> kFourSamples = sample_pattern(4, SamplePositions::standard);
constexpr std::uint64_t kAll = 0b1111;

TEST(ReferenceZ3Pixel, WithoutSlopesEverySampleIsTheSame)
{
    for_every_order([](const auto& f) {
        std::vector<SlopedFragment> flat;
        for (const Fragment& fragment : f) flat.push_back({fragment, 0, 0, kAll});
        for (const int layers : {1, 2, 5}) {
            expect_same(z3_pixel(flat, layers, Z3Depth::mean, kFourSamples, kBackdrop),
                        z3(f, layers, Z3Depth::mean, kBackdrop));
        }
    });
}

TEST(ReferenceZ3Pixel, SlopesLetSurfacesPassThroughEachOther)
{
    // Two opaque planes that cross along the pixel's middle: red is in front on the left.
    const std::vector<SlopedFragment> planes = {{{1, 1, {1, 0, 0}, 1}, 1, 0, kAll},
                                                {{1, 1, {0, 0, 1}, 2}, -1, 0, kAll}};
    expect_same(z3_pixel(planes, 2, Z3Depth::mean, kFourSamples, {}), {0.5, 0, 0.5, 1});
    // Samples 0 and 2 are on the left.
    auto left = planes;
    for (SlopedFragment& plane : left) plane.mask = 0b0101;
    expect_same(z3_pixel(left, 2, Z3Depth::mean, kFourSamples, {}), {0.5, 0, 0, 0.5});
    // Joined, the one with the smaller id is in front everywhere.
    expect_same(z3_pixel(planes, 1, Z3Depth::mean, kFourSamples, {}), {1, 0, 0, 1});
}

TEST(ReferenceZ3Pixel, JoinedSlopesAreTheirMean)
{
    // Red and green are joined and have a slope of 1. With red's of 2 it would be in front of blue
    // everywhere, with green's in two samples.
    const std::vector<SlopedFragment> planes = {{{1, 1, {1, 0, 0}, 1}, 2, 0, kAll},
                                                {{1, 1, {0, 1, 0}, 2}, 0, 0, kAll},
                                                {{9, 1, {0, 0, 1}, 3}, 0, 0, kAll}};
    auto joined = planes;
    joined[2] = {{1.125, 1, {0, 0, 1}, 3}, 2, 0, kAll};
    // Depths at x = -.375, -.125, .125 and .375: .625, .875, 1.125, 1.375, and blue's .375, .875,
    // 1.375, 1.875. The tie goes to the smaller id.
    expect_same(z3_pixel(joined, 2, Z3Depth::mean, kFourSamples, {}), {0.75, 0, 0.25, 1});
    expect_same(z3_pixel(planes, 2, Z3Depth::mean, kFourSamples, {}), {1, 0, 0, 1});
}

TEST(ReferenceZ3Pixel, JoinedMasksCoverWhatBothDid)
{
    // Red on two samples, blue behind it on one of these and another: of three samples one is red
    // over blue, one red, one blue.
    const std::vector<SlopedFragment> parts = {{{1, 0.5, {1, 0, 0}, 1}, 0, 0, 0b0011},
                                               {{2, 0.5, {0, 0, 1}, 2}, 0, 0, 0b0110}};
    const Rgba apart = z3_pixel(parts, 2, Z3Depth::mean, kFourSamples, {});
    expect_same(apart, {0.25, 0, 0.1875, 0.4375});
    expect_same(z3_pixel(parts, 1, Z3Depth::mean, kFourSamples, {}), apart);
}

}  // namespace
}  // namespace sheer::reference
