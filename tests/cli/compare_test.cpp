// sheer compare, and the options of render that came with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "cli/run_tool.h"
#include "image/read_image.h"
#include "support/json.h"
#include "support/memory.h"
#include "support/text.h"

namespace sheer::test {

namespace {

Json json_file(const std::string& path)
{
    return parse_json(text_of(path));
}

const Json& row_of(const Json& metrics, const std::string& method, int samples)
{
    for (const Json& row : metrics["results"]) {
        if (row["method"] == method && row["samples"] == samples) return row;
    }
    throw std::runtime_error("no row of " + method);
}

}  // namespace

TEST(CliCompare, MeasuresAndKeepsThePictures)
{
    const Tool tool;
    const Outcome outcome =
        tool.run({"compare", "builtin:quads", "--size", "64x48", "--samples", "1,4", "--methods",
                  "blend,exact,stochastic:masks=naive,wboit", "--seeds", "6", "-o", "out"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json metrics = json_file(tool.file("out/metrics.json"));
    EXPECT_EQ(metrics["scene"], "builtin:quads");
    EXPECT_EQ(metrics["truth"]["samples"], 256);
    ASSERT_EQ(metrics["results"].size(), 8u);
    for (const Json& row : metrics["results"]) {
        EXPECT_TRUE(std::filesystem::exists(tool.file("out/" + row["image"].get<std::string>())));
        EXPECT_TRUE(
            std::filesystem::exists(tool.file("out/" + row["error_map"].get<std::string>())));
        EXPECT_GE(row["rmse"], 0);
        EXPECT_TRUE(row["noise"].is_number());
        EXPECT_TRUE(row["ms"]["total"].is_number());
    }
    for (const int samples : {1, 4}) {
        const Json& exact = row_of(metrics, "exact", samples);
        EXPECT_EQ(exact["rmse_same_s"], 0.0);
        EXPECT_EQ(exact["bias"], 0.0);
        const Json& blend = row_of(metrics, "blend", samples);
        EXPECT_EQ(blend["ratio_to_blend"], 1.0);
        EXPECT_EQ(blend["noise"], 0.0);
        EXPECT_EQ(blend["bias"], blend["rmse_same_s"]);
        const Json& stochastic = row_of(metrics, "stochastic", samples);
        EXPECT_EQ(stochastic["seeds"], 6);
        EXPECT_EQ(stochastic["parameters"]["masks"], "naive");
        EXPECT_GT(stochastic["noise"], 0.0);
    }
    // The errors of bands are parts of the whole, for random methods too: pixels outside of all are
    // right.
    const Json& bands = metrics["failures"][0]["bands"];
    for (std::size_t i = 0; i < 4; ++i) {
        const Json& row = metrics["results"][i];  // with the samples by which pixels are divided
        double squares = 0;
        for (std::size_t band = 0; band < bands.size(); ++band) {
            const Json& error = row["failures"]["layers"][band];
            ASSERT_EQ(error.is_null(), bands[band]["pixels"] == 0) << band;
            if (error.is_null()) continue;
            squares += bands[band]["pixels"].get<double>() * std::pow(error.get<double>(), 2);
        }
        const double all = row["rmse_same_s"];
        EXPECT_NEAR(squares / (64 * 48), all * all, 1e-9 * all * all) << row["method"];
    }
    // A table of what all rows have, and a line for each.
    std::ifstream csv(tool.file("out/metrics.csv"));
    std::string line;
    int lines = 0;
    while (std::getline(csv, line)) ++lines;
    EXPECT_EQ(lines, 9);
}

// What `compare` writes of a method without random numbers is what `render` and `diff` give.
TEST(CliCompare, AgreesWithRenderAndDiff)
{
    const Tool tool;
    ASSERT_EQ(tool.run({"compare", "builtin:quads", "--size", "40x30", "--methods",
                        "weighted-average,stochastic", "--seeds", "1", "--seed", "5", "-o", "out"})
                  .exit_code,
              0);
    const Json metrics = json_file(tool.file("out/metrics.json"));
    const Json& row = row_of(metrics, "weighted-average", 8);
    const Outcome diff =
        tool.run({"diff", "out/weighted-average.s8.exr", "out/truth.exr", "--json"});
    ASSERT_EQ(diff.exit_code, 0) << diff.err;
    EXPECT_DOUBLE_EQ(parse_json(diff.out)["rmse"].get<double>(), row["rmse"].get<double>());
    EXPECT_DOUBLE_EQ(parse_json(diff.out)["psnr"].get<double>(), row["psnr"].get<double>());
    ASSERT_EQ(tool.run({"render", "builtin:quads", "--size", "40x30", "--method", "stochastic",
                        "--seed", "5", "-o", "alone.exr"})
                  .exit_code,
              0);
    EXPECT_EQ(read_image(tool.file("alone.exr")).pixels,
              read_image(tool.file("out/stochastic.s8.exr")).pixels);
    // Of random methods the first seed's picture.
    for (const char* method : {"weighted-average", "stochastic"}) {
        const Outcome seen =
            tool.run({"diff", "out/" + std::string(method) + ".s8.exr", "out/truth.exr", "--json"});
        const Json& scores = row_of(metrics, method, 8);
        EXPECT_EQ(parse_json(seen.out)["flip"], scores["flip"]);
        EXPECT_EQ(parse_json(seen.out)["ssim"], scores["ssim"]);
    }
    EXPECT_TRUE(row_of(metrics, "stochastic", 8)["noise"].is_null());
    EXPECT_TRUE(row_of(metrics, "stochastic", 8)["bias"].is_null());
}

// What it takes without a list stands in its help; 'all' is the table, and nothing is drawn twice.
TEST(CliCompare, TakesTheUsualMethodsOrAll)
{
    const Tool tool;
    const auto compared = [&](std::vector<std::string> added) {
        std::vector<std::string> arguments = {"compare",   "builtin:layers?alpha=0.5&depth=1,2",
                                              "--size",    "8x8",
                                              "--samples", "1",
                                              "--seeds",   "1",
                                              "--json",    "-o",
                                              "out"};
        arguments.insert(arguments.end(), added.begin(), added.end());
        const Outcome outcome = tool.run(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        std::vector<std::string> methods;
        const Json metrics = parse_json(outcome.out);
        for (const Json& row : metrics["results"]) methods.push_back(row["method"]);
        return methods;
    };
    std::vector<std::string> all;
    const Json table = parse_json(tool.run({"methods", "--json"}).out);
    for (const Json& row : table["methods"]) {
        if (!row["bench_only"]) all.push_back(row["id"]);
    }
    EXPECT_EQ(compared({"--methods", "all"}), all);
    EXPECT_EQ(compared({"--methods", "all,blend"}), all);
    std::vector<std::string> more = all;
    more.insert(more.begin(), "wboit");
    EXPECT_EQ(compared({"--methods", "wboit:weight=eq8,all"}), more);

    const std::vector<std::string> usual = compared({});
    const std::string help = tool.run({"compare", "--help"}).out;
    std::string lines = "Without --methods:\n";
    for (const std::string& line : split(help.substr(help.find(lines) + lines.size()), '\n')) {
        if (line.empty()) break;
        lines += line + "\n";
        const std::string id = split(line.substr(2), ':')[0];
        EXPECT_NE(std::find(usual.begin(), usual.end(), id), usual.end()) << line;
    }
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'),
              static_cast<std::ptrdiff_t>(usual.size()) + 1);
    EXPECT_LT(usual.size(), all.size());
    for (const char* id : {"exact", "blend", "sorted-blend"}) {
        EXPECT_EQ(std::count(usual.begin(), usual.end(), id), 1) << id;
    }
}

TEST(CliCompare, WhatIsWrongIsOneLine)
{
    const Tool tool;
    std::ofstream(tool.file("file")) << "x";
    const auto error = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"compare", "builtin:quads", "--size", "8x8"});
        const Outcome outcome = tool.run(arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        return outcome.err;
    };
    EXPECT_EQ(error({}), "sheer: --output is required; see 'sheer compare --help'\n");
    EXPECT_EQ(error({"-o", "out", "--methods", "none"}),
              "sheer: --methods: 'none' makes no picture; it is for 'bench'\n");
    EXPECT_EQ(error({"-o", "out", "--seeds", "0"}),
              "sheer: --seeds: '0' is not a whole number from 1 to 10000\n");
    EXPECT_EQ(error({"-o", "out", "--samples", "3"}),
              "sheer: --samples: 3 is not one of 1, 2, 4, 8, 16, 32, 64\n");
    EXPECT_TRUE(error({"-o", "file"}).starts_with("sheer: file: can't be made a folder"));
    EXPECT_FALSE(std::filesystem::exists(tool.file("out")));
}

TEST(CliRender, ChannelsAccumulationAndMemory)
{
    const Tool tool;
    const Outcome outcome = tool.run({"render", "builtin:layers", "--size", "16x16", "-o", "a.exr",
                                      "--method", "stochastic", "--accumulate", "4", "--channels",
                                      "channels.exr", "--memory-limit", "200"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_GT(std::filesystem::file_size(tool.file("channels.exr")), 0u);

    const Outcome png =
        tool.run({"render", "builtin:layers", "-o", "b.exr", "--channels", "c.png"});
    EXPECT_EQ(png.exit_code, 2);
    EXPECT_EQ(png.err, "sheer: c.png: channels go into an .exr file\n");
    const Outcome same =
        tool.run({"render", "builtin:layers", "-o", "b.exr", "--channels", "./b.exr"});
    EXPECT_EQ(same.exit_code, 2);
    EXPECT_EQ(same.err, "sheer: ./b.exr: is both the picture and its channels\n");
    const auto with_limit = [&](const char* size, const char* limit) {
        return tool.run(
            {"render", "builtin:layers", "-o", "b.exr", "--size", size, "--memory-limit", limit});
    };
    const Outcome small = with_limit("16x16", "3");
    EXPECT_EQ(small.exit_code, 1);
    EXPECT_EQ(small.err, "sheer: --memory-limit: reading the scene takes more than 3 MiB\n");
    const Outcome large = with_limit("4096x4096", "400");
    EXPECT_EQ(large.exit_code, 1);
    EXPECT_TRUE(large.err.starts_with("sheer: memory-limit: 400 MiB are too little")) << large.err;
    EXPECT_FALSE(std::filesystem::exists(tool.file("b.exr")));
    // More than there is.
    EXPECT_EQ(with_limit("16x16", "1000000").exit_code, 0);
    const Outcome none = tool.run({"render", "builtin:layers", "-o", "b.exr", "--accumulate", "0"});
    EXPECT_EQ(none.exit_code, 2);
}

#ifndef SHEER_SHADOW_MEMORY

// 400,000 triangles of 50 bytes: what is in the file is more than the limit.
TEST(CliRender, ReadingKeepsTheMemoryLimit)
{
    const Tool tool;
    std::string stl(80, ' ');
    stl += std::string("\x80\x1a\x06\0", 4);
    stl.resize(84 + 400'000 * 50);
    std::ofstream(tool.file("large.stl"), std::ios::binary) << stl;
    const Outcome outcome =
        tool.run({"render", "large.stl", "-o", "a.exr", "--memory-limit", "24"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err, "sheer: --memory-limit: reading the scene takes more than 24 MiB\n");
    EXPECT_FALSE(std::filesystem::exists(tool.file("a.exr")));
}

// Of the whole process, from the truth to the report: layers that take several times the limit, and
// as many as the report has room for then.
TEST(CliCompare, KeepsItsMemoryLimit)
{
    if (peak_memory_bytes() > 60u << 20) GTEST_SKIP() << "other tests took too much before";
    const Tool tool;
    const auto compare = [&](const std::string& scene, const char* methods,
                             const std::string& folder, const char* limit) {
        std::vector<std::string> arguments = {"compare", scene,       "-o", folder,      "--size",
                                              "96x96",   "--samples", "2",  "--methods", methods};
        if (limit != nullptr) arguments.insert(arguments.end(), {"--memory-limit", limit});
        const Outcome outcome = tool.run(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.peak_memory;
    };
    const auto expect_kept = [&](const std::string& scene, const char* methods,
                                 const std::vector<std::string>& pictures) {
        for (const char* limit : {"64", "96"}) {
            EXPECT_LE(compare(scene, methods, limit, limit), std::stoull(limit) << 20) << scene;
            for (const std::string& name : pictures) {
                EXPECT_EQ(read_image(tool.file(std::string(limit) + "/" + name + ".exr")).pixels,
                          read_image(tool.file("free/" + name + ".exr")).pixels)
                    << name << " of " << scene;
            }
        }
    };
    const std::string many = "builtin:layers?n=1000&alpha=0.01";
    EXPECT_GT(compare(many, "exact,blend,deep-shadow-map", "free", nullptr), 180u << 20);
    expect_kept(many, "exact,blend,deep-shadow-map", {"truth", "exact.s2", "deep-shadow-map.s2"});
    const std::string few = "builtin:layers?n=50&alpha=0.05";
    compare(few, "adaptive,moment,k-buffer", "free", nullptr);
    expect_kept(few, "adaptive,moment,k-buffer", {"truth", "adaptive.s2", "moment.s2"});
}

// The peak is that of the whole process, the picture's file included.
TEST(CliRender, KeepsItsMemoryLimit)
{
    const Tool tool;
    const auto render = [&](const Json& row, const std::string& file, const char* limit) {
        const std::string method = row["id"];
        // A pass for each layer: the more layers, the more passes, each over all of them.
        const char* scene = row["passes"] > 2 ? "builtin:layers?n=40&alpha=0.01"
                                              : "builtin:layers?n=1000&alpha=0.01";
        std::vector<std::string> arguments = {"render",   scene,     "-o",        file,
                                              "--size",   "192x108", "--samples", "2",
                                              "--method", method,    "--json"};
        if (limit != nullptr) arguments.insert(arguments.end(), {"--memory-limit", limit});
        const Outcome outcome = tool.run(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return parse_json(outcome.out)["peak_memory_bytes"].get<std::uint64_t>();
    };
    const Json methods = parse_json(tool.run({"methods", "--json"}).out);
    for (const Json& row : methods["methods"]) {
        if (row["bench_only"]) continue;
        const std::string method = row["id"];
        const std::uint64_t free = render(row, "free.exr", nullptr);
        const std::uint64_t limited = render(row, "limited.exr", "48");
        EXPECT_LE(limited, 48u << 20) << method;
        // Whoever keeps every fragment would take more.
        if (!row["bounded"]) {
            EXPECT_GT(free, 96u << 20) << method;
        }
        EXPECT_EQ(read_image(tool.file("limited.exr")).pixels,
                  read_image(tool.file("free.exr")).pixels)
            << method;
    }
}

#endif

}  // namespace sheer::test
