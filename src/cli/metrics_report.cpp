// Table, JSON, CSV.
#include "cli/metrics_report.h"

#include <cmath>
#include <limits>

#include "cli/stats_json.h"

namespace sheer {

namespace {

double or_none(const std::optional<double>& value)
{
    return value.value_or(std::numeric_limits<double>::quiet_NaN());  // "-", and null in JSON
}

Json row_json(const MetricsRow& row)
{
    const Scores& s = row.compared.scores;
    Json json = stats_json(row.compared.stats);
    json["seeds"] = row.compared.seeds;
    json["rmse"] = s.rmse;
    json["rmse_same_s"] = s.rmse_same_s;
    json["psnr"] = std::isfinite(s.psnr) ? Json(s.psnr) : Json();
    json["ssim"] = or_none(s.ssim);
    json["flip"] = s.flip;
    json["bias"] = or_none(s.bias);
    json["bias_mean"] = s.bias_mean;
    json["noise"] = or_none(s.noise);
    json["ratio_to_blend"] = s.ratio_to_blend;
    const FilmScores film = row.compared.film.value_or(FilmScores{or_none({}), {}, {}});
    json["rmse_frames"] = film.rmse;
    json["flicker"] = or_none(film.flicker);
    json["ghosting"] = or_none(film.ghosting);
    for (std::size_t i = 0; i < row.compared.failures.size(); ++i) {
        Json& errors = json["failures"][kind_scales()[i].id] = Json::array();
        for (const auto& error : row.compared.failures[i]) errors.push_back(or_none(error));
    }
    json["image"] = row.stem + ".exr";
    json["error_map"] = row.stem + ".error.png";
    return json;
}

std::string cell_of(const Json& json)
{
    if (json.is_string()) return json.get<std::string>();
    const std::string text = json.dump();
    return text == "null" ? "" : text;
}

// Nested objects and arrays become "ms.total" and "bias_mean.0".
void flatten(const Json& json, const std::string& name, std::vector<std::string>& names,
             std::vector<std::string>& cells)
{
    if (!json.is_structured()) {
        names.push_back(name);
        cells.push_back(cell_of(json));
        return;
    }
    std::size_t i = 0;
    for (const auto& item : json.items()) {
        const std::string key = json.is_object() ? item.key() : std::to_string(i++);
        flatten(item.value(), name.empty() ? key : name + "." + key, names, cells);
    }
}

std::string csv_line(const std::vector<std::string>& cells)
{
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        std::string quoted = "\"";
        for (const char c : cells[i]) quoted += c == '"' ? "\"\"" : std::string(1, c);
        const bool plain = cells[i].find_first_of(",\"\n") == std::string::npos;
        line += (i == 0 ? "" : ",") + (plain ? cells[i] : quoted + "\"");
    }
    return line + "\n";
}

}  // namespace

std::string metrics_table(const std::vector<MetricsRow>& rows)
{
    TextTable table{.left = 1, .last_is_prose = false, .rows = {}};
    table.rows.push_back({"method", "S", "rmse", "rmse same S", "psnr", "ssim", "flip", "bias",
                          "bias mean r", "g", "b", "noise", "x blend"});
    const bool film = !rows.empty() && rows.front().compared.film;
    if (film) {
        for (const char* name : {"rmse frames", "flicker", "ghosting"}) {
            table.rows.back().push_back(name);
        }
    }
    for (const MetricsRow& row : rows) {
        const Scores& s = row.compared.scores;
        table.rows.push_back(
            {row.compared.method, std::to_string(row.compared.stats.samples), fixed(s.rmse, 3),
             fixed(s.rmse_same_s, 3), fixed(s.psnr, 2), fixed(or_none(s.ssim), 4), fixed(s.flip, 4),
             fixed(or_none(s.bias), 3), fixed(s.bias_mean[0], 3), fixed(s.bias_mean[1], 3),
             fixed(s.bias_mean[2], 3), fixed(or_none(s.noise), 3), fixed(s.ratio_to_blend, 2)});
        if (!film) continue;
        const FilmScores& f = *row.compared.film;
        for (const double value : {f.rmse, or_none(f.flicker), or_none(f.ghosting)}) {
            table.rows.back().push_back(fixed(value, 3));
        }
    }
    return table.text();
}

Json failures_json(const std::vector<std::vector<std::uint64_t>>& pixels)
{
    Json json = Json::array();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const KindScale& scale = kind_scales()[i];
        Json bands = Json::array();
        for (std::size_t band = 0; band < scale.bands.size(); ++band) {
            bands.push_back({{"name", scale.bands[band]}, {"pixels", pixels[i][band]}});
        }
        json.push_back({{"id", scale.id}, {"title", scale.title}, {"bands", bands}});
    }
    return json;
}

Json metrics_json(const std::vector<MetricsRow>& rows)
{
    Json results = Json::array();
    for (const MetricsRow& row : rows) results.push_back(row_json(row));
    return results;
}

std::string metrics_csv(const std::vector<MetricsRow>& rows)
{
    std::string text;
    for (const MetricsRow& row : rows) {
        Json json = row_json(row);
        // What has not the same keys for every method.
        json["parameters"] = row.compared.stats.parameters;
        json["ms"].erase("passes");
        json.erase("failures");
        std::vector<std::string> names, cells;
        flatten(json, "", names, cells);
        if (text.empty()) text = csv_line(names);
        text += csv_line(cells);
    }
    return text;
}

}  // namespace sheer
