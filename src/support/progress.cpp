// The progress bar. "\r" and the control sequence EL (ECMA-48, 8.3.41) redraw and erase the line;
// terminals that know neither (TERM=dumb, or unset) are treated like a pipe.
#include "support/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <sys/ioctl.h>
#include <unistd.h>

namespace sheer {
namespace {

constexpr auto kRedrawInterval = std::chrono::milliseconds(100);
constexpr const char* kEraseLine = "\r\x1b[K";

bool is_watched()
{
    const char* terminal = std::getenv("TERM");
    return isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string(terminal) != "dumb";
}

int terminal_columns()
{
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : 80;
}

std::string clock_text(double seconds)
{
    constexpr double kLongest = 359'999;  // 99:59:59
    const long s = std::lround(std::clamp(seconds, 0.0, kLongest));
    char text[32];
    if (s >= 3600) {
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
    } else {
        std::snprintf(text, sizeof text, "%ld:%02ld", s / 60, s % 60);
    }
    return text;
}

}  // namespace

std::string progress_line(const std::string& what, double part, double elapsed_seconds, int columns)
{
    constexpr std::size_t kBarWidth = 24;
    part = part >= 0 ? std::min(part, 1.0) : 0;  // NaN counts as nothing done
    // Rounded down: 100 % means done.
    const int percent = static_cast<int>(std::floor(part * 100));
    std::string numbers = std::to_string(percent) + " %  " + clock_text(elapsed_seconds);
    numbers.insert(0, numbers.find(' ') < 3 ? 3 - numbers.find(' ') : 0, ' ');
    // Before that the estimate is too wild to be of use.
    if (part >= 0.01) {
        numbers += ", " + clock_text(elapsed_seconds * (1 - part) / part) + " left";
    }
    const auto filled = static_cast<std::size_t>(part * static_cast<double>(kBarWidth));
    std::string bar = "[";
    bar.append(filled, '#').append(kBarWidth - filled, '.').append("] ");

    const std::size_t room = columns > 1 ? static_cast<std::size_t>(columns) - 1 : 0;
    std::string line = what + " " + bar + numbers;
    if (line.size() > room) line = what + " " + numbers;
    if (line.size() > room) line = numbers;
    return line.substr(0, room);
}

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)), shown_(is_watched()), start_(Clock::now()), next_draw_(start_)
{
}

ProgressBar::~ProgressBar()
{
    if (!drawn_) return;
    std::fputs(kEraseLine, stderr);
    std::fflush(stderr);
}

void ProgressBar::update(double part)
{
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    const Clock::time_point now = Clock::now();
    if (now < next_draw_) return;
    next_draw_ = now + kRedrawInterval;
    drawn_ = true;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const std::string line = progress_line(what_, part, elapsed, terminal_columns());
    // In one piece, so that other lines on the terminal don't cut it.
    std::fputs((kEraseLine + line).c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace sheer
