// sheer transmittance: what it writes of layers that are known, and what it refuses.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"
#include "support/json.h"
#include "support/test_folder.h"

namespace sheer::test {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kLayers = "builtin:layers?alpha=0.5,0.25&depth=1,2";

Words words(Words more)
{
    Words all = {"transmittance", kLayers, "--size", "16x16"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

// Layers at 1 and 2 m: 1, behind the first 0.5, behind both 0.375.
TEST(Transmittance, WritesAllNumbers)
{
    const Tool tool;
    const Outcome outcome = tool.run(words({"--pixel", "3,12", "-o", "t.json", "--samples", "4",
                                            "--methods", "adaptive,moment:overestimation=0"}));
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "t.json: pixel 3,12, 2 fragments, 2 methods\n");
    const Json json = parse_json(text_of(tool.file("t.json")));
    EXPECT_EQ(json.at("scene"), kLayers);
    EXPECT_EQ(json.at("pixel"), Json({3, 12}));
    EXPECT_EQ(json.at("samples"), 4);
    ASSERT_EQ(json.at("fragments").size(), 2u);
    EXPECT_NEAR(json.at("fragments")[1].at("distance").get<double>(), 2, 1e-5);
    EXPECT_EQ(json.at("fragments")[1].at("opacity"), 0.25);
    EXPECT_EQ(json.at("fragments")[1].at("coverage"), 1);
    // At each sample a layer's depth is a plane's, with its own rounding.
    ASSERT_GE(json.at("steps").size(), 2u);
    EXPECT_EQ(json.at("steps").back().at("behind"), 0.375);
    const auto distances = json.at("distances").get<std::vector<double>>();
    const auto truth = json.at("true").get<std::vector<double>>();
    ASSERT_EQ(json.at("methods").size(), 2u);
    EXPECT_EQ(json.at("methods")[1].at("method"), "moment:overestimation=0");
    const auto adaptive = json.at("methods")[0].at("transmittance").get<std::vector<double>>();
    const auto moment = json.at("methods")[1].at("transmittance").get<std::vector<double>>();
    ASSERT_EQ(truth.size(), distances.size());
    ASSERT_EQ(moment.size(), distances.size());
    ASSERT_EQ(adaptive.size(), distances.size());
    EXPECT_LT(distances.front(), 1);
    EXPECT_GT(distances.back(), 2);
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const double z = distances[i];
        if (std::abs(z - 1) < 1e-4 || std::abs(z - 2) < 1e-4) continue;
        const double expected = z < 1 ? 1 : z < 2 ? 0.5 : 0.375;
        EXPECT_EQ(truth[i], expected) << z;
        EXPECT_NEAR(adaptive[i], expected, 1e-6) << z;
        // The bias of two layers so far apart; nobody is behind the last, where moments do not
        // look.
        if (z > 1.05 && z < 1.9) {
            EXPECT_NEAR(moment[i], expected, 1e-3) << z;
        }
    }
}

TEST(Transmittance, DrawsAChart)
{
    const Tool tool;
    const Outcome outcome = tool.run(words({"--pixel", "3,12", "-o", "t.svg"}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string svg = text_of(tool.file("t.svg"));
    EXPECT_EQ(svg.find("<svg"), 0u);
    for (const char* text : {">true<", ">moment<", ">mboit<", ">fourier<", ">wavelet<",
                             ">adaptive<", ">deep-shadow-map<", "distance from the eye, m",
                             "Pixel 3,12 of builtin:layers?alpha=0.5,0.25&amp;depth=1,2"}) {
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    }
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_LT(svg.size(), 60000u);
}

TEST(Transmittance, RefusesInOneLine)
{
    const Tool tool;
    const struct {
        Words words;
        const char* line;
    } kRefused[] = {
        {{"--pixel", "16,0", "-o", "t.svg"}, "--pixel: 16,0 is outside of 16x16"},
        {{"--pixel", "3", "-o", "t.svg"}, "--pixel: '3' is no pixel X,Y"},
        {{"--pixel", "3,-1", "-o", "t.svg"},
         "--pixel: '-1' is not a whole number from 0 to 1048576"},
        {{"--pixel", "3,4", "-o", "t.png"}, "t.png: the name must end in .svg or .json"},
        {{"--pixel", "3,4", "-o", "t.svg", "--methods", "wboit"},
         "--methods: 'wboit' keeps no function of depth; these do: "},
        {{"--pixel", "3,4", "-o", "t.svg", "--methods", "moments"}, "--methods: "},
        {{"--pixel", "3,4", "-o", "none/t.svg"}, "none/t.svg: "},
        {{"--pixel", "3,4", "-o", "t.svg", "--samples", "3"}, "--samples: "},
    };
    for (const auto& refused : kRefused) {
        const Outcome outcome = tool.run(words(refused.words));
        EXPECT_EQ(outcome.exit_code, 2) << refused.line;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.find(std::string("sheer: ") + refused.line), 0u) << outcome.err;
        EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    }
    const Outcome nothing = tool.run(
        {"transmittance", "builtin:motor", "--size", "16x16", "--pixel", "0,0", "-o", "t.svg"});
    EXPECT_EQ(nothing.exit_code, 2);
    EXPECT_EQ(nothing.err, "sheer: --pixel: there is nothing transparent in pixel 0,0\n");
    EXPECT_EQ(tool.folder().entries(), 0);
}

}  // namespace
}  // namespace sheer::test
