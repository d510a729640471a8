// Frames of a whole picture, added up.
#pragma once

#include <array>
#include <vector>

#include "cpu/frame.h"
#include "cpu/quotient.h"

namespace sheer {

// What a method divides is added up apart and divided once: of unbiased sums no bias is left in the
// quotient as frames grow many.
class FrameSums {
public:
    // Of a picture, while frames are added.
    static std::uint64_t bytes(const View& view, bool divides)
    {
        const auto pixels =
            static_cast<std::uint64_t>(view.width) * static_cast<std::uint64_t>(view.height);
        return pixels * sizeof(double) * (divides ? 4 + 5 : 4);
    }

    // As a take that is wanted apart gives it.
    void add(const TakeFrame& frame)
    {
        ++frames_;
        add_to(colors_, frame.image.pixels);
        add_to(fractions_, frame.fraction);
    }

    // The mean of the frames, and of a method that divides the transparent part of it.
    void finish(Image& image, Image& transparent) const
    {
        for (std::size_t i = 0; i < colors_.size(); ++i) {
            for (std::size_t c = 0; c < 4; ++c) image.pixels[i][c] = mean(colors_[i][c]);
        }
        if (fractions_.empty()) return;
        transparent = Image(image.width, image.height);
        for (std::size_t i = 0; i < fractions_.size(); ++i) {
            std::array<float, 5> fraction;
            for (std::size_t c = 0; c < 5; ++c) fraction[c] = mean(fractions_[i][c]);
            transparent.pixels[i] = quotient(fraction);
            for (std::size_t c = 0; c < 3; ++c) image.pixels[i][c] += transparent.pixels[i][c];
        }
    }

private:
    template <std::size_t N>
    static void add_to(std::vector<std::array<double, N>>& sums,
                       const std::vector<std::array<float, N>>& values)
    {
        sums.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            for (std::size_t c = 0; c < N; ++c) sums[i][c] += double{values[i][c]};
        }
    }
    float mean(double sum) const { return static_cast<float>(sum / frames_); }

    int frames_ = 0;
    std::vector<std::array<double, 4>> colors_;
    std::vector<std::array<double, 5>> fractions_;
};

}  // namespace sheer
