// What the tool gives: help, text and JSON with the promised keys, and pictures that do not depend
// on the machine.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"
#include "lanes/targets.h"
#include "methods/method.h"
#include "scene/builtin.h"
#include "support/json.h"

namespace sheer::test {
namespace {

using Words = std::vector<std::string>;

// Standard output of a run that must go well.
std::string output_of(const Tool& tool, const Words& arguments)
{
    const Outcome outcome = tool.run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
}

Json json_of(const Tool& tool, const Words& arguments)
{
    return parse_json(output_of(tool, arguments));
}

void expect_keys(const Json& json, const std::vector<const char*>& keys)
{
    for (const char* key : keys) EXPECT_TRUE(json.contains(key)) << key << " in " << json;
}

void expect_stats(const Json& json)
{
    expect_keys(json, {"method", "parameters", "samples", "width", "height", "backend", "simd",
                       "threads", "seed", "triangles", "fragments", "passes", "bytes_per_pixel",
                       "peak_memory_bytes", "ms"});
    expect_keys(json.at("ms"), {"geometry", "raster_shade", "store", "resolve", "total", "passes"});
    ASSERT_FALSE(json.at("ms").at("passes").empty());
    expect_keys(json.at("ms").at("passes").at(0), {"name", "ms"});
}

TEST(ToolOutput, HelpListsWhatThereIs)
{
    const Tool tool;
    for (const Words& words : {Words{"--help"}, Words{"render", "--help"}, Words{"bench", "-h"}}) {
        const std::string help = output_of(tool, words);
        for (const MethodRow& row : method_table()) {
            EXPECT_NE(help.find("  " + std::string(row.id) + " "), std::string::npos) << row.id;
        }
        for (const BuiltinScene& scene : builtin_scenes()) {
            EXPECT_NE(help.find("builtin:" + std::string(scene.name)), std::string::npos);
            EXPECT_NE(help.find(scene.parameters), std::string::npos);
        }
    }
    for (const char* command : {"render", "info", "methods", "bench", "diff"}) {
        const std::string help = output_of(tool, {command, "--help"});
        EXPECT_EQ(help.find('\t'), std::string::npos);
        EXPECT_NE(help.find("Examples:\n  sheer " + std::string(command)), std::string::npos);
    }
    EXPECT_EQ(output_of(tool, {"--version"}).rfind("sheer ", 0), 0u);
}

TEST(ToolOutput, MethodsAreTheTable)
{
    const Tool tool;
    const Json methods = json_of(tool, {"methods", "--json"}).at("methods");
    ASSERT_EQ(methods.size(), method_table().size());
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const MethodRow& row = method_table()[i];
        expect_keys(methods[i], {"id", "title", "citation", "continuum", "parameters", "passes",
                                 "bytes_per_pixel", "bounded", "order_independent", "coloured",
                                 "unbiased", "exact_up_to", "bench_only"});
        EXPECT_EQ(methods[i].at("id"), row.id);
        EXPECT_EQ(methods[i].at("parameters").size(), row.parameters.size());
        EXPECT_EQ(methods[i].at("exact_up_to").is_null(), row.traits.exact_up_to < 0);
    }
    const std::string text = output_of(tool, {"methods"});
    for (const MethodRow& row : method_table()) {
        EXPECT_NE(text.find(row.citation), std::string::npos) << row.id;
    }
}

// docs/continuum.md has the table between two lines; a change of the table is to be copied there.
TEST(ToolOutput, TheContinuumPageHasTheTable)
{
    const Tool tool;
    const std::string table = output_of(tool, {"methods", "--markdown"});
    const std::string page = text_of(SHEER_SOURCE_DIR "/docs/continuum.md");
    const std::string begin = "<!-- sheer methods --markdown -->\n", end = "<!-- end -->\n";
    const std::size_t first = page.find(begin), last = page.find(end);
    ASSERT_NE(first, std::string::npos);
    ASSERT_NE(last, std::string::npos);
    const std::size_t after = first + begin.size();
    EXPECT_EQ(page.substr(after, last - after), table)
        << "put the output of 'sheer methods --markdown' into docs/continuum.md";
    for (const MethodRow& row : method_table()) {
        EXPECT_NE(table.find("| `" + std::string(row.id) + "` | " + row.continuum.contribute +
                             " | " + row.continuum.store + " | " + row.continuum.merge + " | " +
                             row.continuum.normalise + " |"),
                  std::string::npos);
    }
}

TEST(ToolOutput, EveryMethodAnswersTheFourQuestions)
{
    const Tool tool;
    const Json methods = json_of(tool, {"methods", "--json"}).at("methods");
    const std::string text = output_of(tool, {"methods"});
    for (const Json& method : methods) {
        for (const char* question : {"contribute", "store", "merge", "normalise"}) {
            const std::string answer = method.at("continuum").at(question);
            EXPECT_FALSE(answer.empty()) << method.at("id") << ", " << question;
            EXPECT_NE(text.find(answer), std::string::npos);
        }
    }
}

TEST(ToolOutput, InfoCountsTheScene)
{
    const Tool tool;
    const Json info = json_of(tool, {"info", "builtin:layers?n=3", "--json"});
    EXPECT_EQ(info.at("scene"), "builtin:layers?n=3");
    EXPECT_EQ(info.at("objects"), 3);
    EXPECT_EQ(info.at("triangles"), 6);
    EXPECT_EQ(info.at("triangles_by_alpha_mode").at("blend"), 6);
    EXPECT_EQ(info.at("bounds").at("max").size(), 3u);
    expect_keys(
        info, {"meshes", "vertices", "materials", "materials_by_alpha_mode", "cameras", "ignored"});
    const std::string text = output_of(tool, {"info", "builtin:layers?n=3"});
    EXPECT_NE(text.find("triangles  6 (6 blend)\n"), std::string::npos) << text;
}

TEST(ToolOutput, RenderSaysWhatItDid)
{
    const Tool tool;
    const std::string line = output_of(tool, {"render", "builtin:layers", "-o", "a.png", "--size",
                                              "40x30", "--samples", "1", "--method", "blend"});
    EXPECT_EQ(line.rfind("a.png: 40x30, blend, 1 sample, 4 triangles, 2,400 fragments, ", 0), 0u)
        << line;
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    EXPECT_EQ(text_of(tool.file("a.png")).substr(1, 3), "PNG");
    EXPECT_EQ(tool.folder().entries(), 1);
}

TEST(ToolOutput, RenderGivesStatisticsAsJson)
{
    const Tool tool;
    Json printed = json_of(tool, {"render", "builtin:layers", "-o", "a.exr", "--size", "40x30",
                                  "--seed", "18446744073709551615", "--threads", "2", "--stats",
                                  "a.json", "--json", "--simd", "scalar", "--backend", "cpu"});
    expect_stats(printed);
    EXPECT_EQ(printed.at("image"), "a.exr");
    EXPECT_EQ(printed.at("seed"), 18446744073709551615u);
    EXPECT_EQ(printed.at("width"), 40);
    EXPECT_EQ(printed.at("height"), 30);
    EXPECT_EQ(printed.at("threads"), 2);
    EXPECT_EQ(printed.at("simd"), "scalar");
    EXPECT_EQ(printed.at("samples"), 8);
    printed.erase("image");
    EXPECT_EQ(parse_json(text_of(tool.file("a.json"))), printed);
    EXPECT_EQ(tool.folder().entries(), 2);
}

TEST(ToolOutput, BenchGivesARowForEachMethodAndNumberOfSamples)
{
    const Tool tool;
    const Json bench = json_of(tool, {"bench", "builtin:layers", "--size", "40x30", "--methods",
                                      "exact,none", "--samples", "1,8", "--repeat", "3", "--json"});
    EXPECT_EQ(bench.at("scene"), "builtin:layers");
    const Json& rows = bench.at("results");
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        expect_stats(rows[i]);
        expect_keys(rows[i],
                    {"mfragments_per_s_per_thread", "ratio_to_blend", "ratio_to_base",
                     "ms_total_min", "ms_total_max", "ns_per_triangle", "ms_base", "ms_opaque"});
        expect_keys(rows[i].at("ns_per_fragment"), {"raster_shade", "store"});
        EXPECT_EQ(rows[i].at("method"), i % 2 == 0 ? "exact" : "none");
        EXPECT_EQ(rows[i].at("samples"), i < 2 ? 1 : 8);
        EXPECT_EQ(rows[i].at("repeat"), 3);
        EXPECT_GT(rows[i].at("ratio_to_blend"), 0);
        EXPECT_LE(rows[i].at("ms_total_min"), rows[i].at("ms").at("total"));
        EXPECT_GE(rows[i].at("ms_total_max"), rows[i].at("ms").at("total"));
    }
}

