// How a method's pictures change from frame to frame, beside how the truth does.
//
// In the units of compare/metrics.h, over all frames but the first, pixels, red, green and blue,
// with m the method's picture and C the truth, in frame t:
//     flicker   root mean square of (m_t - m_(t-1)) - (C_t - C_(t-1))
//     ghosting  root mean square of the part of m_t - C_t that earlier truth frames explain: of its
//               projection on the C_(t-k) - C_t, k = 1, 2, 4 and 8, those that there are.
// A mean of truth frames has nothing but ghosts for an error, noise and lost or thickened surfaces
// have next to none: of noise of deviation s in N numbers 4 s / N of the square.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include <sheer/image.h>
#include <sheer/scene.h>

namespace sheer {

// A picture's red, green and blue, one after the other.
using Channels3 = std::vector<float>;

// The truth's frames, as far back as they are needed.
class FilmTruth {
public:
    static constexpr std::array<std::size_t, 4> kLags = {1, 2, 4, 8};
    // Of a picture's own bytes, what this keeps of each pixel, and in the making.
    static constexpr std::size_t kBytesPerPixel = 3 * sizeof(float) * (9 + kLags.size() + 1);

    void add(const Image& truth);

    const Channels3& now() const { return frames_.back(); }
    bool has_before() const { return frames_.size() > 1; }
    const Channels3& before() const { return frames_[frames_.size() - 2]; }
    // An orthonormal basis of the differences from earlier frames.
    std::span<const Channels3> ghosts() const { return basis_; }

private:
    std::deque<Channels3> frames_;
    std::vector<Channels3> basis_;
};

struct FilmScores {
    double rmse = 0;                 // against the truth, over all frames
    std::optional<double> flicker;   // none of one frame
    std::optional<double> ghosting;  // likewise
};

// Of one method, frame by frame, each after the truth has it.
class FilmErrors {
public:
    void add(const Image& shown, const FilmTruth& truth);
    FilmScores scores() const;

private:
    Channels3 before_;
    double squares_ = 0, flicker_ = 0, ghosting_ = 0;
    std::size_t numbers_ = 0, changes_ = 0;
};

}  // namespace sheer
