// What changes when a model moves by a part of a pixel: figure 13 of C. Wyman and M. McGuire,
// Improved Alpha Testing Using Hashed Sampling (IEEE TVCG 25(2), 2019).
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/alpha_models.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "compare/reproduce/pictures.h"
#include "compare/reproduce/stratified_seeds.h"
#include "compare/turns.h"
#include "image/write_image.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kWays[] = {"alpha-test",
                                 "hashed-alpha-test",
                                 "hashed-alpha-test:variant=isotropic",
                                 "stochastic-alpha-test",
                                 "hashed-alpha-test:variant=eight-corners",
                                 "hashed-alpha-test:space=texture",
                                 "hashed-alpha-test:hash-scale=0.707",
                                 "hashed-alpha-test:hash-scale=1.414",
                                 "hashed-alpha-test:hash-scale=2",
                                 "hashed-alpha-test:hash-scale=4",
                                 "hashed-alpha-test:variant=isotropic:hash-scale=2",
                                 "hashed-alpha-test:fade-in=6",
                                 "hashed-alpha-test:fade-in=3"};
constexpr std::size_t kCount = std::size(kWays);
constexpr std::size_t kTest = 0, kHashed = 1, kIsotropic = 2, kStochastic = 3;
constexpr double kStep = 0.25;  // pixels

struct Move {
    const char* axis;
    double right, down, nearer;
};
// Eight radii away: the model's edge moves as far along z as all of it does along x.
constexpr Move kMoves[] = {{"x", kStep, 0, 0}, {"y", 0, kStep, 0}, {"z", 0, 0, 8 * kStep}};

double change(const Image& before, const Image& after)
{
    double sum = 0;
    for (std::size_t i = 0; i < before.pixels.size(); ++i) {
        sum += std::abs(static_cast<double>(after.pixels[i][3] - before.pixels[i][3]));
    }
    return sum / static_cast<double>(before.pixels.size());
}

// Black where something changes, as the paper's are.
Image change_map(const Image& before, const Image& after)
{
    Image map = after;
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const float same = 1 - std::abs(after.pixels[i][3] - before.pixels[i][3]);
        map.pixels[i] = {same, same, same, 1};
    }
    return map;
}

class Moving {
public:
    Moving(Page& page, const ReproduceJob& job) : page_(page), job_(job), looks_(job.quick ? 3 : 12)
    {
    }

    int looks() const { return looks_; }

    void run()
    {
        const std::vector<AlphaModel> models = alpha_models(job_.quick);
        const std::vector<int> sizes =
            job_.quick ? std::vector{96} : std::vector{512, 256, 128, 64};
        double done = 0;
        for (const AlphaModel& model : models) {
            for (const int pixels : sizes) {
                for (const Move& move : kMoves) measure(model, pixels, move);
            }
            show_maps(model);
            job_.progress(++done / static_cast<double>(models.size()));
        }
        page_.add(table_);
        summarize();
    }

private:
    Image draw(const Scene& scene, int pixels, std::size_t way, int frame) const
    {
        Options options = job_.options;
        options.seed += static_cast<std::uint64_t>(frame);
        return draw_method(scene, view_of(pixels, 1), kWays[way], options);
    }

    Scene moved(const AlphaModel& model, Look look, int pixels, const Move& move) const
    {
        look.perspective = true;
        look.right += move.right;
        look.down += move.down;
        look.nearer += move.nearer;
        return seen(model, look, pixels);
    }

