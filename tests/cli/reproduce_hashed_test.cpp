// sheer reproduce: the entries of hashed alpha testing, in short, where theory says what they must
// show. Looks and places are fixed, so that each bound either holds or does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cli/quick_entry.h"
#include "cli/run_tool.h"
#include "support/json.h"

namespace sheer::test {
namespace {

// In units of errors that are estimated from 8 or 12 numbers themselves: Student's t with 7 degrees
// of freedom is beyond this once in 1,800 times, so that of 32 such numbers one is once in 60 runs.
constexpr double kLargestZ = 6;

TEST(CliReproduceHashed, OpacityStaysWithDistance)
{
    const Json json = reproduce(Tool(), "hashed-distance");
    ASSERT_EQ(json["tables"].size(), 5u);
    for (std::size_t model = 0; model < 4; ++model) {
        int stayed = 0;
        for (const Json& row : json["tables"][model]["rows"]) {
            const double part = row["of truth"];
            const std::string method = row["method"];
            if (method == "alpha test" && row["pixels"] == 8) {
                EXPECT_LT(part, 0.8) << row;  // three of four texels are absent, or more
            }
            if (method == "stochastic" || method == "hashed") {
                const bool within = std::abs(part - 1) <= 0.02;
                EXPECT_TRUE(within || std::abs(row["z"].get<double>()) < kLargestZ) << row;
                ++stayed;
            }
        }
        EXPECT_EQ(stayed, 2 * 2);
    }
}

TEST(CliReproduceHashed, PartsAreNeeded)
{
    const Json json = reproduce(Tool(), "hashed-parts");
    ASSERT_EQ(json["tables"].size(), 3u);
    double least = 1;
    for (const Json& row : json["tables"][0]["rows"]) {
        EXPECT_LT(std::abs(row["its z"].get<double>()), kLargestZ) << row;
        EXPECT_LT(std::abs(row["z"].get<double>()), kLargestZ) << row;
        least = std::min(least, row["without=uniform"].get<double>());
    }
    EXPECT_LT(least, 0.16);  // 1/8 in the middle of an octave
    for (const Json& row : json["tables"][1]["rows"]) {
        const bool without = row["method"].get<std::string>().ends_with("without=third");
        const double through = row["through both"], error = row["error"];
        if (without) {
            // One threshold for both: half passes neither.
            EXPECT_NEAR(through, 0.5, kLargestZ * error) << row;
        } else if (row["pixels apart"].get<double>() >= 4) {
            EXPECT_NEAR(through, 0.25, kLargestZ * error) << row;
        }
    }
    for (const Json& row : json["tables"][2]["rows"]) {
        EXPECT_LT(row["octaves"], row["without=octaves"]) << row;
        EXPECT_LE(row["without=octaves"].get<double>(),
                  0.5 + kLargestZ * row["error"].get<double>());
    }
}

TEST(CliReproduceHashed, NoiseIsRoundWithASizeForEachAxis)
{
    const Json json = reproduce(Tool(), "hashed-anisotropy");
    for (const Json& row : json["tables"][0]["rows"]) {
        const double shape = row["across / down"], expected = row["1 / cos"];
        if (row["axes"] != "along") continue;
        // Sizes are powers of 2, of which two are mixed: within a factor of 2 of what they should
        // be.
        const bool isotropic = row["variant"] == "isotropic";
        EXPECT_GT(shape, (isotropic ? expected : 1) / 2) << row;
        EXPECT_LT(shape, (isotropic ? expected : 1) * 2) << row;
    }
}

TEST(CliReproduceHashed, HashedPicturesAreStill)
{
    const Json json = reproduce(Tool(), "hashed-stability");
    ASSERT_EQ(json["tables"].size(), 2u);
    EXPECT_EQ(json["tables"][0]["rows"].size(), 4u * 3u);
    for (const Json& row : json["tables"][0]["rows"]) {
        EXPECT_LT(row["hashed"], row["stochastic"]) << row;
    }
}

TEST(CliReproduceHashed, OrdersFlickerLessAndLess)
{
    const Json json = reproduce(Tool(), "hashed-temporal");
    const Json& rows = json["tables"][0]["rows"];
    ASSERT_EQ(rows.size(), 2u * 3u * 3u);
    for (std::size_t i = 0; i < rows.size(); i += 3) {
        EXPECT_GT(rows[i]["opacity 0.500"], rows[i + 1]["opacity 0.500"]);
        EXPECT_GT(rows[i + 1]["opacity 0.250"], rows[i + 2]["opacity 0.250"]);
        for (std::size_t order = i; order < i + 3; ++order) {
            EXPECT_NEAR(rows[order]["opacity 0.250"].get<double>(),
                        rows[order]["opacity 0.750"].get<double>(), 1e-9);
        }
    }
}

// Touched pixels are opaque beyond what is there; an area's part is not, but for what cards of one
// pixel take from one another.
TEST(CliReproduceHashed, SmallCardsAreRasterisedConservatively)
{
    const Json json = reproduce(Tool(), "hashed-figure-4");
    const Json& rows = json["tables"][0]["rows"];
    ASSERT_EQ(rows.size(), 8u);
    EXPECT_LT(rows[0]["of truth"], 0.8);
    EXPECT_NEAR(rows[1]["of truth"].get<double>(), 1, kLargestZ * rows[1]["error"].get<double>());
    EXPECT_GT(rows[2]["of truth"].get<double>(), 1 + kLargestZ * rows[2]["error"].get<double>());
    EXPECT_LT(rows[5]["of truth"], rows[2]["of truth"]);
}

TEST(CliReproduceHashed, AveragesAreNearerToTheTruth)
{
    const Json json = reproduce(Tool(), "hashed-figure-11");
    const Json& rows = json["tables"][0]["rows"];
    ASSERT_EQ(rows.size(), 13u);
    const auto error_of = [&](std::size_t row) {
        return rows[row]["rms error of a pixel"].get<double>();
    };
    EXPECT_LT(error_of(9), 0.7 * error_of(2));    // hashed, with strata
    EXPECT_LT(error_of(12), 0.7 * error_of(10));  // to coverage
    EXPECT_EQ(rows[2]["flicker"], 0);
}

TEST(CliReproduceHashed, NoiseFadesInWithDistance)
{
    const Json json = reproduce(Tool(), "hashed-figure-12");
    const Json& rows = json["tables"][0]["rows"];
    ASSERT_EQ(rows.size(), 2u * 4u);
    // Nearby an alpha test has no holes, a hashed one lets a hundredth through.
    EXPECT_LT(rows[0]["holes within, %"], rows[1]["holes within, %"]);
    EXPECT_LE(rows[2]["holes within, %"], rows[1]["holes within, %"]);
    // Far away an alpha test loses the leaves.
    EXPECT_LT(rows[4]["of blended"], rows[5]["of blended"]);
}

TEST(CliReproduceHashed, CardsOfASceneStay)
{
    const Json json = reproduce(Tool(), "hashed-figure-16");
    const Json& rows = json["tables"][0]["rows"];
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_LT(rows[0]["of truth"], rows[1]["of truth"]);
}

TEST(CliReproduceHashed, RaysHaveTheNoiseOfCells)
{
    const Json json = reproduce(Tool(), "hashed-figure-8");
    ASSERT_EQ(json["tables"].size(), 3u);
    for (const Json& row : json["tables"][0]["rows"]) {
        const double shape = row["across / down"];
        // As of thresholds; random ones have neither width nor height.
        const double expected = row["samples"] == "isotropic" ? row["1 / cos"].get<double>() : 1;
        EXPECT_GT(shape, expected / 2) << row;
        EXPECT_LT(shape, expected * 2) << row;
    }
    for (const Json& row : json["tables"][1]["rows"]) {
        if (row["pixels"] != 0) continue;  // nothing moves: nor do hashed rays
        EXPECT_EQ(row["isotropic"], 0) << row;
        EXPECT_EQ(row["anisotropic"], 0) << row;
        EXPECT_GT(row["random"], 0) << row;
    }
}

TEST(CliReproduceHashed, FoveationKeepsTheFullRateWhereOneLooks)
{
    const Json json = reproduce(Tool(), "hashed-figure-15");
    ASSERT_EQ(json["tables"].size(), 2u);
    ASSERT_EQ(json["tables"][0]["rows"].size(), 4u * 3u * 3u);
    for (const Json& row : json["tables"][0]["rows"]) {
        if (row["zone"] != "full rate") continue;
        EXPECT_EQ(row["foveated"], row["full rate"]) << row;
    }
}

TEST(CliReproduceHashed, CostIsMeasuredInTurns)
{
    const Json json = reproduce(Tool(), "hashed-cost");
    ASSERT_EQ(json["tables"][0]["rows"].size(), 2u);
    for (const Json& row : json["tables"][0]["rows"]) EXPECT_GT(row["hashed"].get<double>(), 0);
    // The medians of table 1's columns, which the paper does not print.
    const double test[] = {.06, .14, .10, .22, .28, .39, 1.05, 1.08, 2.52, 5.19};
    const double hashed[] = {.08, .16, .12, .30, .36, .50, 1.15, 1.22, 2.86, 5.28};
    const double stochastic[] = {.20, .58, .42, .75, .99, 1.69, 4.04, 3.01, 11.42, 7.30};
    const auto expect_median = [&](const Json& claim, const double(&times)[10]) {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < 10; ++i) ratios.push_back(times[i] / test[i]);
        std::sort(ratios.begin(), ratios.end());
        EXPECT_NEAR(claim["paper"].get<double>(), (ratios[4] + ratios[5]) / 2, 0.005);
    };
    ASSERT_EQ(json["claims"].size(), 2u);
    expect_median(json["claims"][0], hashed);
    expect_median(json["claims"][1], stochastic);
}

}  // namespace
}  // namespace sheer::test
