// scripts/mutants.py: the tool stands what it makes, and it sees what a tool does wrong.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "support/test_folder.h"

namespace sheer::test {
namespace {

namespace fs = std::filesystem;

struct Said {
    int exit_code = -1;  // -1: ended by a signal
    std::string text;
};

Said run_command(const std::string& command)
{
    Said said;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return said;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
        said.text += static_cast<char>(c);
    }
    const int status = pclose(pipe);
    if (WIFEXITED(status)) said.exit_code = WEXITSTATUS(status);
    return said;
}

std::string quoted(const std::string& word)
{
    return "'" + word + "'";
}

Said run_mutants(const std::string& tool, const TestFolder& kept, const std::string& arguments)
{
    return run_command("python3 -B " + quoted(SHEER_SOURCE_DIR "/scripts/mutants.py") + " --tool " +
                       quoted(tool) + " --keep " + quoted(kept.path()) + " " + arguments);
}

// ---- the tool ---------------------------------------------------------------------------------

// A sanitizer's shadow memory takes most of the address space, and its checks most of the time.
#ifdef SHEER_SHADOW_MEMORY
constexpr const char* kHow = "--jobs 2 --seconds 60 --sanitized ";
#else
constexpr const char* kHow = "--jobs 2 ";
#endif

// How many; `./dev mutants` makes as many as one likes.
#ifdef SHEER_SLOW_TESTS
constexpr int kOfOwnFiles = 300, kOfRealFiles = 200;
#else
constexpr int kOfOwnFiles = 150, kOfRealFiles = 100;
#endif

// Of a folder's files.
std::string mutants_of(int count, const char* folder)
{
    std::string words = kHow;
    words += std::to_string(count) + " ";
    return words + quoted(folder);
}

TEST(Mutants, OfOwnFilesAreDrawnOrRefused)
{
    const TestFolder kept;
    const Said said =
        run_mutants(SHEER_TOOL, kept, mutants_of(kOfOwnFiles, SHEER_SOURCE_DIR "/scenes"));
    EXPECT_EQ(said.exit_code, 0) << said.text;
}

TEST(Mutants, OfRealFilesAreDrawnOrRefused)
{
    const char* folder = std::getenv("SHEER_SCENES");
    if (folder == nullptr || !fs::is_directory(folder)) {
        GTEST_SKIP() << "SHEER_SCENES names no folder";
    }
    const TestFolder kept;
    const Said said =
        run_mutants(SHEER_TOOL, kept, "--largest 0.1 " + mutants_of(kOfRealFiles, folder));
    EXPECT_EQ(said.exit_code, 0) << said.text;
}

// ---- faulty tools -----------------------------------------------------------------------------

// A tool that draws the same picture whatever it is given, but for one mutant runs other lines of
// shell; in them $4 is the picture's path, and $picture a good one.
std::string fake_tool(const TestFolder& folder, const std::string& lines)
{
    const std::string path = folder.file("tool");
    std::ofstream(path) << "#!/bin/sh\n"
                        << "picture=" << quoted(SHEER_SOURCE_DIR "/tests/golden/quads-exact-1.png")
                        << "\ncase $2 in */mutant-7/*)\n"
                        << lines << "\nesac\ncp \"$picture\" \"$4\"\n";
    fs::permissions(path, fs::perms::owner_all);
    return path;
}

Said run_fake(const std::string& lines, const TestFolder& folder, const TestFolder& kept)
{
    return run_mutants(fake_tool(folder, lines), kept, "--jobs 2 --seconds 1 12");
}

TEST(Mutants, ToolWithoutFaultPasses)
{
    const TestFolder folder, kept;
    const Said drawn = run_fake(":", folder, kept);
    EXPECT_EQ(drawn.exit_code, 0) << drawn.text;
    EXPECT_NE(drawn.text.find("all             12        12        0       0\n"), std::string::npos)
        << drawn.text;

    const Said refused = run_fake("echo 'sheer: cut short' >&2; exit 2", folder, kept);
    EXPECT_EQ(refused.exit_code, 0) << refused.text;
    EXPECT_NE(refused.text.find("all             12        11        1       0\n"),
              std::string::npos)
        << refused.text;
    EXPECT_EQ(kept.entries(), 0);
}

struct PlantedFault {
    const char* name;
    const char* lines;
    const char* said;
};

void PrintTo(const PlantedFault& fault, std::ostream* out)
{
    *out << fault.name;
}

class MutantsPlanted : public testing::TestWithParam<PlantedFault> {};

TEST_P(MutantsPlanted, IsFound)
{
    const TestFolder folder, kept;
    const Said said = run_fake(GetParam().lines, folder, kept);
    EXPECT_EQ(said.exit_code, 1) << said.text;
    EXPECT_NE(said.text.find(std::string("FAULT mutant-7: ") + GetParam().said), std::string::npos)
        << said.text;
    EXPECT_NE(said.text.find("all             12        11        0       1\n"), std::string::npos)
        << said.text;
    EXPECT_EQ(kept.entries(), 1);
    EXPECT_TRUE(fs::is_directory(kept.file("mutant-7")));
}

constexpr PlantedFault kPlantedFaults[] = {
    {"Crash", "kill -SEGV $$", "ended by signal 11 (SIGSEGV)"},
    {"BusyLoop", "while :; do :; done", "took too much of the processor's time"},
    {"Sleep", "exec sleep 100", "does not end"},
    {"NoMessage", "exit 2", "exit code 2, 0 lines"},
    {"TwoMessages", "printf 'sheer: one\\nsheer: two\\n' >&2; exit 2", "exit code 2, 2 lines"},
    {"ExitCodeThree", "echo 'sheer: cut short' >&2; exit 3", "exit code 3, 1 lines"},
    {"DoneWithAMessage", "echo 'sheer: cut short' >&2; exit 0", "exit code 0, 1 lines"},
    {"FileLeftBehind", "echo 'sheer: cut short' >&2; echo x > \"$4\"; exit 2",
     "exit code 2, 1 lines on standard error, files ['picture.png']"},
    {"RuntimeError", "echo 'a.cpp:1:2: runtime error: overflow' >&2; exit 1",
     "exit code 1, 1 lines"},
    {"UnprintableMessage", "printf 'sheer: \\033[31mred\\n' >&2; exit 2",
     "the message has unprintable letters"},
    {"NoPicture", "exit 0", "exit code 0, 0 lines on standard error, files []"},
    {"HalfAPicture", "head -c 100 \"$picture\" > \"$4\"; exit 0", "the picture is not whole"},
};

INSTANTIATE_TEST_SUITE_P(, MutantsPlanted, testing::ValuesIn(kPlantedFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(Mutants, CommandShowsTheFaultAgain)
{
    const TestFolder folder, kept;
    const Said said = run_fake("echo 'here it is'; exit 42", folder, kept);
    const std::size_t fault = said.text.find("FAULT mutant-7");
    ASSERT_NE(fault, std::string::npos) << said.text;
    const std::size_t start = said.text.find('\n', fault) + 1;
    const Said again = run_command(said.text.substr(start, said.text.find('\n', start) - start));
    EXPECT_EQ(again.exit_code, 42);
    EXPECT_EQ(again.text, "here it is\n");
}

TEST(Mutants, DependOnTheSeedAlone)
{
    const auto check_sums = [](const std::string& seed) {
        const TestFolder folder, kept;
        const std::string log = folder.file("log");
        const std::string tool = fake_tool(folder, ":");
        std::ofstream(tool) << "#!/bin/sh\ncat \"${2%/*}\"/* | cksum >> " << quoted(log) << "\ncp "
                            << quoted(SHEER_SOURCE_DIR "/tests/golden/quads-exact-1.png")
                            << " \"$4\"\n";
        const Said said = run_mutants(tool, kept, "--jobs 1 40 --seed " + seed);
        EXPECT_EQ(said.exit_code, 0) << said.text;
        return text_of(log);
    };
    const std::string once = check_sums("3");
    EXPECT_EQ(once, check_sums("3"));
    EXPECT_NE(once, check_sums("4"));
}

}  // namespace
}  // namespace sheer::test
