// How far long work has come, for whoever watches.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace sheer {

// One line on standard error that redraws itself at most ten times a second and is gone when the
// bar is. Where standard error is not a terminal nothing is written at all.
class ProgressBar {
public:
    explicit ProgressBar(std::string what);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void update(double part);  // done, in [0, 1]; from any thread

private:
    using Clock = std::chrono::steady_clock;

    const std::string what_;
    const bool shown_;
    const Clock::time_point start_;
    std::mutex mutex_;  // guards what follows
    Clock::time_point next_draw_;
    bool drawn_ = false;
};

// The line: what is being done, a bar, percent, elapsed and remaining time; shorter than `columns`,
// for a line that wraps can't be erased.
std::string progress_line(const std::string& what, double part, double elapsed_seconds,
                          int columns);

}  // namespace sheer
