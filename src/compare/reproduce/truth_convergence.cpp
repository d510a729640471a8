// The truth itself: what more samples would change of the picture that everything is measured by.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/chart.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/truth.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr int kPasses[] = {1, 2, 4, 8};
constexpr int kMost = 16;

const std::vector<std::string> kScenes = {"builtin:motor", "builtin:cloth", "builtin:hair",
                                          "builtin:smoke", "builtin:quads"};
const std::vector<std::string> kQuickScenes = {"builtin:motor?detail=0.2", "builtin:quads"};

struct Errors {
    std::vector<double> rmse;  // for each of kPasses, against kMost
    double largest = 0;        // of a channel, with the usual passes
    double method = 0;         // of `exact` with 8 samples, against the usual passes
};

Errors errors_of(const Scene& scene, const View& view, const ReproduceJob& job)
{
    Errors errors;
    const Image most = render_truth(scene, view, job.options, kMost);
    Image usual;
    for (const int passes : kPasses) {
        Image image = render_truth(scene, view, job.options, passes);
        const Difference difference = compare_images(image, most);
        errors.rmse.push_back(difference.rmse);
        if (passes != kTruthPasses) continue;
        errors.largest = difference.largest;
        usual = std::move(image);
    }
    View eight = view;
    eight.samples = 8;
    Options options = job.options;
    options.method = "exact";
    errors.method = compare_images(render(scene, eight, options).image, usual).rmse;
    return errors;
}

}  // namespace

void reproduce_truth_convergence(const ReproduceEntry& entry, const ReproduceJob& job)
{
    View view;
    view.width = view.height = job.quick ? 48 : 128;
    Page page(entry, job);
    Table table{"Differences from 1,024 samples",
                {"scene", "64 samples", "128", "256", "512", "exponent", "largest, 256",
                 "exact with 8 samples, from 256"},
                {}};
    std::vector<Series> lines;
    double done = 0;
    const std::vector<std::string>& scenes = job.quick ? kQuickScenes : kScenes;
    for (const std::string& source : scenes) {
        const Errors errors = errors_of(load(source), view, job);
        Series line{source, {}, errors.rmse};
        std::vector<Cell> row = {words(source)};
        for (std::size_t i = 0; i < std::size(kPasses); ++i) {
            line.x.push_back(64.0 * kPasses[i]);
            row.push_back(number(errors.rmse[i], 4));
        }
        row.push_back(signed_number(log_log_slope(line), 2));
        row.push_back(number(errors.largest, 2));
        row.push_back(number(errors.method, 3));
        table.rows.push_back(std::move(row));
        lines.push_back(std::move(line));
        job.progress(++done / static_cast<double>(scenes.size()));
    }
    page.add(table);
    page.write_text(".svg", log_log_chart("Root mean square difference from 1,024 samples", lines));
    page.show(page.file(".svg"), "What more samples change of the truth");
    page.say("Root mean squares in linear colour times 255, " + size_text(view.width, view.height) +
             " pixels. The truth of `compare` has 256 samples, four passes of 64; here are one to "
             "sixteen. The first passes are among the sixteen, so that the error of n passes is "
             "more than the difference: by 1 / sqrt(1 - n / 16) if passes were independent, 1.15 "
             "times for 256 samples. *Exponent*: of the number of samples, -0.65 for independent "
             "passes among those they are measured by. The last column is what edges alone cost a "
             "method that makes no other error.");
    page.write();
}

}  // namespace sheer
