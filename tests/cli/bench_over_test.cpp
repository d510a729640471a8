// `bench --over`: what its JSON and its table hold, and what it refuses. Times are not looked at.
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"
#include "support/json.h"

namespace sheer::test {
namespace {

using Words = std::vector<std::string>;

Words bench_words(const Words& added)
{
    Words words = {"bench", "builtin:layers?n=3", "--methods", "blend,exact", "--repeat", "1"};
    words.insert(words.end(), added.begin(), added.end());
    return words;
}

std::string output_of(const Words& added)
{
    const Outcome outcome = Tool().run(bench_words(added));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
}

void expect_fit(const Json& fit, const std::string& method, const std::vector<double>& x)
{
    EXPECT_EQ(fit.at("method"), method);
    EXPECT_TRUE(fit.at("parameters").is_object());
    EXPECT_EQ(fit.at("x"), Json(x));
    for (const char* part : {"fragments", "resolve", "total"}) {
        EXPECT_EQ(fit.at("ms").at(part).size(), x.size()) << part;
        EXPECT_TRUE(fit.at("exponents").at(part).contains("exponent")) << part;
        EXPECT_TRUE(fit.at("exponents").at(part).contains("error")) << part;
    }
    EXPECT_TRUE(fit.at("exponents").at("total").at("exponent").is_number());
    // With two values the line goes through both.
    EXPECT_EQ(fit.at("exponents").at("total").at("error").is_null(), x.size() < 3);
}

struct Case {
    Words words;
    std::string over;
    std::vector<std::string> values;
    std::string against;
    std::vector<double> x;
};

void expect_scaling(const Case& one)
{
    SCOPED_TRACE(testing::PrintToString(one.words));
    Words words = one.words;
    words.emplace_back("--json");
    const Json json = parse_json(output_of(words));
    EXPECT_EQ(json.at("results").size(), 2 * one.values.size());
    const Json& scaling = json.at("scaling");
    EXPECT_EQ(scaling.at("over"), one.over);
    EXPECT_EQ(scaling.at("values"), Json(one.values));
    EXPECT_EQ(scaling.at("against"), one.against);
    ASSERT_EQ(scaling.at("fits").size(), 2u);
    expect_fit(scaling.at("fits")[0], "blend", one.x);
    expect_fit(scaling.at("fits")[1], "exact", one.x);
}

// Three layers of two triangles each fill the picture; along the diagonal that the triangles share
// a pixel has a fragment of both.
TEST(BenchOver, JsonHoldsWhatGrewAndHow)
{
    const auto fragments = [](const Words& words) {
        Words all = words;
        all.emplace_back("--json");
        return parse_json(output_of(all)).at("results").at(0).at("fragments").get<double>();
    };
    const double f = fragments({"--size", "16x12"});
    EXPECT_GE(f, 3 * 16 * 12);
    const double g = fragments({"--size", "32x24"});
    expect_scaling({{"--size", "16x12", "--over", "layers"},
                    "layers",
                    {"1", "2", "4", "8"},
                    "fragments",
                    {f, 2 * f, 4 * f, 8 * f}});
    expect_scaling(
        {{"--over", "size=16x12,32x24"}, "size", {"16x12", "32x24"}, "fragments", {f, g}});
    expect_scaling({{"--size", "16x12", "--over", "samples=1,8,16"},
                    "samples",
                    {"1", "8", "16"},
                    "samples",
                    {1, 8, 16}});
    expect_scaling({{"--size", "16x12", "--over", "threads=1,2,3"},
                    "threads",
                    {"1", "2", "3"},
                    "threads",
                    {1, 2, 3}});
}

// Large enough to have a tile for each thread.
TEST(BenchOver, RowsAreOfTheSettings)
{
    const Json json =
        parse_json(output_of({"--over", "threads=1,3", "--size", "200x150", "--json"}));
    for (std::size_t i = 0; i < 4; ++i) {
        const Json& row = json.at("results").at(i);
        EXPECT_EQ(row.at("threads"), i < 2 ? 1 : 3);
        EXPECT_EQ(row.at("method"), i % 2 == 0 ? "blend" : "exact");
        EXPECT_EQ(row.at("width"), 200);
    }
    EXPECT_FALSE(parse_json(output_of({"--size", "9x7", "--json"})).contains("scaling"));
    const Json layers = parse_json(output_of({"--over", "layers=1,3", "--size", "9x7", "--json"}));
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(layers.at("results").at(i).at("layers"), i < 2 ? 1 : 3);
    }
}

TEST(BenchOver, SizesEndInTheGivenOne)
{
    const Json json = parse_json(output_of({"--over", "size", "--size", "40x20", "--json"}));
    EXPECT_EQ(json.at("scaling").at("values"), (Json{"10x5", "20x10", "40x20"}));
}

TEST(BenchOver, TableEndsInTheExponents)
{
    const std::string table = output_of({"--over", "layers=1,3", "--size", "9x7"});
    EXPECT_NE(table.find("time ~ fragments^e"), std::string::npos) << table;
    EXPECT_NE(table.find("\nexact"), std::string::npos) << table;
}

TEST(BenchOver, RefusesInOneLine)
{
    const std::vector<std::pair<Words, std::string>> wrong = {
        {{"--over", "layer"}, "--over: 'layer' is none of threads, size, samples, layers (did you"},
        {{"--over", "layers=2"}, "--over: '2' is one value; growth takes two"},
        {{"--over", "layers=2,2"}, "--over: '2,2' does not grow"},
        {{"--over", "size=32x24,16x12"}, "--over: '32x24,16x12' does not grow"},
        {{"--over", "layers=0,1"}, "--over: '0' is not a whole number from 1 to 256"},
        {{"--over", "size=8,16"}, "--over: '8' is not WIDTHxHEIGHT"},
        {{"--over", "samples=1,3"}, "--samples: 3 is not one of"},
        {{"--over", "threads", "--threads", "2"}, "--threads: '--over threads' goes through"},
        {{"--over", "samples", "--samples", "2"}, "--samples: '--over samples' goes through"},
        {{"--over", "size=8x8,9x9", "--size", "4x4"}, "--size: '--over size' goes through"},
        {{"--over", "layers", "--samples", "1,2"}, "--samples: one number is needed with"},
        {{"--over", "layers", "--eye", "0,0,9"}, "--eye"}};
    for (const auto& [words, part] : wrong) {
        const Outcome outcome = Tool().run(bench_words(words));
        SCOPED_TRACE(outcome.err);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1);
        EXPECT_NE(outcome.err.find(part), std::string::npos) << part;
    }
}

TEST(BenchOver, LayersNeedSomethingTransparent)
{
    const Tool tool;
    std::ofstream(tool.file("a.stl")) << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                         "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
                                         "endsolid a\n";
    const Words words = {"bench", "a.stl", "--over", "layers", "--repeat", "1", "--size", "8x8"};
    const Outcome outcome = tool.run(words);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "sheer: --over layers: nothing in the scene is transparent\n");
}

}  // namespace
}  // namespace sheer::test
