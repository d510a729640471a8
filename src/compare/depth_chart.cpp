// Lines of SVG. Points that the line between their neighbours passes anyway are left out.
#include "compare/depth_chart.h"

#include <algorithm>
#include <cmath>

#include "compare/svg.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr double kPlotWidth = 520, kPlotHeight = 320;
constexpr double kLeft = 56, kTop = 40, kBottom = 48;
constexpr double kLetter = 7.5, kLine = 18;  // of the legend, at 12 pixels
// What a point may be off the line without being drawn: less than anybody sees.
constexpr double kOff = 0.05;

using svg::kColors;
using svg::line_between;
using svg::Point;
using svg::text_at;

// What is drawn: distances from left to right, values from the bottom up.
struct Plot {
    double from, to, most;

    double across(double x) const { return kLeft + (x - from) / (to - from) * kPlotWidth; }
    double down(double y) const { return kTop + (1 - y / most) * kPlotHeight; }
};

Plot plot_of(const std::vector<double>& distances, const std::vector<DepthCurve>& curves)
{
    double most = 1;
    for (const DepthCurve& curve : curves) {
        for (const double y : curve.values) {
            if (std::isfinite(y)) most = std::max(most, y);
        }
    }
    const double from = distances.empty() ? 0 : distances.front();
    const double to = distances.empty() ? 1 : distances.back();
    return {from, to > from ? to : from + 1, std::ceil(most * 5 - 1e-9) / 5};
}

// 1, 2 or 5 times a power of ten, of which five or more lie between.
struct Spacing {
    double step;
    int digits;
};
Spacing spacing_of(double extent)
{
    double power = 1;
    int digits = 0;
    for (; power * 5 > extent && digits < 9; ++digits) power /= 10;
    for (; power * 50 <= extent; power *= 10) {
    }
    const double factor = power * 25 <= extent ? 5 : power * 10 <= extent ? 2 : 1;
    return {factor * power, digits};
}

std::string axes(const Plot& plot)
{
    const std::string grid = "stroke=\"#ddd\"";
    std::string svg;
    const Spacing spacing = spacing_of(plot.to - plot.from);
    const double first = std::ceil(plot.from / spacing.step - 1e-9);
    for (double i = first; i * spacing.step <= plot.to + 1e-9 * spacing.step; ++i) {
        const double x = plot.across(i * spacing.step);
        svg += line_between({x, kTop}, {x, kTop + kPlotHeight}, grid);
        svg += text_at({x, kTop + kPlotHeight + 16}, fixed(i * spacing.step, spacing.digits),
                       " text-anchor=\"middle\"");
    }
    for (int i = 0; i <= static_cast<int>(plot.most * 5 + 0.5); ++i) {
        const double y = plot.down(i / 5.0);
        svg += line_between({kLeft, y}, {kLeft + kPlotWidth, y}, grid);
        svg += text_at({kLeft - 6, y + 4}, fixed(i / 5.0, 1), " text-anchor=\"end\"");
    }
    svg += text_at({kLeft + kPlotWidth / 2, kTop + kPlotHeight + 36}, "distance from the eye, m",
                   " text-anchor=\"middle\"");
    const std::string middle = fixed(kTop + kPlotHeight / 2, 1);
    return svg + text_at({14, kTop + kPlotHeight / 2}, "transmittance",
                         " text-anchor=\"middle\" transform=\"rotate(-90 14 " + middle + ")\"");
}

// Whether the line from a to b passes all points between.
bool passes(const std::vector<Point>& points, std::size_t a, std::size_t b)
{
    const Point from = points[a], to = points[b];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    for (std::size_t i = a + 1; i < b; ++i) {
        const double x = points[i].x - from.x, y = points[i].y - from.y;
        const double off = length > 0 ? std::abs(x * (to.y - from.y) - y * (to.x - from.x)) / length
                                      : std::hypot(x, y);
        if (off > kOff) return false;
    }
    return true;
}

std::string polyline(const std::vector<Point>& points, const std::string& style)
{
    std::string svg = "<polyline fill=\"none\" " + style + " points=\"";
    for (std::size_t i = 0; i < points.size();) {
        svg += fixed(points[i].x, 1) + "," + fixed(points[i].y, 1) + " ";
        std::size_t next = i + 1;
        // Bounded, so that time is proportional to the points.
        while (next + 1 < points.size() && next - i < 64 && passes(points, i, next + 1)) ++next;
        i = next;
    }
    return svg + "\"/>\n";
}

// The first curve is black; those after the seventh are dashed.
std::string style_of(std::size_t k)
{
    if (k == 0) return "stroke=\"#000\" stroke-width=\"3\"";
    constexpr std::size_t kOthers = std::size(kColors) - 1;  // than black
    std::string style =
        "stroke=\"" + std::string(kColors[1 + (k - 1) % kOthers]) + "\" stroke-width=\"1.5\"";
    const std::size_t round = (k - 1) / kOthers;
    if (round > 0) style += round == 1 ? " stroke-dasharray=\"6 3\"" : " stroke-dasharray=\"2 2\"";
    return style;
}

}  // namespace

std::string depth_chart(const std::string& title, const std::vector<double>& distances,
                        const std::vector<DepthCurve>& curves)
{
    const Plot plot = plot_of(distances, curves);
    std::size_t longest = 0;
    for (const DepthCurve& curve : curves) longest = std::max(longest, curve.title.size());
    const double legend = kLeft + kPlotWidth + 16;
    const double width = legend + 30 + kLetter * static_cast<double>(longest);
    const double height = std::max(kTop + kPlotHeight + kBottom,
                                   kTop + kLine * static_cast<double>(curves.size() + 1));
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + fixed(width, 0) +
                      "\" height=\"" + fixed(height, 0) +
                      "\" font-family=\"sans-serif\" font-size=\"12\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    svg += text_at({kLeft, 24}, title, " font-size=\"14\"") + axes(plot);
    for (std::size_t k = 0; k < curves.size(); ++k) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const double y = curves[k].values[i];
            if (std::isfinite(y)) points.push_back({plot.across(distances[i]), plot.down(y)});
        }
        if (!points.empty()) svg += polyline(points, style_of(k));
        const double y = kTop + 8 + kLine * static_cast<double>(k);
        svg += line_between({legend, y}, {legend + 22, y}, style_of(k));
        svg += text_at({legend + 28, y + 4}, curves[k].title);
    }
    return svg + "</svg>\n";
}

}  // namespace sheer
