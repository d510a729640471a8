// Figures 9 and 10 of S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency",
// 2011: the motor and the cloth with 4, 16 and 64 samples.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "compare/truth.h"
#include "image/color.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr int kSamples[] = {4, 16, 64};

struct Row {
    const char* title;
    const char* letter;
    const char* method;
    const char* paper[3];  // for each of kSamples
};

struct Figure {
    const char* source;
    Row rows[2];
    const char* ratio;  // of what is printed: ours with 16 samples over the comparison with 64
};

constexpr Figure kMotor = {"builtin:motor?alpha=0.3",
                           {{"the paper's method", "a", kStratified, {"29.5", "10.3", "4.0"}},
                            {"the comparison", "b", kDepthTested, {"36.3", "17.2", "8.7"}}},
                           "1.18"};
constexpr Figure kCloth = {"builtin:cloth?alpha=0.4",
                           {{"the paper's method", "a", kStratified, {"17.0", "5.6", "2.0"}},
                            {"the comparison", "b", kDepthTested, {"19.3", "8.4", "4.1"}}},
                           "1.37"};

// As a screen shows it.
Image encode(Image image)
{
    for (auto& pixel : image.pixels) {
        for (std::size_t c = 0; c < 3; ++c) {
            pixel[c] = static_cast<float>(srgb_from_linear(std::clamp(double{pixel[c]}, 0.0, 1.0)));
        }
    }
    return image;
}

double rmse_of(const std::vector<Image>& images, const Image& truth)
{
    return root_of_mean(mean_squares(images, truth));
}

void make_figure(const Figure& figure, const ReproduceEntry& entry, const ReproduceJob& job)
{
    const int seeds = job.quick ? 1 : 4;
    Page page(entry, job);
    View view;
    view.width = view.height = job.quick ? 100 : 500;
    const Scene scene = load(figure.source);
    // 64 samples instead of 256, in a hurry.
    const Image truth = render_truth(scene, view, job.options, job.quick ? 1 : kTruthPasses);
    const Image encoded_truth = encode(truth);
    job.progress(0.2);
    Claims claims{"a tenth of the paper's number: the models are others, of the same kind", {}};
    const char* const other =
        "another model, of which layers and edges make other errors; "
        "stratified-table-1 says what is known";
    Table table{"Errors",
                {"picture", "what", "samples", "paper", "rmse", "rmse same S", "rmse, encoded"},
                {}};
    std::vector<Image> columns;
    double errors[3][2] = {};
    for (std::size_t i = 0; i < 3; ++i) {
        view.samples = kSamples[i];
        const Image exact = draw_method(scene, view, "exact", job.options);
        std::vector<Image> pictures;
        for (std::size_t r = 0; r < 2; ++r) {
            const Row& row = figure.rows[r];
            std::vector<Image> images = draw_seeds(scene, view, row.method, seeds, job.options);
            errors[i][r] = rmse_of(images, truth);
            const std::string name = row.letter + std::to_string(kSamples[i]);
            table.rows.push_back({words(name), words(row.title), whole(kSamples[i]),
                                  printed(row.paper[i]), number(errors[i][r], 3),
                                  number(rmse_of(images, exact), 3),
                                  number(rmse_of({encode(images.front())}, encoded_truth), 3)});
            claims.all.push_back(
                {std::string(row.title) + ", " + std::to_string(kSamples[i]) + " samples, rmse",
                 row.paper[i], errors[i][r], 0.1 * std::stod(row.paper[i]), other});
            write_image(page.path("." + name + ".png"), images.front());
            pictures.push_back(std::move(images.front()));
        }
        columns.push_back(one_below_another(pictures));
        job.progress(0.2 + 0.8 * static_cast<double>(i + 1) / 3);
    }
    write_image(page.path(".png"), side_by_side(columns));
    page.show(page.file(".png"),
              "Above the paper's method, below the comparison; 4, 16 and 64 samples");
    page.add(table);
    const double ratio = errors[1][0] / errors[2][1];
    claims.all.push_back({"the paper's method with 16 samples over the comparison with 64",
                          figure.ratio, ratio, 0.1 * std::stod(figure.ratio), other});
    page.compare(claims);
    page.say("`" + std::string(figure.source) + "`, " + size_text(view.width, view.height) +
             " pixels, standard positions, " + std::to_string(seeds) +
             (seeds == 1 ? " seed" : " seeds") +
             ". *rmse*: in linear colour times 255, against the exact picture with " +
             std::to_string(truth_samples(view, job.quick ? 1 : kTruthPasses)) +
             " samples; *same S*: at the same samples, so that edges do not count; *encoded*: of "
             "the picture shown, as sRGB. With 16 samples the paper's method has " +
             number(ratio, 2).text + " times the error of the comparison with 64.");
    page.write();
}

}  // namespace

void reproduce_stratified_figure_9(const ReproduceEntry& entry, const ReproduceJob& job)
{
    make_figure(kMotor, entry, job);
}

void reproduce_stratified_figure_10(const ReproduceEntry& entry, const ReproduceJob& job)
{
    make_figure(kCloth, entry, job);
}

}  // namespace sheer
