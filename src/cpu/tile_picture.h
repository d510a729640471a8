// One picture of a tile, from one frame or several.
#pragma once

#include "cpu/tile_mean.h"
#include "lanes/lone.h"

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
            for (std::size_t c = 0; c < 4; ++c) pixels_[i][c] = colors_.mean(i, c);
            if (!divides_) continue;
            const Float4 added = transparent(i);
            for (std::size_t c = 0; c < 3; ++c) pixels_[i][c] += added[c];
        }
        return pixels_;
    }

    // Of a method that divides: what is added to the dimmed background, and total alpha.
    Float4 transparent(std::size_t i) const
    {
        const auto mean = [&](std::size_t c) { return fraction_.mean(i, c); };
        const Text::real3 corrected =
            Text::alpha_corrected({mean(0), mean(1), mean(2)}, mean(3), mean(4));
        return {corrected.x, corrected.y, corrected.z, mean(4)};
    }

private:
    struct Text {
        using L = Lone<float>;
#include "lanes/text_words.h"
#include "sheer/alpha_correction.glsl"
    };

    bool divides_ = false;
    TileMean<4> colors_;
    TileMean<5> fraction_;
    PixelValues<4> colors_of_frame_, pixels_;
    PixelValues<5> fraction_of_frame_;
};

}  // namespace sheer
