// The progress bar: its line, silence in a pipe, and what a terminal gets to see.
#include "support/progress.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

namespace sheer {
namespace {

TEST(Progress, LineSaysHowFarAndHowLong)
{
    EXPECT_EQ(progress_line("rendering", 0.5, 90, 80),
              "rendering [############............]  50 %  1:30, 1:30 left");
    EXPECT_EQ(progress_line("rendering", 1, 3725, 80),
              "rendering [########################] 100 %  1:02:05, 0:00 left");
    EXPECT_EQ(progress_line("rendering", 0, 0, 80),
              "rendering [........................]   0 %  0:00");
}

TEST(Progress, LineFitsTheTerminal)
{
    EXPECT_EQ(progress_line("rendering", 0.5, 9, 50), "rendering  50 %  0:09, 0:09 left");
    EXPECT_EQ(progress_line("rendering", 0.5, 9, 30), " 50 %  0:09, 0:09 left");
    for (int columns = 0; columns < 100; ++columns) {
        EXPECT_LT(progress_line("rendering", 0.5, 9, columns).size(),
                  static_cast<std::size_t>(std::max(columns, 1)));
    }
}

TEST(Progress, LineSurvivesOddNumbers)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(progress_line("x", nan, 0, 80), progress_line("x", 0, 0, 80));
    EXPECT_EQ(progress_line("x", -1, 0, 80), progress_line("x", 0, 0, 80));
    EXPECT_EQ(progress_line("x", 7, 0, 80), progress_line("x", 1, 0, 80));
    EXPECT_NE(progress_line("x", 0.01, infinity, 80).find("99:59:59"), std::string::npos);
}

// Standard error is `file` while it lives.
class StandardError {
public:
    explicit StandardError(int file) : before_(dup(STDERR_FILENO)) { dup2(file, STDERR_FILENO); }
    ~StandardError()
    {
        dup2(before_, STDERR_FILENO);
        close(before_);
    }
    StandardError(const StandardError&) = delete;
    StandardError& operator=(const StandardError&) = delete;

private:
    int before_;
};

void run_bar()
{
    ProgressBar bar("rendering");
    bar.update(0.25);
    for (int i = 0; i < 1000; ++i) bar.update(0.5);
}

// All that arrives until nothing has come for a tenth of a second.
std::string read_waiting(int file)
{
    std::string all;
    std::array<char, 4096> text{};
    pollfd waiting{file, POLLIN, 0};
    while (poll(&waiting, 1, 100) > 0) {
        const ssize_t count = read(file, text.data(), text.size());
        if (count <= 0) break;
        all.append(text.data(), static_cast<std::size_t>(count));
    }
    return all;
}

TEST(Progress, SaysNothingInAPipe)
{
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    {
        const StandardError redirected(ends[1]);
        run_bar();
    }
    close(ends[1]);
    EXPECT_EQ(read_waiting(ends[0]), "");
    close(ends[0]);
}

class ProgressOnTerminal : public testing::Test {
protected:
    void SetUp() override
    {
        setenv("TERM", "xterm", 1);
        master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
        if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) {
            GTEST_SKIP() << "no pseudo-terminals";
        }
        terminal_ = open(ptsname(master_), O_RDWR | O_NOCTTY);
        ASSERT_GE(terminal_, 0);
    }
    void TearDown() override
    {
        close(terminal_);
        close(master_);
    }

    int master_ = -1;
    int terminal_ = -1;
};

TEST_F(ProgressOnTerminal, DrawsSeldomAndErasesItself)
{
    {
        const StandardError redirected(terminal_);
        run_bar();
    }
    const std::string seen = read_waiting(master_);
    EXPECT_EQ(seen.rfind("\r\x1b[Krendering [######", 0), 0u) << seen;
    EXPECT_NE(seen.find(" 25 %"), std::string::npos);
    EXPECT_EQ(seen.substr(seen.size() - 4), "\r\x1b[K");
    EXPECT_LT(seen.size(), 1000u);
}

TEST_F(ProgressOnTerminal, SaysNothingToTerminalsWithoutControlSequences)
{
    setenv("TERM", "dumb", 1);
    {
        const StandardError redirected(terminal_);
        run_bar();
    }
    EXPECT_EQ(read_waiting(master_), "");
}

TEST_F(ProgressOnTerminal, TakesUpdatesFromManyThreads)
{
    const StandardError redirected(terminal_);
    ProgressBar bar("rendering");
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&] {
            for (int i = 0; i < 1000; ++i) bar.update(i / 1000.0);
        });
    }
}

}  // namespace
}  // namespace sheer
