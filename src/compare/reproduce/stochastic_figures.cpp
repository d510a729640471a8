// The figures of E. Enderton et al., "Stochastic Transparency", 2011, that are pictures of scenes:
// with built-in scenes of the same kind, and the errors that the paper leaves to the eye.
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/comparison.h"
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
    const char* note;
};

int side_of(const ReproduceJob& job)
{
    return job.quick ? 100 : 500;
}

View view_of(const Figure& figure, const ReproduceJob& job)
{
    View view;
    view.width = view.height = side_of(job);
    view.positions = figure.positions;
    return view;
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
    const Scene scene = load(figure.source);
    View view = view_of(figure, job);
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
        Options options = job.options;
        if (part.method == nullptr) {
            write(part, render_truth(scene, view, options));
            continue;
        }
        options.method = "exact";
        const Image exact = render(scene, view, options).image;
        Compared compared =
            compare_methods(scene, view, options, {{part.method}, seeds, 0}, exact).front();
        table.rows.push_back(row_of(part, compared.scores));
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
             "mean.");
    page.write();
}

}  // namespace

void reproduce_stochastic_figure_1(const ReproduceEntry& entry, const ReproduceJob& job)
{
    make_figure({"builtin:windy-hill",
                 SamplePositions::standard,
                 {{"a", "depth based, 8 samples", kDepthBased, 8},
                  {"b", "basic, 8 samples", kBasic, 8},
                  {"c", "reference", nullptr, 8}},
                 "The paper shows depth-based stochastic transparency with 8 samples; its scene "
                 "is its own, and also has stochastic shadows."},
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

}  // namespace sheer