TEST(ToolOutput, BenchMeasuresEveryMethodUnlessTold)
{
    const Tool tool;
    const Json rows =
        json_of(tool, {"bench", "builtin:layers", "--size", "8x8", "--repeat", "2", "--json"})
            .at("results");
    ASSERT_EQ(rows.size(), method_table().size());
    for (const Json& row : rows) {
        if (row.at("method") == "blend") {
            EXPECT_EQ(row.at("ratio_to_blend"), 1);
        }
    }
    const std::string table =
        output_of(tool, {"bench", "builtin:layers", "--size", "8x8", "--repeat", "1"});
    for (const MethodRow& row : method_table()) {
        EXPECT_NE(table.find("\n" + std::string(row.id)), std::string::npos) << table;
    }
}

TEST(ToolOutput, BenchTellsPassesApart)
{
    const Tool tool;
    const Words words = {"bench",         "builtin:hair?strands=2000",
                         "--methods",     "stochastic:depth-based=on:correction=on",
                         "--size",        "40x40",
                         "--shadows",     "stochastic",
                         "--repeat",      "3",
                         "--shadow-size", "32"};
    Words for_programs = words;
    for_programs.emplace_back("--json");
    const Json row = json_of(tool, for_programs).at("results").at(0);
    std::vector<std::string> names;
    for (const Json& pass : row.at("ms").at("passes")) {
        names.push_back(pass.at("name"));
        EXPECT_GT(pass.at("ms"), 0) << pass;
    }
    EXPECT_EQ(names, (std::vector<std::string>{"shadow", "fragments", "stochastic depth",
                                               "accumulation"}));
    EXPECT_GT(row.at("ms_opaque"), 0);  // skin, eyes and floor
    const std::string table = output_of(tool, words);
    for (const std::string& name : names) EXPECT_NE(table.find("  " + name), std::string::npos);
    // As it was asked for, without what the method's other parameters are.
    EXPECT_NE(table.find("\nstochastic:depth-based=on:correction=on  "), std::string::npos);
}

