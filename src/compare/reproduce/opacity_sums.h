// Opacities of pictures of many looks, beside those of the truth.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace sheer {

struct OpacitySums {
    std::vector<double> ours, truth;  // of each look

    void add(double a, double b)
    {
        ours.push_back(a);
        truth.push_back(b);
    }
    double mean_truth() const
    {
        double sum = 0;
        for (const double t : truth) sum += t;
        return sum / static_cast<double>(truth.size());
    }
    double ratio() const
    {
        double sum = 0;
        for (const double a : ours) sum += a;
        return sum / static_cast<double>(ours.size()) / mean_truth();
    }
    // Of one look about that ratio, as part of the mean truth.
    double deviation() const
    {
        const auto n = static_cast<double>(ours.size());
        double squares = 0;
        for (std::size_t i = 0; i < ours.size(); ++i) {
            const double off = ours[i] - ratio() * truth[i];
            squares += off * off;
        }
        return std::sqrt(squares / (n - 1)) / mean_truth();
    }
    // Standard error of a ratio of means.
    double error() const { return deviation() / std::sqrt(static_cast<double>(ours.size())); }
};

}  // namespace sheer
