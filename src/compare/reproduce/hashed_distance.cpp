// Opacity of alpha-mapped models against distance: what figures 1, 3, 5 and 9 to 11 of C. Wyman and
// M. McGuire, Improved Alpha Testing Using Hashed Sampling (IEEE TVCG 25(2), 2019), show.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/alpha_models.h"
#include "compare/reproduce/alpha_ways.h"
#include "compare/reproduce/chart.h"
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

constexpr AlphaWay kWays[] = {
    {"alpha test", "alpha-test"},
    {"Castano's mipmaps", "alpha-test", 1, AlphaMips::coverage},
    {"a threshold for each level", "alpha-test", 1, AlphaMips::thresholds},
    {"alpha test of the image", "alpha-test", 1, AlphaMips::premultiplied, 1},
    {"the same, at each of 8 samples", "alpha-test", 8, AlphaMips::premultiplied, 1,
     ShadeAt::sample},
    {"alpha test, then blend", "alpha-test-then-blend:order=triangles"},
    {"stochastic", "stochastic-alpha-test"},
    {"hashed", "hashed-alpha-test"},
    {"hashed, isotropic", "hashed-alpha-test:variant=isotropic"},
    {"alpha to coverage, 8 samples", "alpha-to-coverage", 8},
    {"hashed alpha to coverage, 8 samples", "hashed-alpha-to-coverage", 8},
};
constexpr std::size_t kTest = 0, kCastano = 1, kImage = 3, kStochastic = 6, kHashed = 7;

class Receding {
public:
    Receding(Page& page, const ReproduceJob& job)
        : page_(page),
          job_(job),
          looks_(job.quick ? 12 : 64),
          sizes_(job.quick ? std::vector{32, 8} : std::vector{1024, 512, 256, 128, 64, 32, 16, 8})
    {
    }

    int looks() const { return looks_; }

    void run()
    {
        std::vector<AlphaModel> models = alpha_models(job_.quick);
        for (std::size_t i = 0; i < models.size(); ++i) {
            recede(models[i]);
            strip(models[i]);
            job_.progress(static_cast<double>(i + 1) / static_cast<double>(models.size()));
        }
        page_.add(worst_);
    }

private:
    void recede(const AlphaModel& model)
    {
        Table table{
            model.name, {"method", "pixels", "card", "opacity", "of truth", "error", "z"}, {}};
        std::vector<Series> lines;
        for (const AlphaWay& way : kWays) lines.push_back({way.title, {}, {}});
        double worst[2] = {0, 0}, beyond[2] = {0, 0};  // cards of a pixel or more, below
        OpacitySums smallest[std::size(kWays)];
        for (const int pixels : sizes_) {
            std::vector<OpacitySums> sums = look(model, pixels);
            const double card = static_cast<double>(model.card / model.radius) / 2 * pixels;
            for (std::size_t w = 0; w < sums.size(); ++w) {
                const double ratio = sums[w].ratio(), error = sums[w].error();
                table.rows.push_back({words(kWays[w].title), whole(pixels), number(card, 1),
                                      number(sums[w].mean_truth(), 4), number(ratio, 3),
                                      number(error, 4), signed_number((ratio - 1) / error, 1)});
                lines[w].x.push_back(pixels);
                lines[w].y.push_back(ratio);
            }
            const double off = std::abs(sums[kHashed].ratio() - 1);
            const std::size_t apart = card < 1 ? 1 : 0;
            worst[apart] = std::max(worst[apart], off);
            beyond[apart] =
                std::max(beyond[apart], std::min(off - 0.02, off - 3 * sums[kHashed].error()));
            std::move(sums.begin(), sums.end(), smallest);
        }
        page_.add(table);
        const std::string suffix = "." + model.name + ".svg";
        page_.write_text(suffix, log_linear_chart(model.name + ": opacity, as part of the truth",
                                                  lines, "pixels that the model is high"));
        page_.show(page_.file(suffix), model.name);
        worst_.rows.push_back({words(model.name), number(smallest[kTest].ratio(), 3),
                               number(smallest[kCastano].ratio(), 3),
                               number(smallest[kImage].ratio(), 3),
                               number(smallest[kStochastic].ratio(), 3), number(worst[0], 3),
                               words(beyond[0] > 0 ? "no" : "yes"), number(worst[1], 3)});
    }

    std::vector<OpacitySums> look(const AlphaModel& model, int pixels) const
    {
        std::vector<OpacitySums> sums(std::size(kWays));
        for (int i = 0; i < looks_; ++i) {
            Scene scene = seen(model, look_number(i, model), pixels);
            std::vector<double> means;
            for (const AlphaWay& way : kWays) {
                means.push_back(mean_alpha(draw_way(scene, way, pixels, seed_of(i), job_.options)));
            }
            mask_as_blend(scene);
            const double truth =
                mean_alpha(draw_method(scene, view_of(pixels, 16), "exact", job_.options));
            for (std::size_t w = 0; w < sums.size(); ++w) sums[w].add(means[w], truth);
        }
        return sums;
    }

    // Side by side, enlarged: each way, then the truth, at three distances.
    void strip(const AlphaModel& model)
    {
        constexpr int kSide = 128;
        std::vector<Image> rows;
        for (const int pixels : {128, 64, 32}) {
            if (job_.quick && pixels > 32) continue;
            std::vector<Image> row;
            Scene scene = seen(model, look_number(1, model), pixels);
            for (const AlphaWay& way : kWays) {
                row.push_back(draw_way(scene, way, pixels, seed_of(0), job_.options));
            }
            mask_as_blend(scene);
            row.push_back(render_truth(scene, view_of(pixels, 16), job_.options,
                                       job_.quick ? 1 : kTruthPasses));
            for (Image& picture : row) {
                picture = over_white(enlarge(picture, {1, 1, pixels, pixels}, kSide / pixels));
            }
            rows.push_back(side_by_side(row));
        }
        const std::string suffix = "." + model.name + ".png";
        write_image(page_.path(suffix), one_below_another(rows));
        std::string caption = model.name + (job_.quick ? ", 32" : ", 128, 64 and 32") +
                              " pixels high, enlarged alike: ";
        for (const AlphaWay& way : kWays) caption += std::string(way.title) + "; ";
        page_.show(page_.file(suffix), caption + "the truth");
    }

    std::uint64_t seed_of(int look) const
    {
        return job_.options.seed + static_cast<std::uint64_t>(look);
    }

    Page& page_;
    const ReproduceJob& job_;
    int looks_;
    std::vector<int> sizes_;
    Table worst_{
        "The farthest, as part of the truth, and hashed alpha testing at its worst",
        {"model", "alpha test", "Castano's mipmaps", "alpha test of the image", "stochastic",
         "hashed, most off", "within 2 % or three errors", "cards below a pixel: most off"},
        {}};
};

}  // namespace

void reproduce_hashed_distance(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    Receding receding(page, job);
    page.say(
        "Mean opacity of pictures of models made of alpha-mapped cards, as part of that of the "
        "truth: the same cards blended, in the right order, with 16 samples a pixel. Means over " +
        std::to_string(receding.looks()) +
        " looks, each from another side, with the model elsewhere between pixels and elsewhere "
        "in space, so that hashed thresholds are others; *error*: the standard error of that "
        "ratio, *z* its distance from 1 in such. *Pixels*: the model's height, which falls as "
        "it recedes; *card*: that of a card, below 1 as in the paper's figure 4. One sample at "
        "a pixel's centre, if not said otherwise.");
    receding.run();
    page.write();
}

}  // namespace sheer
