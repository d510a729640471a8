// What the tool says and leaves behind when the command, its input or the world is wrong: one line,
// the right exit code, and no part of a file.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_tool.h"
#include "scene/gltf_fixture.h"

namespace sheer::test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

// Exactly one line on standard error, with `part` in it, and nothing else anywhere.
void expect_refused(const Words& arguments, const std::string& part, int exit_code = 2)
{
    SCOPED_TRACE(testing::PrintToString(arguments));
    const Tool tool;
    const Outcome outcome = tool.run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind("sheer: ", 0), 0u) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(tool.folder().entries(), 0);
}

// A render that is fine but for what is added.
void expect_render_refused(const Words& added, const std::string& part)
{
    Words arguments = {"render", "builtin:quads", "-o", "a.png"};
    arguments.insert(arguments.end(), added.begin(), added.end());
    expect_refused(arguments, part);
}

TEST(CommandLine, NamesWhatItDoesNotKnow)
{
    expect_refused({}, "a command is needed; see 'sheer --help'");
    expect_refused({"paint"}, "there is no command 'paint'");
    expect_refused({"--bogus"}, "there is no option '--bogus'");
    expect_refused({"--json", "render"}, "there is no option '--json'; see 'sheer render --help'");
    expect_refused({"rendr"}, "no command 'rendr' (did you mean 'render'?); see 'sheer --help'");
    expect_render_refused({"--sampels", "3"}, "'--sampels' (did you mean '--samples'?); see");
    expect_refused({"compare", "builtin:quads", "-o", "out", "--methods", "wbiot"},
                   "--methods: there is no method 'wbiot' (did you mean 'wboit'?); there are ");
    expect_refused({"compare", "builtin:quads", "-o", "out", "--methods", "stochastic:mask=naive"},
                   "stochastic has no parameter 'mask' (did you mean 'masks'?); it has ");
    expect_refused({"reproduce", "stochastic-figure-0", "-o", "out"},
                   "figure 'stochastic-figure-0' (did you mean 'stochastic-figure-");
    expect_render_refused({"--method", "mlba"}, "--method: there is no method 'mlba' (did you");
    expect_refused({"info", "builtin:motr"}, "no such scene (did you mean 'motor'?); there are ");
    expect_refused({"info", "builtin:layers?alhpa=1"}, "parameter (did you mean 'alpha'?); there");
    expect_render_refused({"--bogus", "3"}, "there is no option '--bogus'; see 'sheer render");
    expect_render_refused({"b.glb"}, "'b.glb' is one argument too many");
    expect_render_refused({"--method", "foo"}, "--method: there is no method 'foo'; there are ");
    expect_render_refused({"--method", "exact:k=1"}, "--method: exact has no parameter 'k'");
    expect_render_refused({"--method", "none"}, "'none' makes no picture");
    expect_render_refused({"--backend", "abacus"}, "--backend: 'abacus' is none of cpu");
    expect_render_refused({"--camera", "foo"}, "'foo': no such camera");
    expect_refused({"bench", "builtin:quads", "--methods", "exact,foo"}, "no method 'foo'");
    expect_refused({"bench", "builtin:quads", "--methods", "exact,"}, "no method ''");
}

TEST(CommandLine, NamesWhatIsMissing)
{
    expect_refused({"render"}, "SCENE is required; see 'sheer render --help'");
    expect_refused({"info"}, "SCENE is required");
    expect_refused({"bench"}, "SCENE is required");
    expect_refused({"render", "builtin:quads"}, "--output is required");
    expect_refused({"render", "builtin:quads", "-o"}, "--output: 1 required FILE missing");
    expect_render_refused({"--eye", "-1,2,3"}, "--eye requires --target");
    expect_render_refused({"--target", "1,2,3"}, "--target requires --eye");
    expect_render_refused({"--fov", "30"}, "--fov requires --eye");
    expect_render_refused({"--json=3"}, "json was given");
    expect_render_refused({"--eye", "1,2,3", "--target", "0,0,0", "--camera", "0"}, "excludes");
}

