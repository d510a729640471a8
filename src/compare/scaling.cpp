// The straight line through logarithms, and more layers of the same scene.
#include "compare/scaling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "scene/transparency.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool is_positive(double number)
{
    return number > 0 && std::isfinite(number);
}

double mean(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

std::vector<double> logarithms(std::span<const double> values)
{
    std::vector<double> logs;
    for (const double value : values) logs.push_back(std::log(value));
    return logs;
}

}  // namespace

PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y)
{
    const std::size_t n = std::min(x.size(), y.size());
    if (n < 2 || !std::ranges::all_of(x, is_positive) || !std::ranges::all_of(y, is_positive)) {
        return {kNone, kNone};
    }
    const std::vector<double> u = logarithms(x), v = logarithms(y);
    const double mean_u = mean(u), mean_v = mean(v);
    double uu = 0, uv = 0;
    for (std::size_t i = 0; i < n; ++i) {
        uu += (u[i] - mean_u) * (u[i] - mean_u);
        uv += (u[i] - mean_u) * (v[i] - mean_v);
    }
    const auto [least, most] = std::ranges::minmax(x);
    if (least == most) return {kNone, kNone};
    const double exponent = uv / uu;
    if (n < 3) return {exponent, kNone};
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double off = v[i] - mean_v - exponent * (u[i] - mean_u);
        squares += off * off;
    }
    return {exponent, std::sqrt(squares / static_cast<double>(n - 2) / uu)};
}

std::vector<Object> repeat_transparent(const Scene& scene, int times, bool tests_masks)
{
    std::vector<Object> objects = scene.objects;
    std::uint32_t id = 0;
    for (const Object& object : objects) id = std::max(id, object.id);
    for (int time = 1; time < times; ++time) {
        for (const Object& object : scene.objects) {
            if (!makes_fragments(material_of(scene, object), object, tests_masks)) continue;
            objects.push_back(object);
            objects.back().id = ++id;
        }
    }
    return objects;
}

}  // namespace sheer
