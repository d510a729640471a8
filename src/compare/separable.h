// Filters that are products of one for x and one for y, over a band of a picture's rows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sheer {

// Rows of doubles, one below the other.
class Rows {
public:
    Rows(std::size_t width, std::size_t count) : width_(width), values_(width * count) {}

    std::span<double> operator[](std::size_t row)
    {
        return std::span(values_).subspan(row * width_, width_);
    }
    std::span<const double> operator[](std::size_t row) const
    {
        return std::span(values_).subspan(row * width_, width_);
    }
    std::size_t width() const { return width_; }
    std::size_t count() const { return width_ == 0 ? 0 : values_.size() / width_; }

private:
    std::size_t width_;
    std::vector<double> values_;
};

// Each result is the sum over i of weights[i] * rows[...][x + i], or rows[y + i][x], in the order
// of i: as many fewer columns, or rows, as there are weights but one.
Rows filter_along_x(const Rows& rows, std::span<const double> weights);
Rows filter_along_y(const Rows& rows, std::span<const double> weights);

}  // namespace sheer