TEST(CommandLine, NamesNumbersThatAreNone)
{
    for (const char* size :
         {"0x0", "200000x200000", "-5x7", "10x", "x10", "10", "10x10x10", "1.5x2",
          "99999999999999999999x1", "4294967297x1", "nanxnan", "", " 8x8"}) {
        expect_render_refused({"--size", size}, "--size: '" + std::string(size) + "' is not ");
    }
    for (const char* number : {"nan", "inf", "1e50", "1e999", "x", "1,5", "", "1 "}) {
        expect_render_refused({"--exposure", number},
                              "--exposure: '" + std::string(number) + "' is not a finite number");
    }
    expect_render_refused({"--exposure", "65"}, "--exposure: ");
    expect_render_refused({"--samples", "3"}, "--samples: 3 is not one of 1, 2, 4");
    expect_render_refused({"--samples", "1,2"}, "--samples: '1,2'");
    expect_render_refused({"--threads", "5000000000"}, "--threads: '5000000000'");
    expect_render_refused({"--threads", "-1"}, "--threads: '-1'");
    expect_render_refused({"--seed", "-1"}, "--seed: '-1'");
    expect_render_refused({"--simd", "mmx"}, "--simd: 'mmx' is none of scalar, sse4");
    expect_render_refused({"--filter", "sinc"}, "--filter: 'sinc' is none of box, gaussian");
    expect_render_refused({"--sample-positions", "x"}, "--sample-positions: 'x' is none of");
    expect_render_refused({"--background", "1,2"}, "--background: '1,2' is not R,G,B or R,G,B,A");
    expect_render_refused({"--background", "1,2,nan"}, "--background: 'nan'");
    expect_render_refused({"--background", "-1,0,0"}, "--background: ");
    expect_render_refused({"--eye", "1,2", "--target", "0,0,0"}, "--eye: '1,2' is not X,Y,Z");
    expect_render_refused({"--eye", "1,2,3", "--target", "1,2,3"}, "--eye: the same point");
    expect_render_refused({"--eye", "1,2,3", "--target", "0,0,0", "--fov", "180"}, "--fov: '180'");
    expect_refused({"bench", "builtin:quads", "--samples", "1,3"}, "--samples: 3 is not one of");
    expect_refused({"bench", "builtin:quads", "--samples", "1,"}, "--samples: ''");
    expect_refused({"bench", "builtin:quads", "--repeat", "0"}, "--repeat: '0'");
}

TEST(CommandLine, NamesScenesThatAreNone)
{
    const Words commands[] = {{"info"}, {"render", "-o", "a.png"}, {"bench"}};
    for (const Words& command : commands) {
        const auto with = [&](const std::string& scene) {
            Words words = command;
            words.push_back(scene);
            return words;
        };
        expect_refused(with("missing.glb"), "missing.glb: no such file");
        expect_refused(with("/"), "/: is a directory, not a file");
        expect_refused(with("/dev/null"), "/dev/null: is not a regular file");
        expect_refused(with("builtin:foo"), "builtin:foo: no such scene; there are ");
        expect_refused(with("builtin:layers?alpha=2"), "builtin:layers: alpha: ");
    }
}

TEST(CommandLine, RefusesEveryTruncatedScene)
{
    const Tool tool;
    const TestFolder scenes;
    const std::string glb = as_glb(one_triangle());
    const std::string path = scenes.file("a.glb");
    const auto info_of_first = [&](std::size_t bytes) {
        std::ofstream(path, std::ios::binary) << glb.substr(0, bytes);
        return tool.run({"info", path});
    };
    ASSERT_EQ(info_of_first(glb.size()).exit_code, 0);
    for (std::size_t bytes = 0; bytes < glb.size(); bytes += 1 + glb.size() / 40) {
        const Outcome outcome = info_of_first(bytes);
        EXPECT_EQ(outcome.exit_code, 2) << bytes;
        EXPECT_EQ(outcome.out, "") << bytes;
        EXPECT_EQ(outcome.err.rfind("sheer: " + path + ": ", 0), 0u) << outcome.err;
        EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    }
}

