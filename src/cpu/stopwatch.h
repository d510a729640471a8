// Time spent in a stage, over many starts and stops.
#pragma once

#include <chrono>

namespace sheer {

class Stopwatch {
public:
    void start() { started_ = Clock::now(); }
    void stop() { spent_ += Clock::now() - started_; }
    double ms() const { return std::chrono::duration<double, std::milli>(spent_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point started_;
    Clock::duration spent_{};
};

}  // namespace sheer
