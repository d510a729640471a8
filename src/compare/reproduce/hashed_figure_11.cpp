// Averages of frames beside single ones: the columns of figure 11 of C. Wyman and M. McGuire,
// Improved Alpha Testing Using Hashed Sampling (IEEE TVCG 25(2), 2019), those with temporal
// antialiasing by each of the ways of section 7.2.
#include <cmath>
#include <string>
#include <vector>

#include <sheer/film.h>
#include <sheer/sheer.h>

#include "compare/reproduce/alpha_models.h"
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

constexpr int kPeriod = 8;  // "the eight jittered samples TAA typically uses"
// By then the first frame counts for .9^56 = .3 %.
constexpr int kFrames = 7 * kPeriod;

struct Column {
    const char* title;
    const char* method;
    int samples = 1;
    bool averaged = false;
    AlphaMips mips = AlphaMips::premultiplied;
};

constexpr Column kColumns[] = {
    {"(b) traditional", "alpha-test"},
    {"(c) Castano", "alpha-test", 1, false, AlphaMips::coverage},
    {"(d) hashed", "hashed-alpha-test"},
    {"traditional, TAA", "alpha-test", 1, true},
    {"hashed, TAA, thresholds still", "hashed-alpha-test", 1, true},
    {"hashed, TAA, smaller cells", "hashed-alpha-test:hash-scale=0.354", 1, true},
    {"hashed, TAA, offsets", "hashed-alpha-test:frames=offsets", 1, true},
    {"hashed, TAA, linear strata", "hashed-alpha-test:frames=linear", 1, true},
    {"hashed, TAA, alternating strata", "hashed-alpha-test:frames=alternating", 1, true},
    {"(e) hashed, TAA, van der Corput's strata", "hashed-alpha-test:frames=van-der-corput", 1,
     true},
    {"(f) hashed A2C, 8 samples", "hashed-alpha-to-coverage", 8},
    {"hashed A2C, TAA, offsets", "hashed-alpha-to-coverage:frames=offsets", 8, true},
    {"(g) hashed A2C, TAA, van der Corput's strata",
     "hashed-alpha-to-coverage:frames=van-der-corput", 8, true},
};
constexpr std::size_t kCount = std::size(kColumns);

struct Shown {
    Image image;
    double flicker = 0;  // mean square of the change from frame to frame, over the last period
};

Shown draw_column(const Scene& scene, const Column& column, int pixels, Options options)
{
    View view = view_of(pixels, column.samples);
    view.alpha_mips = column.mips;
    if (!column.averaged) return {draw_method(scene, view, column.method, options)};
    view.positions = SamplePositions::standard;
    options.period = kPeriod;
    TemporalAverage average({TemporalAntialiasing::Kind::exponential, 0.1f, kPeriod});
    Shown shown;
    for (int frame = 0; frame < kFrames; ++frame) {
        view.sample_shift = sample_shift(kPeriod, frame);
        options.frame = frame;
        Image next = average.add(draw_method(scene, view, column.method, options));
        if (frame >= kFrames - kPeriod)
            shown.flicker += mean_square_alpha(next, shown.image) / kPeriod;
        shown.image = std::move(next);
    }
    return shown;
}

struct Sums {
    OpacitySums opacity;
    double squares = 0, flicker = 0;
};

class Averaged {
public:
    Averaged(Page& page, const ReproduceJob& job)
        : page_(page), job_(job), looks_(job.quick ? 3 : 12)
    {
    }

    int looks() const { return looks_; }

    void run()
    {
        const AlphaModel model = alpha_models(job_.quick).back();  // of hair, as the paper's
        const std::vector<int> sizes = job_.quick ? std::vector{16} : std::vector{64, 32, 16};
        double done = 0;
        for (const int pixels : sizes) {
            Table table{model.name + ", " + std::to_string(pixels) + " pixels high",
                        {"technique", "of truth", "error", "rms error of a pixel", "flicker"},
                        {}};
            measure(model, pixels, table);
            page_.add(table);
            job_.progress(++done / static_cast<double>(sizes.size()));
        }
    }

private:
    void measure(const AlphaModel& model, int pixels, Table& table)
    {
        std::vector<Sums> sums(kCount);
        std::vector<Image> row;
        for (int i = 0; i < looks_; ++i) {
            Scene scene = seen(model, look_number(i, model), pixels), blended = scene;
            mask_as_blend(blended);
            const Image truth = render_truth(blended, view_of(pixels, 16), job_.options,
                                             job_.quick ? 1 : kTruthPasses);
            if (i == 0) row.push_back(truth);
            for (std::size_t c = 0; c < kCount; ++c) {
                const Shown shown = draw_column(scene, kColumns[c], pixels, job_.options);
                sums[c].opacity.add(mean_alpha(shown.image), mean_alpha(truth));
                sums[c].squares += mean_square_alpha(shown.image, truth) / looks_;
                sums[c].flicker += shown.flicker / looks_;
                if (i == 0) row.push_back(shown.image);
            }
        }
        for (std::size_t c = 0; c < kCount; ++c) {
            const Sums& of = sums[c];
            table.rows.push_back({words(kColumns[c].title), number(of.opacity.ratio(), 3),
                                  number(of.opacity.error(), 4), number(std::sqrt(of.squares), 4),
                                  number(std::sqrt(of.flicker), 4)});
        }
        show(model, pixels, std::move(row));
    }

    void show(const AlphaModel& model, int pixels, std::vector<Image> row)
    {
        for (Image& picture : row) {
            picture = over_white(enlarge(picture, {1, 1, pixels, pixels}, 128 / pixels));
        }
        const std::string suffix = "." + std::to_string(pixels) + ".png";
        write_image(page_.path(suffix), side_by_side(row));
        std::string caption =
            model.name + ", " + std::to_string(pixels) + " pixels high, enlarged: (a) the truth";
        for (const Column& column : kColumns) caption += std::string("; ") + column.title;
        page_.show(page_.file(suffix), caption);
    }

    Page& page_;
    const ReproduceJob& job_;
    int looks_;
};

}  // namespace

void reproduce_hashed_figure_11(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    Averaged averaged(page, job);
    page.say(
        "Cards of hair from afar by the techniques of the figure's columns. *TAA*: an exponential "
        "average of weight 0.1 after " +
        std::to_string(kFrames) +
        " frames, whose samples lie at 8 places by turns. *Of truth*: the picture's opacity as "
        "part of that of the blended cards, with its standard error over " +
        std::to_string(averaged.looks()) +
        " looks; then the root mean square error of a pixel's opacity, and that of the change from "
        "one shown frame to the next, over the last 8.");
    averaged.run();
    page.write();
}

}  // namespace sheer
