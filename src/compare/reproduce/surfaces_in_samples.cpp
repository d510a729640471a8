// How many surfaces a buffer of S samples holds. C. Wyman, "Exploring and Expanding the Continuum
// of OIT Algorithms", HPG 2016, bases stochastic layered alpha blending on that these are few:
// "stochastic transparency rarely stores k surfaces in a k-sample buffer".
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "compare/reproduce/chart.h"
#include "compare/reproduce/choose.h"
#include "compare/reproduce/entries.h"
#include "compare/reproduce/page.h"
#include "cpu/fragment_sink.h"
#include "cpu/frame.h"
#include "geometry/meet.h"
#include "methods/method.h"
#include "methods/stochastic_mask.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kSamples[] = {4, 8, 16, 32, 64};
constexpr int kLayers = 16;  // of the scene whose answer is known

constexpr EntryScene kScenes[] = {
    {"layers", "builtin:layers?n=16&alpha=0.5", "builtin:layers?n=16&alpha=0.5"},
    {"foliage", "builtin:foliage?alpha=0.5", "builtin:foliage?alpha=0.5"},
    {"motor-0.3", "builtin:motor?alpha=0.3", "builtin:motor?alpha=0.3&detail=0.2"},
    {"motor-0.98", "builtin:motor?alpha=0.98", "builtin:motor?alpha=0.98&detail=0.2"},
};

struct Surface {
    float depth;
    std::uint32_t primitive;
    float opacity;
};

// All fragments of a picture whose pixels have one sample.
class Surfaces : public FragmentSink {
public:
    explicit Surfaces(const View& view)
        : width_(view.width), pixels_(static_cast<std::size_t>(view.width * view.height))
    {
    }

    void take(const PixelRect& rect, const PixelRect& interior, const ChannelShape&,
              const FragmentStream& stream) override
    {
        for_each_inside(rect, interior, stream,
                        [&](const FragmentRun& run, std::size_t i, int x, int y, float depth) {
                            pixels_[static_cast<std::size_t>(y * width_ + x)].push_back(
                                {depth, run.primitive, stream.opacity[i]});
                        });
    }

    // No order of arrival shows.
    void sort()
    {
        for (auto& pixel : pixels_) {
            std::sort(pixel.begin(), pixel.end(), [](const Surface& a, const Surface& b) {
                return a.depth < b.depth || (a.depth == b.depth && a.primitive < b.primitive);
            });
        }
    }

    // In each pixel that has any: how many surfaces win a sample or more. Near to far, those whose
    // masks have a sample that none before had.
    std::vector<int> held(int samples, std::uint32_t key) const
    {
        std::vector<int> counts;
        for (std::size_t p = 0; p < pixels_.size(); ++p) {
            if (pixels_[p].empty()) continue;
            const auto x = static_cast<std::uint32_t>(p) % static_cast<std::uint32_t>(width_);
            const auto y = static_cast<std::uint32_t>(p) / static_cast<std::uint32_t>(width_);
            std::uint64_t open = samples == 64 ? ~0ull : (1ull << samples) - 1;
            int count = 0;
            for (const Surface& surface : pixels_[p]) {
                if (open == 0) break;
                const std::uint64_t taken =
                    stochastic_mask({x, y, surface.primitive, surface.opacity}, key, samples) &
                    open;
                count += taken != 0 ? 1 : 0;
                open &= ~taken;
            }
            counts.push_back(count);
        }
        std::sort(counts.begin(), counts.end());
        return counts;
    }

    double mean_depth() const
    {
        double sum = 0, count = 0;
        for (const auto& pixel : pixels_) {
            sum += static_cast<double>(pixel.size());
            count += pixel.empty() ? 0 : 1;
        }
        return sum / count;
    }

private:
    int width_;
    std::vector<std::vector<Surface>> pixels_;
};

// The mean over all masks of S / 2 samples, by how many are covered before each layer.
double expected_of_half_opaque_layers(int samples)
{
    const int half = samples / 2;
    const double all = choose(samples, half);
    std::vector<double> covered(static_cast<std::size_t>(samples) + 1);
    covered[0] = 1;
    double surfaces = 0;
    for (int layer = 0; layer < kLayers; ++layer) {
        std::vector<double> next(covered.size());
        for (int before = 0; before <= samples; ++before) {
            for (int more = 0; more <= std::min(half, samples - before); ++more) {
                const double chance = covered[static_cast<std::size_t>(before)] *
                                      choose(samples - before, more) * choose(before, half - more) /
                                      all;
                next[static_cast<std::size_t>(before + more)] += chance;
                surfaces += more > 0 ? chance : 0;
            }
        }
        covered = std::move(next);
    }
    return surfaces;
}

