// Noise that fades in with distance: figure 12 of C. Wyman and M. McGuire, Improved Alpha Testing
// Using Hashed Sampling (IEEE TVCG 25(2), 2019).
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/alpha_models.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/opacity_sums.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

struct Column {
    const char* title;
    const char* method;
};
constexpr Column kColumns[] = {{"(a) traditional", "alpha-test"},
                               {"(b) hashed", "hashed-alpha-test"},
                               {"(c) fade in hash", "hashed-alpha-test:fade-in=6"},
                               {"fade in, 3 levels", "hashed-alpha-test:fade-in=3"}};
constexpr std::size_t kCount = std::size(kColumns);
// "due to alpha of 0.99, some internal noise"
constexpr float kOpacity = 0.99f;
constexpr int kMostPixels = 384;  // of a picture: nearer, it shows the middle of the tree

// Pixels by what the truth says of them, and by how much pictures are off there.
struct Kind {
    double pixels = 0, holes = 0, squares = 0;

    double part_of_holes() const { return holes / pixels; }
    double rms() const { return std::sqrt(squares / pixels); }
};
struct Kinds {
    Kind inside, edges;  // of leaves: where the truth hides the background, or a part of it
    OpacitySums opacity;
};

void add_pixels(const Image& image, const Image& truth, Kinds& kinds)
{
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto got = static_cast<double>(image.pixels[i][3]);
        const auto wanted = static_cast<double>(truth.pixels[i][3]);
        if (!(wanted > 0.02)) continue;
        Kind& kind = wanted >= static_cast<double>(kOpacity) - 1e-6 ? kinds.inside : kinds.edges;
        kind.pixels += 1;
        kind.holes += 1 - got;
        kind.squares += (got - wanted) * (got - wanted);
    }
    kinds.opacity.add(mean_alpha(image), mean_alpha(truth));
}

class FadingIn {
public:
    FadingIn(Page& page, const ReproduceJob& job)
        : page_(page), job_(job), looks_(job.quick ? 3 : 12)
    {
    }

    int looks() const { return looks_; }

    void run()
    {
        AlphaModel model = alpha_tree(job_.quick ? 600 : 6000);
        for (Material& material : model.scene.materials) material.opacity = kOpacity;
        const std::vector<int> sizes =
            job_.quick ? std::vector{512, 16} : std::vector{8192, 4096, 2048, 1024, 256, 64, 16};
        double done = 0;
        for (const int pixels : sizes) {
            measure(model, pixels);
            job_.progress(++done / static_cast<double>(sizes.size()));
        }
        page_.add(table_);
    }

private:
    // Of a tree that is `pixels` high, as much as there is room for.
    static Scene part_of(const AlphaModel& model, const Look& look, int pixels)
    {
        Scene scene = seen(model, look, pixels);
        Camera& camera = scene.cameras.front();
        const float part =
            static_cast<float>(std::min(pixels, kMostPixels) + 2) / static_cast<float>(pixels + 2);
        camera.xmag *= part;
        camera.ymag *= part;
        return scene;
    }

    void measure(const AlphaModel& model, int pixels)
    {
        const int side = std::min(pixels, kMostPixels);
        std::vector<Kinds> kinds(kCount);
        for (int i = 0; i < looks_; ++i) {
            Scene scene = part_of(model, look_number(i, model), pixels);
            std::vector<Image> images;
            for (const Column& column : kColumns) {
                images.push_back(draw_method(scene, view_of(side, 1), column.method, job_.options));
            }
            mask_as_blend(scene);
            // At pixels' centres too: what is at their edges is not what this is about.
            images.push_back(draw_method(scene, view_of(side, 1), "exact", job_.options));
            for (std::size_t c = 0; c < kCount; ++c) add_pixels(images[c], images.back(), kinds[c]);
            if (i == 0) show(pixels, side, std::move(images));
        }
        for (std::size_t c = 0; c < kCount; ++c) {
            const Kinds& k = kinds[c];
            const double card = static_cast<double>(model.card / model.radius) / 2 * pixels;
            table_.rows.push_back({words(kColumns[c].title), whole(pixels), number(card, 1),
                                   number(k.opacity.ratio(), 3), number(k.opacity.error(), 4),
                                   number(100 * k.inside.part_of_holes(), 2),
                                   number(k.edges.rms(), 3)});
        }
    }

    void show(int pixels, int side, std::vector<Image> row)
    {
        const int shown = std::min(side, 256);
        const int from = (side + 2 - shown) / 2;
        for (Image& picture : row) {
            picture = over_white(enlarge(picture, {from, from, shown, shown}, 256 / shown));
        }
        const std::string suffix = "." + std::to_string(pixels) + ".png";
        write_image(page_.path(suffix), side_by_side(row));
        std::string caption = "A tree " + std::to_string(pixels) + " pixels high, or its middle: ";
        for (const Column& column : kColumns) caption += std::string(column.title) + "; ";
        page_.show(page_.file(suffix), caption + "blended");
    }

    Page& page_;
    const ReproduceJob& job_;
    int looks_;
    Table table_{"A tree, near to far",
                 {"technique", "pixels", "card", "of blended", "error", "holes within, %",
                  "rms error at edges"},
                 {}};
};

}  // namespace

void reproduce_hashed_figure_12(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    FadingIn fading(page, job);
    page.say(
        "A tree whose leaves have an opacity of 0.99, as the paper says of its own, from near to "
        "far, one sample at the pixel's centre, beside the same cards blended there. *Pixels*: "
        "the tree's height; *card*: a card's. *Of blended*: the opacity of the picture, with its "
        "standard error over " +
        std::to_string(fading.looks()) +
        " looks. *Holes within*: how much of the background shows in pixels of which blended cards "
        "hide 99 % or more; *at edges*: the error of the opacity of a pixel of which they hide "
        "between 2 % and that.");
    fading.run();
    page.write();
}

}  // namespace sheer