TEST(CommandLine, ChecksOutputsBeforeItRenders)
{
    const Tool tool;
    fs::create_directory(tool.file("folder.png"));
    struct Case {
        const char* path;
        const char* complaint;
    };
    for (const Case& c : {Case{"missing/a.png", "the directory 'missing' does not exist"},
                          Case{"folder.png", "is a directory"},
                          Case{"a.gif", "unknown picture format; use .exr or .png"},
                          Case{"a", "unknown picture format; use .exr or .png"}}) {
        // The scene does not exist either: had it been read first, that would be the complaint.
        const Outcome outcome = tool.run({"render", "missing.glb", "-o", c.path});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.err, "sheer: " + std::string(c.path) + ": " + c.complaint + "\n");
    }
    const Outcome stats =
        tool.run({"render", "missing.glb", "-o", "a.png", "--stats", "missing/a.json"});
    EXPECT_EQ(stats.err, "sheer: missing/a.json: the directory 'missing' does not exist\n");
    const Outcome same = tool.run({"render", "missing.glb", "-o", "a.png", "--stats", "./a.png"});
    EXPECT_EQ(same.err, "sheer: ./a.png: is both the picture and its statistics\n");
    EXPECT_EQ(tool.folder().entries(), 1);
}

TEST(CommandLine, LeavesTheOldFileWhenTheDiskFillsUp)
{
    const Tool tool;
    for (const char* name : {"a.png", "a.exr"}) {
        std::ofstream(tool.file(name)) << "old";
        const Outcome outcome = tool.run({"render", "builtin:quads", "-o", name, "--size", "64x64"},
                                         {.file_size_limit = 200});
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_EQ(outcome.err, "sheer: " + std::string(name) + ": File too large\n");
        EXPECT_EQ(text_of(tool.file(name)), "old");
    }
    EXPECT_EQ(tool.folder().entries(), 2);
}

TEST(CommandLine, ReportsFullDevices)
{
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const Tool tool;
    fs::create_symlink("/dev/full", tool.file("a.png"));
    const Outcome outcome = tool.run({"render", "builtin:quads", "-o", "a.png", "--size", "8x8"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err, "sheer: a.png: No space left on device\n");
    EXPECT_EQ(tool.folder().entries(), 1);
}

TEST(CommandLine, ReportsStandardOutputThatTakesNothing)
{
    const Tool tool;
    const Words commands[] = {{"--help"},
                              {"--version"},
                              {"methods"},
                              {"info", "builtin:quads", "--json"},
                              {"render", "builtin:quads", "-o", "a.png", "--size", "8x8"},
                              {"bench", "builtin:quads", "--size", "8x8", "--repeat", "1"}};
    for (const Words& command : commands) {
        SCOPED_TRACE(testing::PrintToString(command));
        const Outcome closed = tool.run(command, {.closed_output = true});
        EXPECT_EQ(closed.exit_code, 1);
        EXPECT_EQ(closed.err, "sheer: standard output: Bad file descriptor\n");
        if (!fs::exists("/dev/full")) continue;
        const Outcome full = tool.run(command, {.standard_output = "/dev/full"});
        EXPECT_EQ(full.exit_code, 1);
        EXPECT_EQ(full.err, "sheer: standard output: No space left on device\n");
    }
}

TEST(CommandLine, ShowsNoControlCharactersOutOfNames)
{
    const Tool tool;
    const Outcome outcome = tool.run({"info", "no\x1b[31m\nsuch.glb"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "sheer: no?[31m?such.glb: no such file\n");
}

}  // namespace
}  // namespace sheer::test
