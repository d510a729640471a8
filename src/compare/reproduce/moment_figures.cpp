// Figures 1 and 3 of Sharpe. Moment Transparency. HPG 2018: what the techniques look like. Figure 2
// is what `sheer transmittance` draws.
#include <span>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/report/report.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/moment_techniques.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

struct Shown {
    const char* title;
    const char* method;
};

// One row of pictures, and parts of them.
struct PictureRow {
    const char* name;
    EntryScene scene;
    const char* what;
    std::vector<Shown> shown;
    Crop crop;  // of 640x480 pixels
};

void add_row(const PictureRow& row, const ReproduceJob& job, double from, double part, Page& page)
{
    const std::string source = row.scene.of(job);
    const Scene scene = load(source);
    const View view = moment_view(job.quick);
    const Crop crop = job.quick ? Crop{16, 12, 24, 24} : row.crop;
    const Image exact = draw_method(scene, view, "exact", job.options);
    Table table{std::string(row.name) + ": errors",
                {"picture", "method", "rmse", "rmse of the part", "mean, red", "green", "blue"},
                {}};
    std::vector<Image> pictures, parts;
    const Image exact_part = enlarge(exact, crop, 1);
    for (const Shown& shown : row.shown) {
        const Image image = draw_method(scene, view, shown.method, job.options);
        const Difference d = compare_images(image, exact);
        const Image piece = enlarge(image, crop, 1);
        table.rows.push_back({words(shown.title), words(shown.method), number(d.rmse, 3),
                              number(compare_images(piece, exact_part).rmse, 3),
                              signed_number(d.bias_mean[0], 2), signed_number(d.bias_mean[1], 2),
                              signed_number(d.bias_mean[2], 2)});
        parts.push_back(enlarge(image, crop, 3));
        pictures.push_back(image);
        job.progress(from + part * static_cast<double>(parts.size()) /
                                static_cast<double>(row.shown.size()));
    }
    std::string titles;
    for (const Shown& shown : row.shown)
        titles += (titles.empty() ? "" : ", ") + std::string(shown.title);
    const std::string suffix = "." + std::string(row.name);
    write_image(page.path(suffix + ".png"), side_by_side(pictures));
    page.show(page.file(suffix + ".png"), source + ", " + row.what + ": " + titles);
    write_image(page.path(suffix + ".part.png"), side_by_side(parts));
    page.show(
        page.file(suffix + ".part.png"),
        "Parts of these, " + size_text(crop.width, crop.height) + " pixels, three times as large");
    page.add(table);
}

void add_rows(std::span<const PictureRow> rows, const ReproduceEntry& entry,
              const ReproduceJob& job)
{
    Page page(entry, job);
    page.say(size_text(moment_view(job.quick).width, moment_view(job.quick).height) +
             " pixels, one sample a pixel. Errors are in linear colour times 255, red, green and "
             "blue, against the exact picture of the same samples, over all of the picture and "
             "over the part that is shown enlarged.");
    const double part = 1 / static_cast<double>(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        add_row(rows[i], job, part * static_cast<double>(i), part, page);
    }
    page.write();
}

constexpr const char* kTwoPasses = "moment:moment-passes=2";

}  // namespace

void reproduce_moment_figure_1(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const PictureRow rows[] = {{"burning-house",
                                kBurningHouse,
                                "figure 1",
                                {{"WBOIT", "wboit"},
                                 {"MT", "moment"},
                                 {"two moments passes", kTwoPasses},
                                 {"ground truth", "exact"}},
                                {330, 250, 150, 120}}};
    add_rows(rows, entry, job);
}

void reproduce_moment_figure_3(const ReproduceEntry& entry, const ReproduceJob& job)
{
    const PictureRow rows[] = {{"low-resolution",
                                kBurningHouse,
                                "figure 3a",
                                {{"MT", "moment"},
                                 {"1/2", "moment:resolution=1/2"},
                                 {"1/4", "moment:resolution=1/4"},
                                 {"1/8", "moment:resolution=1/8"},
                                 {"1/8, depth-aware", "moment:resolution=1/8:upsample=depth-aware"},
                                 {"ground truth", "exact"}},
                                {330, 250, 150, 120}},
                               {"overestimation",
                                kBurningHouse,
                                "section 4.3",
                                {{"0", "moment:overestimation=0"},
                                 {"0.25", "moment"},
                                 {"0.5", "moment:overestimation=0.5"},
                                 {"adaptive", "moment:overestimation=adaptive"},
                                 {"ground truth", "exact"}},
                                {330, 250, 150, 120}},
                               {"grass-and-smoke",
                                kGrassAndSmoke,
                                "figure 3b",
                                {{"MT", "moment"},
                                 {"two moments passes", kTwoPasses},
                                 {"1/8", "moment:resolution=1/8"},
                                 {"1/8, depth-aware", "moment:resolution=1/8:upsample=depth-aware"},
                                 {"WBOIT", "wboit"},
                                 {"ground truth", "exact"}},
                                {330, 250, 150, 120}}};
    add_rows(rows, entry, job);
}

}  // namespace sheer
