// sheer compare --frames.
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"
#include "support/json.h"

namespace sheer::test {
namespace {

using Words = std::vector<std::string>;

class CompareFilmTest : public testing::Test {
protected:
    Json compare(const Words& added) const
    {
        Words words = {"compare", "--size", "32x24", "--samples", "1", "-o", "out"};
        words.insert(words.begin() + 1, added.begin(), added.end());
        const Outcome outcome = tool_.run(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return parse_json(text_of(tool_.file("out/metrics.json"))).at("results");
    }

    Tool tool_;
};

TEST_F(CompareFilmTest, WhereNothingMovesOnlyNoiseFlickers)
{
    const Json rows =
        compare({"builtin:layers", "--frames", "3..7", "--seeds", "16", "--methods",
                 "exact,hashed-alpha-test,stochastic,hashed-alpha-test:frames=offsets"});
    for (const Json& row : rows) EXPECT_EQ(row.at("ghosting"), 0.0);
    EXPECT_EQ(rows[0].at("flicker"), 0.0);
    EXPECT_EQ(rows[1].at("flicker"), 0.0);
    EXPECT_GT(rows[1].at("rmse_frames"), 10.0);
    // Independent frames differ by twice their variance. 32x24 pixels times 16 seeds or 4 changes
    // have deviations of the mean square below sqrt(4 / 3072), 3.6 % of it, half of it of the root.
    const double noise = rows[2].at("noise"), flicker = rows[2].at("flicker");
    EXPECT_NEAR(flicker / (std::sqrt(2.0) * noise), 1, 6 * 0.036);
    EXPECT_GT(rows[3].at("flicker"), 10.0);
    const std::string csv = text_of(tool_.file("out/metrics.csv"));
    EXPECT_NE(csv.substr(0, csv.find('\n')).find(",rmse_frames,flicker,ghosting,"),
              std::string::npos);
}

TEST_F(CompareFilmTest, AveragesOfMovingFramesLeaveGhosts)
{
    const Words film = {"builtin:layers?alpha=1",
                        "--frames",
                        "0..5",
                        "--orbit",
                        "40",
                        "--eye",
                        "1,0,3",
                        "--target",
                        "0.5,0.5,0",
                        "--methods",
                        "exact"};
    const Json plain = compare(film)[0];
    Words averaged = film;
    averaged.insert(averaged.end(), {"--taa", "0.2"});
    const Json ghosts = compare(averaged)[0];
    EXPECT_GT(ghosts.at("ghosting").get<double>(), 5 * plain.at("ghosting").get<double>());
    // The average's error is mostly that.
    EXPECT_GT(ghosts.at("ghosting").get<double>(), 0.5 * ghosts.at("rmse_frames").get<double>());
    EXPECT_TRUE(std::filesystem::exists(tool_.file("out/exact.s1.last.exr")));
    EXPECT_EQ(ghosts.at("rmse"), plain.at("rmse")) << "of the last frame alone";
}

TEST_F(CompareFilmTest, WithoutFramesThereIsNothingToSay)
{
    const Json rows = compare({"builtin:layers", "--methods", "blend"});
    EXPECT_TRUE(rows[0].at("flicker").is_null());
    EXPECT_TRUE(rows[0].at("ghosting").is_null());
    EXPECT_TRUE(rows[0].at("rmse_frames").is_null());
}

}  // namespace
}  // namespace sheer::test
