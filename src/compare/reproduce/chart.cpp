// Points to pixels by the logarithm to base 2 across, and up to base 10 or evenly.
#include "compare/reproduce/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/svg.h"
#include "support/math.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr double kWidth = 700, kHeight = 420;
constexpr double kLeft = 70, kRight = 290, kTop = 40, kBottom = 50;

using svg::kColors;
using svg::text_at;

double log10_of(double x)
{
    return own_log(x) / own_log(10);
}

bool is_drawn(double x, double y)
{
    return x > 0 && y > 0 && std::isfinite(y);
}

struct Plot {
    double least_x = 1e300, most_x = -1e300, least_y = 1e300, most_y = -1e300;  // logarithms
    bool has_infinity = false;
    bool is_even = false;  // upwards

    bool draws(double x, double y) const { return is_drawn(x, y) || (is_even && x > 0 && y == 0); }
    double step_y() const { return is_even ? 0.2 : 1; }
    double up(double y) const { return is_even ? y : log10_of(y); }
    void take(double x, double y)
    {
        if (std::isfinite(x)) {
            least_x = std::min(least_x, own_log2(x));
            most_x = std::max(most_x, own_log2(x));
        }
        has_infinity = has_infinity || !std::isfinite(x);
        least_y = is_even ? 0 : std::min(least_y, std::floor(up(y)));
        most_y = std::max(most_y, step_y() * std::ceil(up(y) / step_y()));
    }
    double end_x() const { return most_x + (has_infinity ? 1 : 0); }
    double log2_of(double x) const { return std::isfinite(x) ? own_log2(x) : end_x(); }
    double across(double log2_x) const
    {
        return kLeft +
               (log2_x - least_x) / std::max(1.0, end_x() - least_x) * (kWidth - kLeft - kRight);
    }
    double down(double up_y) const
    {
        return kTop +
               (most_y - up_y) / std::max(step_y(), most_y - least_y) * (kHeight - kTop - kBottom);
    }
};

std::string grid_line(svg::Point a, svg::Point b)
{
    return svg::line_between(a, b, "stroke=\"#ccc\"");
}

// A power of two, in as few digits as say which.
std::string power_text(double log2_x)
{
    return log2_x < 0 ? "1/" + fixed(std::ldexp(1, static_cast<int>(-log2_x)), 0)
                      : fixed(std::ldexp(1, static_cast<int>(log2_x)), 0);
}

std::string axes(const Plot& plot, const std::string& across)
{
    std::string svg;
    for (double x = plot.least_x; x <= plot.end_x(); ++x) {
        svg += grid_line({plot.across(x), kTop}, {plot.across(x), kHeight - kBottom});
        svg += text_at({plot.across(x), kHeight - kBottom + 18},
                       x > plot.most_x ? "infinity" : power_text(x), " text-anchor=\"middle\"");
    }
    const double steps = (plot.most_y - plot.least_y) / plot.step_y();
    for (int i = 0; i <= steps + 0.5; ++i) {
        const double y = plot.least_y + i * plot.step_y();
        svg += grid_line({kLeft, plot.down(y)}, {kWidth - kRight, plot.down(y)});
        svg += text_at({kLeft - 8, plot.down(y) + 4},
                       plot.is_even ? fixed(y, 1) : "1e" + fixed(y, 0), " text-anchor=\"end\"");
    }
    return svg + text_at({(kLeft + kWidth - kRight) / 2, kHeight - 10}, across,
                         " text-anchor=\"middle\"");
}

std::string chart_in(Plot plot, const std::string& title, const std::vector<Series>& series,
                     const std::string& across)
{
    for (const Series& s : series) {
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (plot.draws(s.x[i], s.y[i])) plot.take(s.x[i], s.y[i]);
        }
    }
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + fixed(kWidth, 0) +
                      "\" height=\"" + fixed(kHeight, 0) +
                      "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    svg += text_at({kLeft, 24}, title, " font-size=\"14\"") + axes(plot, across);
    for (std::size_t k = 0; k < series.size(); ++k) {
        // Dashed from the eighth on.
        const std::string dashes[] = {"", " stroke-dasharray=\"7 3\"", " stroke-dasharray=\"2 3\""};
        const std::string color = kColors[k % std::size(kColors)];
        const std::string style = "fill=\"none\" stroke-width=\"2\" stroke=\"" + color + "\"" +
                                  dashes[k / std::size(kColors) % std::size(dashes)];
        std::string points;
        for (std::size_t i = 0; i < series[k].x.size(); ++i) {
            if (!plot.draws(series[k].x[i], series[k].y[i])) continue;
            points += fixed(plot.across(plot.log2_of(series[k].x[i])), 1) + "," +
                      fixed(plot.down(plot.up(series[k].y[i])), 1) + " ";
        }
        if (points.empty()) continue;
        svg += "<polyline " + style + " points=\"" + points + "\"/>\n";
        const double legend = kWidth - kRight + 12, y = kTop + 14 + 20 * static_cast<double>(k);
        svg += "<path " + style + " d=\"M" + fixed(legend, 1) + " " + fixed(y - 4, 1) + "h20\"/>\n";
        svg += text_at({legend + 26, y}, series[k].title, " fill=\"" + color + "\"");
    }
    return svg + "</svg>\n";
}

}  // namespace

std::string log_log_chart(const std::string& title, const std::vector<Series>& series,
                          const std::string& across)
{
    return chart_in({}, title, series, across);
}

std::string log_linear_chart(const std::string& title, const std::vector<Series>& series,
                             const std::string& across)
{
    Plot plot;
    plot.is_even = true;
    return chart_in(plot, title, series, across);
}

double log_log_slope(const Series& series)
{
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!is_drawn(series.x[i], series.y[i]) || !std::isfinite(series.x[i])) continue;
        const double x = own_log(series.x[i]), y = own_log(series.y[i]);
        n += 1;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    if (n < 2) return std::numeric_limits<double>::quiet_NaN();
    return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

}  // namespace sheer
