// Sums in double precision, in the order of the numbers.
#include "compare/film_errors.h"

#include <cmath>

#include "compare/metrics.h"

namespace sheer {

namespace {

Channels3 channels_of(const Image& image)
{
    Channels3 result;
    result.reserve(3 * image.pixels.size());
    for (const Float4& p : image.pixels) result.insert(result.end(), {p[0], p[1], p[2]});
    return result;
}

double dot(const Channels3& a, const Channels3& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += double{a[i]} * double{b[i]};
    return sum;
}

void add_times(Channels3& a, double factor, const Channels3& b)
{
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = static_cast<float>(double{a[i]} + factor * double{b[i]});
    }
}

Channels3 difference(const Channels3& a, const Channels3& b)
{
    Channels3 result = a;
    add_times(result, -1, b);
    return result;
}

// What is left of it beside the basis, of length 1, unless that is what rounding leaves: Gram and
// Schmidt's, twice, which is enough.
void extend(std::vector<Channels3>& basis, Channels3 more)
{
    constexpr double kRounding = 1e-5;
    const double length = std::sqrt(dot(more, more));
    for (int again = 0; again < 2; ++again) {
        for (const Channels3& known : basis) add_times(more, -dot(known, more), known);
    }
    const double left = std::sqrt(dot(more, more));
    if (!(left > kRounding * length)) return;
    for (float& value : more) value = static_cast<float>(double{value} / left);
    basis.push_back(std::move(more));
}

double root_mean(double sum, std::size_t count)
{
    return kUnitsOfWhite * std::sqrt(sum / static_cast<double>(count));
}

}  // namespace

void FilmTruth::add(const Image& truth)
{
    frames_.push_back(channels_of(truth));
    if (frames_.size() > kLags.back() + 1) frames_.pop_front();
    basis_.clear();
    for (const std::size_t lag : kLags) {
        if (lag >= frames_.size()) break;
        extend(basis_, difference(frames_[frames_.size() - 1 - lag], now()));
    }
}

void FilmErrors::add(const Image& shown, const FilmTruth& truth)
{
    Channels3 now = channels_of(shown);
    Channels3 error = difference(now, truth.now());
    squares_ += dot(error, error);
    numbers_ += error.size();
    if (truth.has_before() && !before_.empty()) {
        changes_ += error.size();
        for (const Channels3& ghost : truth.ghosts()) {
            const double part = dot(error, ghost);
            ghosting_ += part * part;
        }
        const Channels3 of_truth = difference(truth.now(), truth.before());
        const Channels3 beyond = difference(difference(now, before_), of_truth);
        flicker_ += dot(beyond, beyond);
    }
    before_ = std::move(now);
}

FilmScores FilmErrors::scores() const
{
    FilmScores scores;
    scores.rmse = root_mean(squares_, numbers_);
    if (changes_ == 0) return scores;
    scores.flicker = root_mean(flicker_, changes_);
    scores.ghosting = root_mean(ghosting_, changes_);
    return scores;
}

}  // namespace sheer
