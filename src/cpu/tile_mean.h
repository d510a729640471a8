// The mean of several pictures of a tile, and their variance.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "cpu/filter.h"

namespace sheer {

// Sums are those of differences from the first picture, in doubles: one picture is its own mean,
// bit for bit, and what hardly varies loses no digits.
template <int Channels>
class TileMean {
public:
    void clear() { empty_ = true; }

    // Of later pictures some pixels may be left out.
    void add(const PixelValues<Channels>& pixels, const std::vector<char>* chosen = nullptr)
    {
        if (empty_) {
            empty_ = false;
            one_ = true;
            first_ = pixels;
            return;
        }
        if (one_) {
            one_ = false;
            counts_.assign(pixels.size(), 1);
            sums_.assign(pixels.size(), {});
            squares_.assign(pixels.size(), {});
        }
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (chosen != nullptr && (*chosen)[i] == 0) continue;
            ++counts_[i];
            for (std::size_t c = 0; c < Channels; ++c) {
                const double d = double{pixels[i][c]} - double{first_[i][c]};
                sums_[i][c] += d;
                squares_[i][c] += d * d;
            }
        }
    }

    std::size_t size() const { return first_.size(); }  // pixels
    float mean(std::size_t i, std::size_t c) const
    {
        if (one_) return first_[i][c];
        return static_cast<float>(double{first_[i][c]} + sums_[i][c] / counts_[i]);
    }
    // Of one picture, divided by their number less 1; 0 of a single one.
    float variance(std::size_t i, std::size_t c) const
    {
        if (one_ || counts_[i] < 2) return 0.0f;
        const double rest = squares_[i][c] - sums_[i][c] * sums_[i][c] / counts_[i];
        return static_cast<float>(std::max(rest, 0.0) / (counts_[i] - 1));
    }

private:
    bool empty_ = true;
    bool one_ = false;  // `first_` is all; the sums are not made yet
    std::vector<int> counts_;
    PixelValues<Channels> first_;
    std::vector<std::array<double, static_cast<std::size_t>(Channels)>> sums_, squares_;
};

}  // namespace sheer
