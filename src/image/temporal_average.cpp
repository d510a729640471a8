// Averages of frames.
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include <sheer/film.h>

namespace sheer {

TemporalAverage::TemporalAverage(const TemporalAntialiasing& how) : how_(how) {}

Image TemporalAverage::add(Image frame)
{
    ++count_;
    if (how_.kind == TemporalAntialiasing::Kind::none) return frame;
    if (!frames_.empty() && frames_.back().pixels.size() != frame.pixels.size()) {
        throw std::invalid_argument("frames of different sizes");
    }
    return how_.kind == TemporalAntialiasing::Kind::mean ? mean_with(std::move(frame))
                                                         : average_with(frame);
}

// Of the first frames each counts the same, as long as that is more than the weight.
Image TemporalAverage::average_with(const Image& frame)
{
    const double weight = std::max(double{how_.weight}, 1.0 / static_cast<double>(count_));
    if (frames_.empty()) {
        frames_.push_back(frame);
        return frame;
    }
    Image& average = frames_.front();
    for (std::size_t i = 0; i < average.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            const double before = average.pixels[i][c];
            average.pixels[i][c] =
                static_cast<float>(before + weight * (double{frame.pixels[i][c]} - before));
        }
    }
    return average;
}

// Added up anew each time, so that no rounding stays for ever.
Image TemporalAverage::mean_with(Image frame)
{
    if (frames_.size() == static_cast<std::size_t>(how_.period)) frames_.erase(frames_.begin());
    frames_.push_back(std::move(frame));
    Image mean = frames_.back();
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
            double sum = 0;
            for (const Image& one : frames_) sum += double{one.pixels[i][c]};
            mean.pixels[i][c] = static_cast<float>(sum / static_cast<double>(frames_.size()));
        }
    }
    return mean;
}

}  // namespace sheer