// Nothing covers a pixel of this picture: counts are 0, and what is divided by them is no number.
TEST(ToolOutput, BenchOfNothingHasNoRates)
{
    const Tool tool;
    const Json rows =
        json_of(tool, {"bench", "builtin:quads", "--size", "8x8", "--repeat", "1", "--methods",
                       "blend", "--json", "--eye", "0,0,-100", "--target", "0,0,-200"})
            .at("results");
    EXPECT_EQ(rows.at(0).at("fragments"), 0);
    EXPECT_TRUE(rows.at(0).at("ns_per_fragment").at("store").is_null());
    EXPECT_TRUE(rows.at(0).at("ms_base").is_null());
    EXPECT_TRUE(rows.at(0).at("ratio_to_base").is_null());
}

TEST(ToolOutput, PicturesDoNotDependOnTheMachine)
{
    const Tool tool;
    std::vector<Words> ways = {{"--threads", "2"}, {"--threads", "7"}};
    std::string levels = available_simd_levels();
    for (std::size_t comma; !levels.empty(); levels.erase(0, comma)) {
        comma = std::min(levels.find(", "), levels.size());
        ways.push_back({"--threads", "1", "--simd", levels.substr(0, comma)});
        comma = std::min(comma + 2, levels.size());
    }
    ASSERT_GE(ways.size(), 3u);
    for (const char* scene : {"builtin:quads", "builtin:layers?n=5"}) {
        for (const char* method : {"blend", "exact"}) {
            const Words common = {"render", scene,      "-o",   "a.exr",    "--size",
                                  "61x47",  "--method", method, "--filter", "gaussian"};
            output_of(tool, common);
            const std::string expected = text_of(tool.file("a.exr"));
            for (const Words& way : ways) {
                SCOPED_TRACE(testing::PrintToString(way));
                Words words = common;
                words.insert(words.end(), way.begin(), way.end());
                output_of(tool, words);
                EXPECT_TRUE(text_of(tool.file("a.exr")) == expected) << scene << " " << method;
            }
        }
    }
}

}  // namespace
}  // namespace sheer::test
