// SSIM and FLIP by plain loops: whole windows, whole kernels, the C library's functions. Written
// from the papers; shares nothing with src/compare.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <sheer/image.h>

namespace sheer::test {

inline constexpr double kPi = 3.14159265358979323846;

inline double slow_encoded(double linear)
{
    const double v = std::clamp(linear, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

inline double slow_ssim(const Image& a, const Image& b)
{
    double sum = 0;
    int count = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        for (int y = 5; y + 5 < a.height; ++y) {
            for (int x = 5; x + 5 < a.width; ++x, ++count) {
                double weights = 0, ma = 0, mb = 0, va = 0, vb = 0, covariance = 0;
                const auto each = [&](const std::function<void(double, double, double)>& take) {
                    for (int j = -5; j <= 5; ++j) {
                        for (int i = -5; i <= 5; ++i) {
                            take(std::exp(-(i * i + j * j) / (2 * 1.5 * 1.5)),
                                 slow_encoded(a.at(x + i, y + j)[c]),
                                 slow_encoded(b.at(x + i, y + j)[c]));
                        }
                    }
                };
                each([&](double w, double p, double q) {
                    weights += w;
                    ma += w * p;
                    mb += w * q;
                });
                ma /= weights;
                mb /= weights;
                each([&](double w, double p, double q) {
                    va += w / weights * (p - ma) * (p - ma);
                    vb += w / weights * (q - mb) * (q - mb);
                    covariance += w / weights * (p - ma) * (q - mb);
                });
                const double c1 = 1e-4, c2 = 9e-4;
                sum += (2 * ma * mb + c1) / (ma * ma + mb * mb + c1) * (2 * covariance + c2) /
                       (va + vb + c2);
            }
        }
    }
    return sum / count;
}

class SlowFlip {
public:
    double error(const Image& a, const Image& b, int x, int y) const
    {
        const double largest = std::pow(distance(lab({0, 1, 0}), lab({0, 0, 1})), 0.7);
        const double raw = std::pow(distance(lab(filtered(a, x, y)), lab(filtered(b, x, y))), 0.7);
        const double knee = 0.4 * largest;
        const double color =
            raw < knee ? raw * 0.95 / knee : 0.95 + 0.05 * (raw - knee) / (largest - knee);
        const double edge = std::abs(feature(a, x, y, false) - feature(b, x, y, false));
        const double point = std::abs(feature(a, x, y, true) - feature(b, x, y, true));
        const double features = std::sqrt(std::max(edge, point) / std::sqrt(2));
        return std::pow(color, 1 - features);
    }

private:
    using Triple = std::array<double, 3>;
    static constexpr double kPerDegree = 3840 * kPi / 180;

    // XYZ by white's.
    static Triple xyz(const Triple& c)
    {
        const double r = c[0], g = c[1], b = c[2];
        return {(10135552 * r + 8788810 * g + 4435075 * b) / 23359437,
                (2613072 * r + 8788810 * g + 887015 * b) / 12288897,
                (1425312 * r + 8788810 * g + 70074185 * b) / 80288307};
    }

    static Triple opponents(const Triple& v)
    {
        return {116 * v[1] - 16, 500 * (v[0] - v[1]), 200 * (v[1] - v[2])};
    }

    static Triple lab(const Triple& rgb)
    {
        Triple v = xyz(rgb);
        for (double& t : v) {
            t = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
        }
        Triple result = opponents(v);
        result[1] *= result[0] / 100;
        result[2] *= result[0] / 100;
        return result;
    }

    static double distance(const Triple& a, const Triple& b)
    {
        return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
    }

    static Triple pixel(const Image& image, int x, int y)
    {
        const auto& p =
            image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
        Triple rgb{};
        for (std::size_t c = 0; c < 3; ++c) rgb[c] = std::clamp(double{p[c]}, 0.0, 1.0);
        return opponents(xyz(rgb));
    }

    static double gaussians(std::size_t channel, double square)
    {
        const auto one = [&](double a, double b) {
            return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi * square / b);
        };
        if (channel == 0) return one(1, 0.0047);
        if (channel == 1) return one(1, 0.0053);
        return one(34.1, 0.04) + one(13.5, 0.025);
    }

    // Linear RGB. The inverse matrix by Cramer's rule.
    static Triple filtered(const Image& image, int x, int y)
    {
        const int radius = 10;  // ceil(3 sqrt(0.04 / (2 pi^2)) 67.02) = ceil(9.05)
        Triple sum{}, weights{};
        for (int j = -radius; j <= radius; ++j) {
            for (int i = -radius; i <= radius; ++i) {
                const Triple p = pixel(image, x + i, y + j);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double w = gaussians(c, (i * i + j * j) / (kPerDegree * kPerDegree));
                    sum[c] += w * p[c];
                    weights[c] += w;
                }
            }
        }
        for (std::size_t c = 0; c < 3; ++c) sum[c] /= weights[c];
        const double mid = (sum[0] + 16) / 116;
        const Triple goal = {mid + sum[1] / 500, mid, mid - sum[2] / 200};
        const Triple r = xyz({1, 0, 0}), g = xyz({0, 1, 0}), b = xyz({0, 0, 1});
        const double all = determinant(r, g, b);
        Triple rgb = {determinant(goal, g, b) / all, determinant(r, goal, b) / all,
                      determinant(r, g, goal) / all};
        for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
        return rgb;
    }

    static double determinant(const Triple& a, const Triple& b, const Triple& c)
    {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }

    static double feature(const Image& image, int x, int y, bool point)
    {
        const double sigma = 0.041 * kPerDegree;
        const int radius = 9;  // ceil(3 * 2.748)
        double above = 0, below = 0;
        std::array<double, 2> positive{}, negative{};
        for (int j = -radius; j <= radius; ++j) {
            for (int i = -radius; i <= radius; ++i) {
                const double g = std::exp(-(i * i + j * j) / (2 * sigma * sigma));
                const double w = point ? (i * i / (sigma * sigma) - 1) * g : -i * g;
                (w > 0 ? above : below) += std::abs(w);
                const double across = (pixel(image, x + i, y + j)[0] + 16) / 116;
                const double down = (pixel(image, x + j, y + i)[0] + 16) / 116;
                auto& side = w > 0 ? positive : negative;
                side[0] += w * across;
                side[1] += w * down;
            }
        }
        return std::hypot(positive[0] / above + negative[0] / below,
                          positive[1] / above + negative[1] / below);
    }
};

}  // namespace sheer::test
