// The data of the page: rows as in metrics.json, pictures as PNG, and a command for each.
#include "cli/compare_report.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "cli/command_words.h"
#include "compare/error_map.h"
#include "compare/report/report.h"
#include "image/color.h"

namespace sheer {

namespace {

std::string render_command(const CompareReport& report, const MetricsRow& row)
{
    std::vector<std::string> words = {"sheer", "render"};
    words.insert(words.end(), report.shared_words.begin(), report.shared_words.end());
    const std::string samples = std::to_string(row.compared.stats.samples);
    for (const std::string& word :
         {std::string("--method"), row.compared.method, std::string("--samples"), samples,
          std::string("-o"), row.stem + (report.film ? ".####.png" : ".png")}) {
        words.push_back(word);
    }
    return shell_line(words);
}

// Five digits are more than a chart shows.
double short_number(double value)
{
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 5);
    double result = 0;
    std::from_chars(text, end.ptr, result);
    return result;
}

// [[x, y, [[depth, behind, opacity, coverage, sRGB red, green, blue], ...], whether there were too
// many], ...]
Json probes_json(const std::vector<Probe>& probes)
{
    Json json = Json::array();
    for (const Probe& probe : probes) {
        Json steps = Json::array();
        for (const ProbeStep& step : probe.steps) {
            Json numbers = Json::array();
            for (const double value :
                 {double{step.depth}, step.behind, double{step.opacity}, double{step.coverage}}) {
                numbers.push_back(short_number(value));
            }
            for (const float channel : step.color) numbers.push_back(srgb8_from_linear(channel));
            steps.push_back(std::move(numbers));
        }
        Json one = Json::array({probe.x, probe.y});
        one.push_back(std::move(steps));
        one.push_back(probe.too_many);
        json.push_back(std::move(one));
    }
    return json;
}

// {methods: [...], pixels: [[[distance, ...], [thousandths, ...] of each method], ...]}
Json curves_json(const ProbeCurves& curves)
{
    Json pixels = Json::array();
    for (const ProbeCurves::Pixel& pixel : curves.pixels) {
        Json lists = Json::array({Json::array()});
        for (const double distance : pixel.distances) lists[0].push_back(short_number(distance));
        for (const std::vector<double>& values : pixel.values) {
            Json thousandths = Json::array();
            for (const double value : values) thousandths.push_back(std::lround(1000 * value));
            lists.push_back(std::move(thousandths));
        }
        pixels.push_back(std::move(lists));
    }
    Json json = {{"methods", curves.methods}};
    json["pixels"] = std::move(pixels);
    return json;
}

}  // namespace

std::string compare_html(CompareReport report)
{
    Json results = metrics_json(report.rows);
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const MetricsRow& row = report.rows[i];
        ReportPictures::OfRow& pictures = report.pictures.of_rows[i];
        results[i]["name"] = row.compared.method;  // with the parameters as they were given
        results[i]["command"] = render_command(report, row);
        results[i]["picture"] = std::move(pictures.picture);
        results[i]["error_map"] = std::move(pictures.error_map);
    }
    Json colors = Json::array();
    for (const auto& color : error_colors()) colors.push_back(color);
    Json data = {{"tool", "sheer " SHEER_VERSION},
                 {"scene", report.scene},
                 {"command", report.command},
                 {"width", report.width},
                 {"height", report.height},
                 {"truth", {{"samples", report.truth_samples}, {"command", report.command}}},
                 {"error_map_scale", report.pictures.scale},
                 {"colors", colors},
                 {"failures", failures_json(report.kinds)}};
    // What may be large is moved: a list of pairs would be copied.
    data["truth"]["picture"] = std::move(report.pictures.truth);
    data["probes"] = probes_json(report.probes);
    data["curves"] = curves_json(report.curves);
    data["results"] = std::move(results);
    return report_html(data);
}

}  // namespace sheer
