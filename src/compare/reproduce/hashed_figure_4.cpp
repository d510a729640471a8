// Cards smaller than pixels: figure 4 of C. Wyman and M. McGuire, Improved Alpha Testing Using
// Hashed Sampling (IEEE TVCG 25(2), 2019).
#include <cmath>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/alpha_models.h"
#include "compare/reproduce/alpha_ways.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/opacity_sums.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "compare/truth.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr AlphaMips kMips = AlphaMips::premultiplied;
constexpr AlphaWay kWays[] = {
    {"(a) alpha test", "alpha-test"},
    {"(b) hashed", "hashed-alpha-test"},
    {"(c) hashed, touched pixels", "hashed-alpha-test", 1, kMips, 0, ShadeAt::fragment,
     Conservative::touched},
    {"hashed, by area", "hashed-alpha-test", 1, kMips, 0, ShadeAt::fragment, Conservative::area},
    {"stochastic", "stochastic-alpha-test"},
    {"stochastic, by area", "stochastic-alpha-test", 1, kMips, 0, ShadeAt::fragment,
     Conservative::area},
    {"blended in order, by area", "alpha-test-then-blend:cutoff=1:order=triangles", 1, kMips, 0,
     ShadeAt::fragment, Conservative::area},
    {"hashed alpha to coverage, 8 samples", "hashed-alpha-to-coverage", 8},
};
constexpr std::size_t kCount = std::size(kWays);

class SmallCards {
public:
    SmallCards(Page& page, const ReproduceJob& job)
        : page_(page), job_(job), looks_(job.quick ? 8 : 64)
    {
    }

    int looks() const { return looks_; }

    void run()
    {
        const AlphaModel model = alpha_tree(job_.quick ? 600 : 60000);
        const std::vector<int> sizes = job_.quick ? std::vector{8} : std::vector{64, 32, 16, 8};
        double done = 0;
        for (const int pixels : sizes) {
            measure(model, pixels);
            job_.progress(++done / static_cast<double>(sizes.size()));
        }
        page_.add(table_);
        strip(model, job_.quick ? 16 : 32);
    }

private:
    void measure(const AlphaModel& model, int pixels)
    {
        OpacitySums sums[kCount];
        double squares[kCount] = {};
        for (int i = 0; i < looks_; ++i) {
            Scene scene = seen(model, look_number(i, model), pixels);
            std::vector<Image> images;
            for (const AlphaWay& way : kWays) {
                images.push_back(draw_way(scene, way, pixels, seed_of(i), job_.options));
            }
            mask_as_blend(scene);
            const Image truth = render_truth(scene, view_of(pixels, 16), job_.options, 1);
            for (std::size_t w = 0; w < kCount; ++w) {
                sums[w].add(mean_alpha(images[w]), mean_alpha(truth));
                squares[w] += mean_square_alpha(images[w], truth) / looks_;
            }
        }
        const double card = static_cast<double>(model.card / model.radius) / 2 * pixels;
        for (std::size_t w = 0; w < kCount; ++w) {
            table_.rows.push_back({words(kWays[w].title), whole(pixels), number(card, 2),
                                   number(sums[w].mean_truth(), 4), number(sums[w].ratio(), 3),
                                   number(sums[w].error(), 4), number(sums[w].deviation(), 3),
                                   number(std::sqrt(squares[w]), 3)});
        }
    }

    void strip(const AlphaModel& model, int pixels)
    {
        Scene scene = seen(model, look_number(1, model), pixels);
        std::vector<Image> row;
        std::string caption = model.name + ", " + std::to_string(pixels) + " pixels high: ";
        for (const AlphaWay& way : kWays) {
            row.push_back(draw_way(scene, way, pixels, seed_of(0), job_.options));
            caption += std::string(way.title) + "; ";
        }
        mask_as_blend(scene);
        row.push_back(render_truth(scene, view_of(pixels, 16), job_.options, 1));
        for (Image& picture : row) {
            picture = over_white(enlarge(picture, {1, 1, pixels, pixels}, 128 / pixels));
        }
        write_image(page_.path(".png"), side_by_side(row));
        page_.show(page_.file(".png"), caption + "(d) the truth");
    }
    std::uint64_t seed_of(int look) const
    {
        return job_.options.seed + static_cast<std::uint64_t>(look);
    }

    Page& page_;
    const ReproduceJob& job_;
    int looks_;
    Table table_{"A tree of cards smaller than pixels",
                 {"method", "pixels", "card", "opacity", "of truth", "error", "deviation",
                  "rms error of a pixel"},
                 {}};
};

}  // namespace

void reproduce_hashed_figure_4(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    SmallCards cards(page, job);
    page.say(
        "Mean opacity of pictures of a tree as part of that of the truth, the same cards blended "
        "in the right order with 64 samples a pixel, over " +
        std::to_string(cards.looks()) +
        " looks; *error*: the standard error of that ratio; *deviation*: of the opacity of one "
        "picture from it; last, of the opacity of one pixel from the truth's. *Pixels*: the "
        "tree's height; *card*: that of a card. *Touched pixels* and *by area*: rasterised "
        "conservatively, with the opacity as it is, or multiplied by the part of the pixel that "
        "the triangle has.");
    cards.run();
    page.write();
}

}  // namespace sheer
