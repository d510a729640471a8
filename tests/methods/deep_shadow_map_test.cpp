// Curves of visibility: their text in doubles against the oracle's, what their error means for a
// picture, and what coincides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "methods/make_lists.h"
#include "methods/texts_alone.h"
#include "methods/tile_fixture.h"
#include "reference/deep_shadow.h"

namespace sheer::test {
namespace {

using reference::CurveResolve;
using reference::Fragment;
using reference::Rgba;

std::vector<Fragment> fragments_of(const FragmentLists& lists, std::size_t pixel, std::size_t s)
{
    std::vector<Fragment> fragments;
    for (std::size_t i = lists.first[pixel]; i < lists.first[pixel + 1]; ++i) {
        if (!lists.covers(i, s)) continue;
        const ListedFragment& f = lists.fragments[i];
        Fragment fragment{
            static_cast<double>(lists.depth_at(i, s)),
            static_cast<double>(f.opacity),
            {static_cast<double>(f.red), static_cast<double>(f.green), static_cast<double>(f.blue)},
            f.primitive};
        fragments.push_back(fragment);
    }
    return fragments;
}

std::string method_of(const char* error, bool corrects)
{
    return std::string("deep-shadow-map:error=") + error +
           ":correction=" + (corrects ? "on" : "off");
}

// The largest distance of the text, in doubles, from the oracle.
double largest_difference_from_oracle(const FragmentLists& lists, const std::string& method)
{
    const DeepShadowSettings settings = deep_shadow_settings(choose_method(method));
    const auto resolve = settings.corrects ? CurveResolve::corrected : CurveResolve::total;
    const auto made = make_alone<Lone<double>>(lists, method);
    const SampleColors backdrop = make_backdrop(lists.set.count);
    double most = 0;
    for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
        for (std::size_t s = 0; s < lists.samples(); ++s) {
            const auto fragments = fragments_of(lists, pixel, s);
            const auto behind = [&](std::size_t c) {
                return static_cast<double>(backdrop.channel(pixel, c)[s]);
            };
            const auto curve = reference::compressed(reference::step_curve(fragments),
                                                     static_cast<double>(settings.error));
            const Rgba color = reference::through_curve(
                fragments, curve, resolve, {behind(0), behind(1), behind(2), behind(3)});
            const double expected[] = {color.r, color.g, color.b};
            for (std::size_t c = 0; c < 3; ++c) {
                const double got = made.colors[(4 * pixel + c) * lists.samples() + s];
                most = std::max(most, std::abs(got - expected[c]));
            }
        }
    }
    return most;
}

// Rounding of 2^-53 may grow with each line, by the ratio of its length to that of the part of it
// which decides its slope; 10^6 of it leave room for that.
TEST(DeepShadowMap, TextIsTheOracles)
{
    for (const FragmentLists& lists : random_lists(4)) {
        for (const char* error : {"0", "0.002", "0.01", "0.05"}) {
            for (const bool corrects : {false, true}) {
                EXPECT_LT(largest_difference_from_oracle(lists, method_of(error, corrects)), 1e-10)
                    << lists.name << ", error " << error;
            }
        }
    }
}

// A sample's, on average.
double mean_vertices(const char* error)
{
    const std::vector<FragmentLists> all = random_lists(4);
    const FragmentLists& lists = all[0];
    const auto made = make_alone<Lone<float>>(lists, method_of(error, true));
    double sum = 0;
    for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
        for (std::size_t s = 0; s < 4; ++s) {
            sum += static_cast<double>(made.kept[(5 * pixel + 4) * 4 + s]);
        }
    }
    return sum / (4.0 * kTilePixels);
}

TEST(DeepShadowMap, ALargerErrorTakesFewerVertices)
{
    const double exact = mean_vertices("0"), fine = mean_vertices("0.002");
    const double coarse = mean_vertices("0.05");
    EXPECT_LT(fine, exact);
    EXPECT_LT(coarse, fine);
}

// Uncorrected, the sum over a c V is off by error times the sum over a c.
TEST(DeepShadowMap, TheErrorBoundsThePicture)
{
    const SampleSet& set = sample_sets()[3];
    for (const char* error : {"0.002", "0.01", "0.05"}) {
        std::mt19937 random(5);
        Plates plates = RandomPlates{set, random}.make(60);
        for (Plate& plate : plates) plate.color[3] *= plate.color[3] * 0.3f;
        const Colors backdrop(4 * kTilePixels * 8);
        const Colors exact =
            resolve_plates({choose_method(method_of("0", false)), &set}, plates, backdrop);
        const Colors got =
            resolve_plates({choose_method(method_of(error, false)), &set}, plates, backdrop);
        double used = 0;
        for (std::size_t pixel = 0; pixel < kUsedPixels; ++pixel) {
            for (std::size_t s = 0; s < 8; ++s) {
                double sum = 0;
                for (const Fragment& f : fragments_at(plates, set, pixel, s)) {
                    sum += f.opacity * f.color[0];
                }
                const std::size_t at = color_index(set, tile_pixel(pixel), s, 0);
                const double off =
                    std::abs(static_cast<double>(got[at]) - static_cast<double>(exact[at]));
                // And two sums of 60 terms below 1.
                EXPECT_LE(off, std::stod(error) * sum + 2 * 60 * 3 * 0x1p-24) << error;
                used = std::max(used, off / (std::stod(error) * sum));
            }
        }
        EXPECT_GT(used, 0.05) << error;
    }
}

// They do not hide one another: each counts alike, whoever came first.
TEST(DeepShadowMap, WhatCoincidesSharesWhatItCovers)
{
    const SampleSet& set = sample_sets()[0];
    const auto plate = [](std::uint32_t number, Float4 color) {
        Plate p{make_plane(1, 0, 0), number, 0, {}, color};
        p.samples[0] = 1;
        return p;
    };
    const Plates plates = {plate(1, {1, 0, 0, 0.5f}), plate(2, {0, 0, 1, 0.5f})};
    const Colors black(4 * kTilePixels);
    for (const bool corrects : {true, false}) {
        for (const Plates& order : {plates, Plates(plates.rbegin(), plates.rend())}) {
            const Colors got =
                resolve_plates({choose_method(method_of("0", corrects)), &set}, order, black);
            EXPECT_FLOAT_EQ(got[0], corrects ? 0.375f : 0.5f);
            EXPECT_FLOAT_EQ(got[2], corrects ? 0.375f : 0.5f);
            EXPECT_FLOAT_EQ(got[3], 0.75f);
        }
    }
}

}  // namespace
}  // namespace sheer::test