    void measure(const AlphaModel& model, int pixels, const Move& move)
    {
        double changes[kCount] = {}, coverage = 0, truth = 0;
        for (int i = 0; i < looks_; ++i) {
            const Look look = look_number(i, model);
            Scene before = moved(model, look, pixels, {"", 0, 0, 0});
            const Scene after = moved(model, look, pixels, move);
            for (std::size_t w = 0; w < kCount; ++w) {
                const Image first = draw(before, pixels, w, 2 * i);
                changes[w] += change(first, draw(after, pixels, w, 2 * i + 1)) / looks_;
                if (w == 0) coverage += mean_alpha(first);
            }
            mask_as_blend(before);
            truth += mean_alpha(draw_method(before, view_of(pixels, 4), "exact", job_.options));
        }
        const double part = coverage / truth;
        const bool counts = std::abs(part - 1) <= 0.1;
        for (std::size_t w = 0; counts && w < kCount; ++w) {
            to_test_[w].push_back(changes[w] / changes[kTest]);
            to_stochastic_[w].push_back(changes[w] / changes[kStochastic]);
        }
        table_.rows.push_back(
            {words(model.name), whole(pixels), words(move.axis), number(part, 3),
             words(counts ? "yes" : "no"), number(100 * changes[kTest], 3),
             number(100 * changes[kHashed], 3), number(100 * changes[kIsotropic], 3),
             number(100 * changes[kStochastic], 3), number(changes[kHashed] / changes[kTest], 2),
             number(changes[kHashed] / changes[kStochastic], 2)});
    }

    void show_maps(const AlphaModel& model)
    {
        const int pixels = job_.quick ? 64 : 256;
        const Look look = look_number(0, model);
        const Scene before = moved(model, look, pixels, {"", 0, 0, 0});
        const Scene after = moved(model, look, pixels, kMoves[0]);
        std::vector<Image> maps;
        for (const std::size_t w : {kTest, kHashed, kStochastic}) {
            maps.push_back(change_map(draw(before, pixels, w, 0), draw(after, pixels, w, 1)));
        }
        const std::string suffix = "." + model.name + ".png";
        write_image(page_.path(suffix), side_by_side(maps));
        page_.show(page_.file(suffix), model.name +
                                           ", a quarter of a pixel along x: what changes "
                                           "under an alpha test, a hashed and a "
                                           "stochastic one");
    }

    void summarize()
    {
        const auto median_of = [](const std::vector<double>& ratios) {
            return ratios.empty() ? kNone : median(ratios);
        };
        Table medians{"Where alpha testing keeps the opacity within 10 %, in the median",
                      {"method", "rows", "change / alpha test", "2 or less", "change / stochastic",
                       "1/2 or less"},
                      {}};
        for (std::size_t w = 0; w < kCount; ++w) {
            if (w == kTest || w == kStochastic) continue;
            const double test = median_of(to_test_[w]), stochastic = median_of(to_stochastic_[w]);
            medians.rows.push_back(
                {words(kWays[w]), whole(static_cast<long long>(to_test_[w].size())),
                 number(test, 2), words(test <= 2 ? "yes" : "no"), number(stochastic, 2),
                 words(stochastic <= 0.5 ? "yes" : "no")});
        }
        page_.add(medians);
    }

    Page& page_;
    const ReproduceJob& job_;
    int looks_;
    std::vector<double> to_test_[kCount], to_stochastic_[kCount];  // of the rows that count
    Table table_{
        "Pixels that change when the model moves by a quarter of a pixel, %",
        {"model", "pixels", "along", "alpha test / truth", "counts", "alpha test", "hashed",
         "hashed, isotropic", "stochastic", "hashed / alpha test", "hashed / stochastic"},
        {}};
};

}  // namespace

void reproduce_hashed_stability(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    Moving moving(page, job);
    page.say(
        "Alpha-mapped models, so many pixels high, before and after they move by a quarter of a "
        "pixel to the right (x), down (y) or towards the eye (z, so that its edge moves by as "
        "much); one sample at the pixel's centre, means over " +
        std::to_string(moving.looks()) +
        " looks from other sides. Of the stochastic test both pictures have random numbers of "
        "their own. *Alpha test / truth*: opacity of the picture by an alpha test, as part of "
        "that of the blended one; rows count where it is from .9 to 1.1.");
    moving.run();
    page.write();
}

}  // namespace sheer
