// Row by row, pixel by pixel.
#include "compare/reproduce/pictures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sheer {

namespace {

constexpr int kGap = 8;             // pixels
constexpr double kRounding = 1e-6;  // of pictures' floats: below that a deviation is none

}  // namespace

Image side_by_side(std::span<const Image> pictures)
{
    int width = -kGap;
    for (const Image& picture : pictures) width += picture.width + kGap;
    Image row(width, pictures.front().height);
    std::fill(row.pixels.begin(), row.pixels.end(), std::array<float, 4>{1, 1, 1, 1});
    int left = 0;
    for (const Image& picture : pictures) {
        for (int y = 0; y < picture.height; ++y) {
            std::copy_n(&picture.at(0, y), picture.width, &row.at(left, y));
        }
        left += picture.width + kGap;
    }
    return row;
}

Image one_below_another(std::span<const Image> pictures)
{
    int height = -kGap;
    for (const Image& picture : pictures) height += picture.height + kGap;
    Image column(pictures.front().width, height);
    std::fill(column.pixels.begin(), column.pixels.end(), std::array<float, 4>{1, 1, 1, 1});
    int top = 0;
    for (const Image& picture : pictures) {
        std::copy(picture.pixels.begin(), picture.pixels.end(), &column.at(0, top));
        top += picture.height + kGap;
    }
    return column;
}

Image enlarge(const Image& picture, const Crop& crop, int times)
{
    Image large(crop.width * times, crop.height * times);
    for (int y = 0; y < large.height; ++y) {
        for (int x = 0; x < large.width; ++x) {
            large.at(x, y) = picture.at(crop.x + x / times, crop.y + y / times);
        }
    }
    return large;
}

Image over_white(Image picture)
{
    for (std::array<float, 4>& pixel : picture.pixels) {
        for (std::size_t c = 0; c < 3; ++c) pixel[c] += 1 - pixel[3];
        pixel[3] = 1;
    }
    return picture;
}

Moments moments_of(const std::vector<Image>& images)
{
    Moments moments{images.front(), images.front(), static_cast<int>(images.size())};
    const auto n = static_cast<double>(images.size());
    for (std::size_t p = 0; p < moments.mean.pixels.size(); ++p) {
        for (std::size_t c = 0; c < 4; ++c) {
            double mean = 0, sum = 0;
            for (const Image& image : images) mean += image.pixels[p][c] / n;
            for (const Image& image : images) {
                sum += (image.pixels[p][c] - mean) * (image.pixels[p][c] - mean);
            }
            moments.mean.pixels[p][c] = static_cast<float>(mean);
            moments.variance.pixels[p][c] = static_cast<float>(sum / (n - 1));
        }
    }
    return moments;
}

// (m - C)^2 - s^2 / n is 0 on average in each pixel without bias; pixels are independent of one
// another, channels are not, so they are added first. Pixels in which rare noise has not been seen
// count: they are what makes up for those in which it has.
double bias_z(const Moments& moments, const Image& truth)
{
    std::vector<double> excess;
    double mean = 0, sum = 0;
    bool is_noisy = false;
    for (std::size_t p = 0; p < truth.pixels.size(); ++p) {
        double squares = 0, variance = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double off = double{moments.mean.pixels[p][c]} - double{truth.pixels[p][c]};
            squares += off * off;
            variance += moments.variance.pixels[p][c];
        }
        is_noisy = is_noisy || std::sqrt(variance) > kRounding;
        if (std::sqrt(variance) < kRounding && std::sqrt(squares) < kRounding) continue;
        excess.push_back(squares - variance / static_cast<double>(moments.seeds));
    }
    const auto n = static_cast<double>(excess.size());
    if (!is_noisy || n < 2) return std::numeric_limits<double>::quiet_NaN();
    for (const double e : excess) mean += e / n;
    for (const double e : excess) sum += (e - mean) * (e - mean);
    return mean / std::sqrt(sum / (n - 1) / n);
}

}  // namespace sheer
