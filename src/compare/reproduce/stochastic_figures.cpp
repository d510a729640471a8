// The figures of E. Enderton et al., "Stochastic Transparency", 2011, that are pictures of scenes:
// with built-in scenes of the same kind, and the errors that the paper leaves to the eye.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/comparison.h"
#include "compare/metrics.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/truth.h"
#include "image/write_image.h"

namespace sheer {

namespace {

constexpr const char* kBasic = "stochastic:masks=stratified:depth-based=off:correction=off";
constexpr const char* kAlphaCorrected = "stochastic:masks=stratified:depth-based=off:correction=on";
constexpr const char* kDepthBased = "stochastic:masks=stratified:depth-based=on:correction=on";

struct Part {
    const char* letter;
    const char* caption;
    const char* method;
    int samples;
};

struct Figure {
    const char* source;
    SamplePositions positions;
    std::vector<Part> parts;
    std::string note;
    Shadows shadows = {};  // of all parts but a reference, whose shadows are exact
};

// Rays through all of a scene take long, so that not every figure with shadows has one.
bool has_exact_shadows(const Figure& figure)
{
    return figure.shadows.kind != ShadowKind::none &&
           std::any_of(figure.parts.begin(), figure.parts.end(),
                       [](const Part& part) { return part.method == nullptr; });
}

int side_of(const ReproduceJob& job)
{
    return job.quick ? 100 : 500;
}

View view_of(const Figure& figure, const ReproduceJob& job)
{
    View view;
    view.width = view.height = side_of(job);
    view.positions = figure.positions;
    view.shadows = figure.shadows;
    return view;
}

View with_exact_shadows(View view)
{
    view.shadows.kind = ShadowKind::exact;
    return view;
}

Image draw_exact(const Scene& scene, const View& view, const ReproduceJob& job)
{
    Options options = job.options;
    options.method = "exact";
    return render(scene, view, options).image;
}

std::vector<Cell> row_of(const Part& part, const Scores& scores)
{
    return {words(part.letter),
            words(part.caption),
            whole(part.samples),
            number(scores.rmse_same_s, 3),
            number(scores.noise.value_or(0), 3),
            number(scores.bias.value_or(0), 3),
            signed_number(scores.bias_mean[0], 4),
            signed_number(scores.bias_mean[1], 4),
            signed_number(scores.bias_mean[2], 4)};
}

void make_figure(const Figure& figure, const ReproduceEntry& entry, const ReproduceJob& job)
{
    const int seeds = job.quick ? 2 : 16;
    Page page(entry, job);
    page.say("`" + std::string(figure.source) + "`, " + std::to_string(side_of(job)) + "x" +
             std::to_string(side_of(job)) + " pixels. " + figure.note);
    Table table{
        "Errors",
        {"picture", "what", "samples", "rmse same S", "noise", "bias", "bias mean r", "g", "b"},
        {}};
    if (has_exact_shadows(figure)) table.columns.emplace_back("rmse, exact shadows");
    const Scene scene = load(figure.source);
    View view = view_of(figure, job);
    std::optional<Image> lit;  // with exact shadows; all parts have as many samples
    std::vector<Image> row;
    double done = 0;
    const auto write = [&](const Part& part, const Image& image) {
        write_image(page.path("." + std::string(part.letter) + ".exr"), image);
        write_image(page.path("." + std::string(part.letter) + ".png"), image);
        row.push_back(image);
        job.progress(++done / static_cast<double>(figure.parts.size()));
    };
    for (const Part& part : figure.parts) {
        view.samples = part.samples;
        // Rays are slow, so that with shadows the reference has no more samples than the parts.
        if (has_exact_shadows(figure) && !lit)
            lit = draw_exact(scene, with_exact_shadows(view), job);
        if (part.method == nullptr) {
            write(part, lit ? *lit : render_truth(scene, view, job.options));
            continue;
        }
        const Image exact = draw_exact(scene, view, job);
        const Compared compared =
            compare_methods(scene, view, job.options, {{part.method}, seeds, 0}, exact).front();
        table.rows.push_back(row_of(part, compared.scores));
        if (lit) {
            table.rows.back().push_back(number(compare_images(compared.image, *lit).rmse, 3));
        }
        write(part, compared.image);
    }
    write_image(page.path(".png"), side_by_side(row));
    std::string caption;
    for (const Part& part : figure.parts) {
        caption += (caption.empty() ? "(" : "; (") + std::string(part.letter) + ") " + part.caption;
    }
    page.show(page.file(".png"), caption);
    page.add(table);
    page.say("Errors are in linear colour times 255, over pixels, red, green and blue, and over " +
             std::to_string(seeds) +
             " seeds, against the exact picture at the same samples. *Noise* is the deviation "
             "over seeds, *bias* what more seeds would not average out, *bias mean* its signed "
             "mean." +
             (has_exact_shadows(figure)
                  ? " *rmse, exact shadows* is that of the picture shown against "
                    "the exact picture with exact shadows: of the method and of "
                    "the shadows together."
                  : ""));
    page.write();
}

// Section 3.6: samples at random out of a large filter; section 5: 16 of them, from a map of 4,096
// x 4,096 samples, each of which is drawn for itself.
Shadows shadows_of_single_samples(const ReproduceJob& job)
{
    Shadows shadows;
    shadows.kind = ShadowKind::stochastic;
    shadows.masks = ShadowMasks::naive;
    shadows.footprint = Footprint::random;
    shadows.size = job.quick ? 512 : 4096;
    shadows.samples = 1;
    shadows.filter = 4;
    return shadows;
}

// One model, as the paper's demonstration shows it.
void make_model_figure(const char* source, const Shadows& shadows, const std::string& note,
                       const ReproduceEntry& entry, const ReproduceJob& job)
{
    const std::string size = std::to_string(shadows.size);
    make_figure({source,
                 SamplePositions::standard,
                 {{"a", "depth based, 8 samples", kDepthBased, 8},
                  {"b", "basic, 8 samples", kBasic, 8},
                  {"c", "exact, over the same shadows", "exact", 8}},
                 note + " Shadows: stochastic, a map of " + size + "x" + size +
                     " texels of one sample, of which each fragment takes 16 at random out of "
                     "16x16.",
                 shadows},
                entry, job);
}

}  // namespace

void reproduce_stochastic_figure_1(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const Shadows shadows = shadows_of_single_samples(job);
    const std::string size = std::to_string(shadows.size);
    // Rays through all of it take a minute at any size.
    const char* source =
        job.quick ? "builtin:windy-hill?hairs=1000&cards=500" : "builtin:windy-hill";
    make_figure({source,
                 SamplePositions::standard,
                 {{"a", "depth based, 8 samples", kDepthBased, 8},
                  {"b", "basic, 8 samples", kBasic, 8},
                  {"c", "exact, over the same shadows", "exact", 8},
                  {"d", "reference, exact shadows", nullptr, 8}},
                 "Shadows: stochastic, a map of " + size + "x" + size +
                     " texels of one sample, of which each fragment takes 16 at random out of "
                     "16x16. The paper has depth-based stochastic transparency with 8 samples, "
                     "16 shadow samples out of a large filter, and, in its table 1, maps of up "
                     "to 4,096x4,096; its scene is its own.",
                 shadows},
                entry, job);
}

void reproduce_stochastic_figure_2(const ReproduceEntry& entry, const ReproduceJob& job)
{
    make_figure({"builtin:motor?alpha=0.3",
                 SamplePositions::center,
                 {{"a", "basic, 8 samples", kBasic, 8},
                  {"b", "basic, 16 samples", kBasic, 16},
                  {"c", "basic, 64 samples", kBasic, 64},
                  {"d", "reference", nullptr, 64}},
                 "Opacity 0.3, no antialiasing, as in the paper, whose model has 322 thousand "
                 "triangles, as this one."},
                entry, job);
}

void reproduce_stochastic_figure_4(const ReproduceEntry& entry, const ReproduceJob& job)
{
    make_figure({"builtin:motor?alpha=0.4",
                 SamplePositions::center,
                 {{"a", "basic", kBasic, 8},
                  {"b", "alpha corrected", kAlphaCorrected, 8},
                  {"c", "depth based", kDepthBased, 8},
                  {"d", "reference", nullptr, 8}},
                 "Opacity 0.4, 8 samples, no antialiasing, as in the paper."},
                entry, job);
}

void reproduce_stochastic_figure_7(const ReproduceEntry& entry, const ReproduceJob& job)
{
    make_model_figure(job.quick ? "builtin:hair?strands=2000" : "builtin:hair?strands=300000",
                      shadows_of_single_samples(job),
                      "After the paper's dog with 300 thousand hairs.", entry, job);
}

void reproduce_stochastic_figure_8(const ReproduceEntry& entry, const ReproduceJob& job)
{
    make_model_figure(job.quick ? "builtin:smoke?shape=plume&particles=500"
                                : "builtin:smoke?shape=plume&particles=100000",
                      shadows_of_single_samples(job),
                      "After the paper's plume of 100 thousand particles.", entry, job);
}

}  // namespace sheer
