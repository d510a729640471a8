// How far pictures are from one another, and how far a random method is from the truth.
//
// Everything is in linear, premultiplied colour times 255, not clamped, over red, green and blue;
// alpha does not count. Sums are in double precision and in a fixed order.
#pragma once

#include <array>
#include <optional>

#include <sheer/image.h>

namespace sheer {

// A unit of what is measured here, in linear colour: 255 of them are white.
inline constexpr double kUnitsOfWhite = 255;

struct Difference {
    double rmse = 0;                    // root of the mean square over pixels and channels
    double psnr = 0;                    // dB, peak 1: psnr_of(rmse)
    std::array<double, 3> bias_mean{};  // signed mean of a - b
    double largest = 0;                 // absolute, in one channel
    int largest_x = 0, largest_y = 0;   // where that is; the first such pixel, row by row
};

// Throws Error(Fault::input) where the sizes differ, or are 0. Where first_not_finite finds a
// pixel, `rmse` and `largest` are infinite or NaN.
Difference compare_images(const Image& a, const Image& b);

// 20 log10(255 / rmse); infinite if rmse is 0.
double psnr_of(double rmse);

// Every bit of every pixel, alpha too.
bool same_bits(const Image& a, const Image& b);

struct Pixel {
    int x, y;
};

// The first pixel of `a`, row by row, with a colour that is infinite or NaN and not the same in
// `b`: what compare_images could not measure.
std::optional<Pixel> first_not_finite(const Image& a, const Image& b);

// a - b for one channel, in linear colour; 0 where both hold the same bits, infinity and NaN too.
double channel_difference(float a, float b);

// Throws what compare_images throws.
void check_sizes(const Image& a, const Image& b);

// The pictures of a random method for n seeds, pixel by pixel.
struct Moments {
    Image mean;      // m
    Image variance;  // s^2, of the sample: n - 1; 0 where n = 1
    int seeds = 0;   // n
};

// The standard deviation of one picture: sqrt(mean(s^2)), over pixels and channels as everywhere
// below. Says nothing where n = 1.
double noise(const Moments& moments);

// What would be left of the error with any number of seeds: sqrt(max(0, mean((m - C)^2 - s^2/n))),
// with C the truth. The mean of n seeds is off by s^2/n on average even where there is no bias,
// hence the second term. Where n = 1 that is unknown, and the result is rmse's.
double bias(const Moments& moments, const Image& truth);

// The signed mean of m - C.
std::array<double, 3> bias_mean(const Moments& moments, const Image& truth);

// The root of the mean, over the seeds, of the mean square error of one picture. With x_i the value
// for seed i, the sum over i of (x_i - m) is 0, so that
//     (1/n) sum (x_i - C)^2 = (m - C)^2 + (1/n) sum (x_i - m)^2 = (m - C)^2 + s^2 (n - 1)/n.
double rmse(const Moments& moments, const Image& truth);

}  // namespace sheer
