// A scene of which alpha-mapped cards are a part: figure 16 of C. Wyman and M. McGuire, Improved
// Alpha Testing Using Hashed Sampling (IEEE TVCG 25(2), 2019).
#include <string>
#include <utility>
#include <vector>

#include <sheer/sheer.h>

#include "compare/metrics.h"
#include "compare/reproduce/alpha_models.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

// The paper's is San Miguel: trees and vines of cards around a court.
constexpr EntryScene kScene = {"windy-hill", "builtin:windy-hill?alpha=mask",
                               "builtin:windy-hill?alpha=mask&cards=600&hairs=300"};

struct Column {
    const char* title;
    const char* method;
};
constexpr Column kColumns[] = {{"(a) traditional", "alpha-test"},
                               {"(b) hashed", "hashed-alpha-test"},
                               {"fade in hash", "hashed-alpha-test:fade-in=6"}};

struct PictureSize {
    int width, height;
};

// The MASK surfaces alone, over nothing.
Scene cards_of(const Scene& scene)
{
    Scene cards = scene;
    cards.objects.clear();
    for (const Object& object : scene.objects) {
        const Material& material = material_of(scene, object);
        if (material.alpha_mode == AlphaMode::mask) cards.objects.push_back(object);
    }
    cards.background = Float4{0, 0, 0, 0};
    return cards;
}

View picture(const PictureSize& size)
{
    View view;
    view.width = size.width;
    view.height = size.height;
    view.samples = 1;
    view.positions = SamplePositions::center;
    return view;
}

// The same with MASK as BLEND, by 16 samples.
Image blended(Scene scene, View view, const Options& options)
{
    mask_as_blend(scene);
    view.samples = 16;
    view.positions = SamplePositions::standard;
    return draw_method(scene, view, "exact", options);
}

void add_size(const Scene& scene, const PictureSize& size, const ReproduceJob& job, Table& table,
              std::vector<Image>& shown)
{
    const View view = picture(size);
    const Scene cards = cards_of(scene);
    const double wanted = mean_alpha(blended(cards, view, job.options));
    const Image truth = blended(scene, view, job.options);
    for (const Column& column : kColumns) {
        const double alpha = mean_alpha(draw_method(cards, view, column.method, job.options));
        Image image = draw_method(scene, view, column.method, job.options);
        const Difference off = compare_images(image, truth);
        table.rows.push_back({words(column.title), words(size_text(size.width, size.height)),
                              number(wanted, 4), number(alpha / wanted, 3), number(off.rmse, 2)});
        shown.push_back(std::move(image));
    }
    shown.push_back(truth);
}

}  // namespace

void reproduce_hashed_figure_16(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    const std::string source = kScene.of(job);
    const Scene scene = load(source);
    page.say(
        "The paper's scene has trees and vines in a court; ours is " + source +
        ". *Opacity*: of its MASK cards alone, blended in the right order with 16 samples; *of "
        "truth*: by the technique, one sample at the pixel's centre. Last, the error of the whole "
        "picture beside the blended one, in linear colour times 255.");
    Table table{"Cards in a scene",
                {"technique", "size", "opacity", "of truth", "rmse of the picture"},
                {}};
    const std::vector<PictureSize> sizes =
        job.quick ? std::vector<PictureSize>{{96, 54}}
                  : std::vector<PictureSize>{{1920, 1080}, {960, 540}, {480, 270}, {240, 135}};
    double done = 0;
    for (const PictureSize& size : sizes) {
        std::vector<Image> shown;
        add_size(scene, size, job, table, shown);
        if (size.width <= 480) {
            const std::string suffix = "." + std::to_string(size.width) + ".png";
            write_image(page.path(suffix), side_by_side(shown));
            page.show(page.file(suffix), size_text(size.width, size.height) +
                                             " pixels: an alpha test, hashed, hashed noise that "
                                             "fades in, the truth");
        }
        job.progress(++done / static_cast<double>(sizes.size()));
    }
    page.add(table);
    page.write();
}

}  // namespace sheer
