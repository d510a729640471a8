// One picture of a tile, from one frame or several.
#pragma once

#include "cpu/quotient.h"
#include "cpu/tile_mean.h"

namespace sheer {

// Frames are averaged first, and what a method divides is divided once: of unbiased sums no bias is
// left in the quotient as frames grow many.
class TilePicture {
public:
    void clear()
    {
        colors_.clear();
        fraction_.clear();
        divides_ = false;
    }

    void add(const SampleFilter& filter, const SampleColors& samples, bool divides,
             const PixelRect& rect, const PixelRect& interior,
             const std::vector<char>* chosen = nullptr)
    {
        filter.apply<4>(samples, rect, interior, colors_of_frame_);
        colors_.add(colors_of_frame_, chosen);
        divides_ = divides;
        if (!divides) return;
        filter.apply<5>(samples.fraction, rect, interior, fraction_of_frame_);
        fraction_.add(fraction_of_frame_, chosen);
    }

    const PixelValues<4>& pixels()
    {
        pixels_.resize(colors_.size());
        for (std::size_t i = 0; i < colors_.size(); ++i) {
            for (std::size_t c = 0; c < 4; ++c) pixels_[i][c] = color(i, c);
            if (!divides_) continue;
            const Float4 added = transparent(i);
            for (std::size_t c = 0; c < 3; ++c) pixels_[i][c] += added[c];
        }
        return pixels_;
    }

    // Without what a method divides.
    float color(std::size_t i, std::size_t c) const { return colors_.mean(i, c); }

    // Of a method that divides.
    std::array<float, 5> fraction(std::size_t i) const
    {
        std::array<float, 5> mean;
        for (std::size_t c = 0; c < 5; ++c) mean[c] = fraction_.mean(i, c);
        return mean;
    }
    Float4 transparent(std::size_t i) const { return quotient(fraction(i)); }

private:
    bool divides_ = false;
    TileMean<4> colors_;
    TileMean<5> fraction_;
    PixelValues<4> colors_of_frame_, pixels_;
    PixelValues<5> fraction_of_frame_;
};

}  // namespace sheer
