// Tracked masks under every estimator of stochastic transparency: against the oracle, sample by
// sample, and against stratified-stochastic, which is their basic method.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "methods/make_lists.h"
#include "methods/rounding.h"
#include "methods/stochastic_settings.h"
#include "methods/stratified_oracle.h"
#include "reference/owned_samples.h"
#include "simd_levels.h"

namespace sheer::test {
namespace {

// An odd number between the keys of passes that are independent (docs/numerics.md).
constexpr std::uint32_t kPassesApart = 0x632be5abu;

// Of a pixel, pass after pass.
using Owners = std::vector<std::vector<int>>;

Owners owners_of_passes(const FragmentLists& lists, const ChosenMethod& method, std::uint32_t pixel)
{
    const StochasticSettings settings = stochastic_settings(method);
    const StratifiedSettings masks = stratified_settings(method);
    Owners owners;
    for (std::uint32_t pass = 0; pass < static_cast<std::uint32_t>(settings.passes); ++pass) {
        const std::uint32_t key = lists.place.key + (settings.joint ? 0 : pass * kPassesApart);
        const auto count = std::bit_ceil(static_cast<std::uint32_t>(settings.passes));
        const SequencePart part = settings.joint ? SequencePart{pass, count} : SequencePart{};
        owners.push_back(owners_by_oracle(lists, masks, pixel, key, part));
    }
    return owners;
}

// Red, green, blue and alpha of a sample over `behind`, in doubles.
std::array<double, 4> sample_by_oracle(const std::vector<reference::PixelFragment>& fragments,
                                       const Owners& owners, std::size_t s,
                                       const ChosenMethod& method,
                                       const std::array<double, 4>& behind)
{
    const bool corrects = method.value("correction") == "on";
    const bool depth_based = method.value("depth-based") == "on";
    reference::SampleSum sum;
    for (const std::vector<int>& of_pass : owners) {
        const reference::SampleSum more = depth_based
                                              ? reference::seen_sum(fragments, of_pass[s], s)
                                              : reference::owned_sum(fragments, of_pass[s]);
        for (std::size_t c = 0; c < 3; ++c) sum.color[c] += more.color[c];
        sum.weight += more.weight;
    }
    const auto passes = static_cast<double>(owners.size());
    const double total = reference::total_transmittance(fragments, s);
    const double through = corrects || depth_based ? total : 1 - sum.weight / passes;
    const double scale = !corrects ? 1 / passes : sum.weight > 0 ? (1 - total) / sum.weight : 0.0;
    std::array<double, 4> result = {};
    for (std::size_t c = 0; c < 3; ++c) result[c] = scale * sum.color[c] + through * behind[c];
    result[3] = 1 - through * (1 - behind[3]);
    return result;
}

void expect_oracles_picture(const FragmentLists& lists, const std::string& text)
{
    const ChosenMethod method = choose_method(text);
    const Words words = resolved_by_store(lists, text, targets_of(Simd::best));
    const SampleColors backdrop = make_backdrop(lists.set.count);
    double worst = 0;  // in bounds
    for (std::uint32_t pixel = 0; pixel < kTilePixels; ++pixel) {
        const auto fragments = fragments_of_pixel(lists, pixel);
        const Owners owners = owners_of_passes(lists, method, pixel);
        double most = 1;
        for (const auto& f : fragments) {
            most = std::max({most, f.color[0], f.color[1], f.color[2]});
        }
        const double bound = most * rounding_bound(method, fragments.size()).as_formula + kUnit;
        for (std::size_t s = 0; s < lists.samples(); ++s) {
            std::array<double, 4> behind;
            for (std::size_t c = 0; c < 4; ++c) {
                behind[c] = static_cast<double>(backdrop.channel(pixel, c)[s]);
            }
            const auto expected = sample_by_oracle(fragments, owners, s, method, behind);
            for (std::size_t c = 0; c < 4; ++c) {
                const std::uint32_t word = words[(4 * pixel + c) * lists.samples() + s];
                const double off = static_cast<double>(std::bit_cast<float>(word)) - expected[c];
                worst = std::max(worst, std::abs(off) / bound);
            }
        }
    }
    EXPECT_LE(worst, 1) << text << " on " << lists.name;
}

constexpr const char* kEstimators[] = {
    "",
    ":correction=on",
    ":depth-based=on",
    ":depth-based=on:correction=on",
    ":sample-passes=3",
    ":sample-passes=2:pass-masks=independent:correction=on",
    ":depth-based=on:sample-passes=2",
    ":depth-based=on:correction=on:sample-passes=3:pass-masks=independent",
};

TEST(TrackedMasks, ShowWhatTheOracleDoesUnderEveryEstimator)
{
    for (const int samples : {1, 4, 8, 16, 64}) {
        for (const FragmentLists& lists : random_lists(samples)) {
            for (const char* masks : {"stochastic:masks=tracked", "stochastic:masks=systematic"}) {
                for (const char* estimator : kEstimators) {
                    expect_oracles_picture(lists, std::string(masks) + estimator);
                }
            }
        }
    }
}

TEST(TrackedMasks, ShowWhatTheOracleDoesOnARealTile)
{
    const FragmentLists lists = lists_of_fullest_tile(load("builtin:motor"), "motor", 8);
    for (const char* estimator : kEstimators) {
        expect_oracles_picture(lists, std::string("stochastic:masks=tracked") + estimator);
    }
}

// A sample's owner that is one fragment off is a difference which the bound does not hide.
TEST(TrackedMasks, TheOracleTellsOneMaskFromAnother)
{
    const std::vector<FragmentLists> all = random_lists(8);
    const FragmentLists& lists = all[0];
    for (const char* estimator : {"", ":correction=on", ":depth-based=on"}) {
        const auto drawn = [&](const char* masks) {
            return resolved_by_store(lists, std::string("stochastic:masks=") + masks + estimator,
                                     targets_of(Simd::best));
        };
        EXPECT_NE(drawn("tracked"), drawn("systematic"));
        EXPECT_NE(drawn("tracked"), drawn("stratified"));
    }
}

void expect_same_store(const FragmentLists& lists)
{
    for (const Simd level : simd_levels()) {
        const auto drawn = [&](const char* text) {
            return resolved_by_store(lists, text, targets_of(level));
        };
        EXPECT_EQ(difference(drawn("stochastic:masks=tracked"), drawn("stratified-stochastic")), "")
            << lists.name;
        EXPECT_EQ(difference(drawn("stochastic:masks=systematic"),
                             drawn("stratified-stochastic:sequence=systematic")),
                  "")
            << lists.name;
    }
}

TEST(TrackedMasks, OfTheBasicMethodAreStratifiedStochastic)
{
    for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
        for (const FragmentLists& lists : random_lists(samples)) expect_same_store(lists);
    }
    expect_same_store(lists_of_fullest_tile(load("builtin:motor"), "motor", 16));
}

TEST(TrackedMasks, OfTheBasicMethodMakeItsPicture)
{
    const Scene scene = load("builtin:quads");
    View view;
    view.width = 80;
    view.height = 70;
    for (const int samples : {1, 8, 64}) {
        for (const int frames : {1, 3}) {
            view.samples = samples;
            Options options;
            options.accumulate = frames;
            options.method = "stratified-stochastic";
            const Image expected = render(scene, view, options).image;
            options.method = "stochastic:masks=tracked";
            EXPECT_EQ(render(scene, view, options).image.pixels, expected.pixels);
        }
    }
}

TEST(TrackedMasks, SayWhatDoesNotGoWithThem)
{
    const auto said = [](const std::string& parameters, int samples) -> std::string {
        try {
            check_method(choose_method("stochastic:masks=tracked:" + parameters), samples);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(said("round=tile-dither", 8).find("round=tile-dither is for"), std::string::npos);
    EXPECT_NE(said("seed-by=object", 8).find("seed-by is not for"), std::string::npos);
    EXPECT_NE(said("depth-test=before", 8).find("depth-test is not for"), std::string::npos);
    EXPECT_EQ(said("sample-passes=16", 64), "");
    EXPECT_EQ(said("depth-based=on:correction=on", 8), "");
}

}  // namespace
}  // namespace sheer::test
