// The data of the page: rows as in metrics.json, pictures as PNG, and a command for each.
#include "cli/compare_report.h"

#include "cli/command_words.h"
#include "compare/error_map.h"
#include "compare/report/report.h"
#include "image/png.h"

namespace sheer {

namespace {

std::string render_command(const CompareReport& report, const MetricsRow& row)
{
    std::vector<std::string> words = {"sheer", "render"};
    words.insert(words.end(), report.shared_words.begin(), report.shared_words.end());
    const std::string samples = std::to_string(row.compared.stats.samples);
    for (const std::string& word :
         {std::string("--method"), row.compared.method, std::string("--samples"), samples,
          std::string("-o"), row.stem + ".png"}) {
        words.push_back(word);
    }
    return shell_line(words);
}

}  // namespace

std::string compare_html(const CompareReport& report)
{
    Json results = metrics_json(report.rows);
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const MetricsRow& row = report.rows[i];
        const Image map = error_map(row.compared.image, report.truth, report.scale);
        results[i]["name"] = row.compared.method;  // with the parameters as they were given
        results[i]["command"] = render_command(report, row);
        results[i]["picture"] = png_address(encode_png(row.compared.image));
        results[i]["error_map"] = png_address(encode_png(map));
    }
    Json colors = Json::array();
    for (const auto& color : error_colors()) colors.push_back(color);
    return report_html({{"tool", "sheer " SHEER_VERSION},
                        {"scene", report.scene},
                        {"command", report.command},
                        {"width", report.truth.width},
                        {"height", report.truth.height},
                        {"truth",
                         {{"samples", report.truth_samples},
                          {"command", report.command},
                          {"picture", png_address(encode_png(report.truth))}}},
                        {"error_map_scale", report.scale},
                        {"colors", colors},
                        {"results", results}});
}

}  // namespace sheer