struct Counts {
    std::vector<int> sorted;

    double size() const { return static_cast<double>(sorted.size()); }
    double mean() const
    {
        double sum = 0;
        for (const int count : sorted) sum += count;
        return sum / size();
    }
    double error_of_mean() const
    {
        double squares = 0;
        for (const int count : sorted) squares += (count - mean()) * (count - mean());
        return std::sqrt(squares / (size() - 1) / size());
    }
    int at(double part) const
    {
        return sorted[std::min(static_cast<std::size_t>(part * size()), sorted.size() - 1)];
    }
    double part_of(int least, int most) const
    {
        const auto from = std::lower_bound(sorted.begin(), sorted.end(), least);
        const auto to = std::upper_bound(sorted.begin(), sorted.end(), most);
        return static_cast<double>(to - from) / size();
    }
};

void add_counts(const EntryScene& scene, int samples, const Counts& counts, Table& table,
                Table& histogram, Series& line)
{
    const bool known = scene.name == std::string("layers");
    const double expected = known ? expected_of_half_opaque_layers(samples) : kNone;
    table.rows.push_back(
        {words(scene.name), whole(samples), number(counts.mean(), 3), number(expected, 3),
         signed_number((counts.mean() - expected) / counts.error_of_mean(), 1),
         whole(counts.at(0.5)), whole(counts.at(0.99)), whole(counts.sorted.back()),
         number(100 * counts.part_of(samples / 2 + 1, samples), 3),
         number(100 * counts.part_of(samples, samples), 3)});
    for (int n = 0; n <= counts.sorted.back(); ++n) {
        const double part = counts.part_of(n, n);
        histogram.rows.push_back({words(scene.name), whole(samples), whole(n), number(part, 6)});
        line.x.push_back(n);
        line.y.push_back(part);
    }
}

}  // namespace

void reproduce_surfaces_in_samples(const ReproduceEntry& entry, const ReproduceJob& job)
{
    Page page(entry, job);
    View view;
    view.width = view.height = job.quick ? 64 : 250;
    view.samples = 1;
    view.positions = SamplePositions::center;
    const std::uint32_t key = frame_key(job.options.seed, 0);
    Table table{"Surfaces in a pixel's S samples",
                {"scene", "S", "mean", "exact", "z", "median", "99 %", "most",
                 "% of pixels with more than S/2", "% with S"},
                {}};
    Table histogram{"Histogram", {"scene", "S", "surfaces", "part of pixels"}, {}};
    std::string depths;
    double done = 0;
    for (const EntryScene& scene : kScenes) {
        const std::string source = scene.of(job);
        Surfaces surfaces(view);
        const std::vector<Take> takes = {{.method = choose_method("none"), .keys = {key}}};
        render_takes(load(source), view, job.options, {.takes = takes, .sink = &surfaces});
        surfaces.sort();
        std::vector<Series> lines;
        for (const int samples : kSamples) {
            lines.push_back({"S = " + std::to_string(samples), {}, {}});
            add_counts(scene, samples, {surfaces.held(samples, key)}, table, histogram,
                       lines.back());
        }
        depths +=
            (depths.empty() ? "" : ", ") + fixed(surfaces.mean_depth(), 1) + " (" + source + ")";
        const std::string suffix = "." + std::string(scene.name) + ".svg";
        page.write_text(suffix, log_log_chart("Part of pixels that hold so many surfaces: " +
                                                  std::string(scene.name),
                                              lines, "surfaces in the pixel's samples"));
        page.show(page.file(suffix), source);
        job.progress(++done / static_cast<double>(std::size(kScenes)));
    }
    page.say(size_text(view.width, view.height) +
             " pixels, all samples at the centre, stratified masks, of pixels that have any "
             "surface. A pixel has, on average over those, " +
             depths + " surfaces. *Exact*: of " + std::to_string(kLayers) +
             " layers of opacity .5, each of which has S/2 samples, every choice alike; *z*: the "
             "measured mean's distance from it in standard errors.");
    page.add(table);
    page.write_text(".csv", histogram.csv());
    page.write();
}

}  // namespace sheer
