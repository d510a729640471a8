// The two strips of pictures of C. Wyman's talk, "Exploring and Expanding the Continuum of OIT
// Algorithms", HPG 2016, with built-in scenes of the same kind.
#include <algorithm>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/report/report.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "compare/svg.h"
#include "image/png.h"
#include "image/write_image.h"
#include "methods/method.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr int kSide = 300;  // of the pictures, pixels
constexpr int kTimes = 3;   // parts of them are enlarged
constexpr double kGap = 8, kLine = 16;

struct Part {
    const char* what;  // the label's lines
    const char* which;
    const char* method;
    int samples = 1;
};

struct Strip {
    const char* name;
    const char* source;
    const char* quick_source;
    Crop crop;
    std::vector<Part> parts;
};

const std::vector<Strip>& strips()
{
    static const std::vector<Strip> kStrips = {
        {"foliage",
         "builtin:foliage?alpha=0.5",
         "builtin:foliage?alpha=0.5",
         {192, 114, 54, 120},
         {{"stochastic", "8 samples", "stochastic:depth-based=on:correction=on", 8},
          {"SLAB", "k = 8, b = 8", "slab:layers=8:bits=8:correction=on"},
          {"SLAB", "k = 8, b = 32", "slab:layers=8:bits=32:correction=on"},
          {"SLAB", "k = 8, b = 128", "slab:layers=8:bits=128:correction=on"},
          {"SLAB, implicit", "k = 8, b = 32",
           "slab:layers=8:bits=32:coverage=implicit:correction=on"},
          {"hybrid", "8 layers", "hybrid:layers=8"},
          {"exact", "", "exact"}}},
        {"building",
         "builtin:burning-house",
         "builtin:burning-house?particles=200&grass=0.1",
         {168, 126, 54, 120},
         {{"stochastic", "4 samples", "stochastic:depth-based=on:correction=on", 4},
          {"SLAB", "k = 4, b = 4", "slab:layers=4:bits=4:correction=on"},
          {"hybrid", "4 layers", "hybrid:layers=4"},
          {"SLAB, implicit", "k = 4, b = 16",
           "slab:layers=4:bits=16:coverage=implicit:correction=on"},
          {"MLAB", "4 layers", "mlab:layers=4"},
          {"exact", "", "exact"},
          {"alpha to coverage", "8 samples", "alpha-to-coverage", 8}}},
    };
    return kStrips;
}

// What a part shows, and its error in all of the picture.
struct Drawn {
    Image image;
    double rmse, noise, bias;
};

Drawn draw(const Scene& scene, View view, const Part& part, const Image& exact,
           const ReproduceJob& job)
{
    view.samples = part.samples;
    const bool random = choose_method(part.method).traits().random;
    std::vector<Image> images =
        draw_seeds(scene, view, part.method, random ? (job.quick ? 2 : 4) : 2, job.options);
    const Moments moments = moments_of(images);
    return {std::move(images.front()), rmse(moments, exact), noise(moments), bias(moments, exact)};
}

// One file, the pictures in it.
std::string labelled(const Strip& strip, const std::vector<Image>& pictures,
                     const std::vector<double>& errors)
{
    const double width = pictures.front().width, height = pictures.front().height;
    const double top = 2 * kLine + 8;
    const double all = kGap + (width + kGap) * static_cast<double>(pictures.size());
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + fixed(all, 0) +
                       "\" height=\"" + fixed(top + height + kLine + 8, 0) +
                       "\" font-family=\"sans-serif\" font-size=\"13\">\n"
                       "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const double left = kGap + (width + kGap) * static_cast<double>(i);
        text += svg::text_at({left, kLine}, strip.parts[i].what);
        text += svg::text_at({left, 2 * kLine}, strip.parts[i].which);
        text += "<image x=\"" + fixed(left, 0) + "\" y=\"" + fixed(top, 0) + "\" width=\"" +
                fixed(width, 0) + "\" height=\"" + fixed(height, 0) + "\" href=\"" +
                png_address(encode_png(pictures[i])) + "\"/>\n";
        text += svg::text_at({left, top + height + kLine}, "RMSE " + fixed(errors[i], 2));
    }
    return text + "</svg>\n";
}

void add_strip(const Strip& strip, Page& page, const ReproduceJob& job, double& done)
{
    View view;
    view.width = view.height = job.quick ? 80 : kSide;
    view.samples = 1;
    view.positions = SamplePositions::center;
    const std::string source = job.quick ? strip.quick_source : strip.source;
    const Scene scene = load(source);
    const Image exact = draw_method(scene, view, "exact", job.options);
    const Crop crop = job.quick ? Crop{10, 20, 40, 40} : strip.crop;
    Table table{source, {"picture", "method", "samples", "rmse", "noise", "bias"}, {}};
    std::vector<Image> pictures;
    std::vector<double> errors;
    for (const Part& part : strip.parts) {
        Drawn drawn = draw(scene, view, part, exact, job);
        pictures.push_back(enlarge(drawn.image, crop, kTimes));
        errors.push_back(drawn.rmse);
        const std::string label =
            part.what + std::string(*part.which != '\0' ? ", " : "") + part.which;
        table.rows.push_back({words(label), words(part.method), whole(part.samples),
                              number(drawn.rmse, 2), number(drawn.noise, 2),
                              number(drawn.bias, 2)});
        job.progress(++done / static_cast<double>(2 * strip.parts.size()));
    }
    const std::string suffix = "." + std::string(strip.name);
    write_image(page.path(suffix + ".png"), side_by_side(pictures));
    write_image(page.path(suffix + ".exact.png"), exact);
    page.write_text(suffix + ".svg", labelled(strip, pictures, errors));
    page.show(page.file(suffix + ".svg"), source + ": a part of " +
                                              size_text(crop.width, crop.height) +
                                              " pixels, three times as large");
    page.add(table);
}

}  // namespace

void reproduce_slab_strips(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    page.say(
        "All samples at the pixel's centre: no antialiasing, one truth. The talk's pictures are of "
        "a foliage map and of a building. Errors are in linear colour times 255, over all of the "
        "picture, red, green and blue, and over seeds, against the exact picture. Stochastic "
        "transparency is depth based and, as SLAB is, corrected by total alpha.");
    double done = 0;
    for (const Strip& strip : strips()) add_strip(strip, page, job, done);
    page.write();
}

}  // namespace sheer
