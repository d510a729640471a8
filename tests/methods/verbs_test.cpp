// The laws of the four verbs, over every row of the table, on random fragments of one tile.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <sheer/error.h>

#include "methods/method.h"

namespace sheer {

namespace {

struct Plate {
    DepthPlane depth;
    std::uint32_t primitive;
    std::vector<std::uint32_t> pixels;
    std::vector<std::uint64_t> samples;
    Float4 color;  // straight, opacity last
};

constexpr std::uint32_t kUsedPixels = 40;

// Planes that cross one another inside pixels, some at equal depth, some exactly alike.
std::vector<Plate> random_runs(int count, const SampleSet& set, std::mt19937& random)
{
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<Plate> runs;
    for (int i = 0; i < count; ++i) {
        Plate run;
        const bool flat = random() % 3 == 0;
        const double at = flat ? 1.0 + static_cast<double>(random() % 4) * 0.25
                               : 1.0 + static_cast<double>(uniform(random));
        const double dx = flat ? 0.0 : static_cast<double>(uniform(random) - 0.5f) * 0.02;
        run.depth = {static_cast<float>(dx), 0, 0.5f, 3.0f, 0, at, dx, 0};
        run.depth.slack = depth_slack(run.depth, 0);
        run.primitive = static_cast<std::uint32_t>(i);
        for (std::uint32_t p = 0; p < kUsedPixels; ++p) {
            const std::uint64_t bits = (std::uint64_t{random()} << 32 | random()) & set.all();
            if (bits == 0) continue;
            run.pixels.push_back(p);
            run.samples.push_back(bits);
        }
        run.color = {uniform(random), uniform(random), uniform(random),
                     random() % 8 == 0 ? 1.0f : uniform(random)};
        if (!run.pixels.empty()) runs.push_back(run);
    }
    return runs;
}

void fill_stream(std::span<const Plate> runs, FragmentStream& stream)
{
    stream.clear();
    for (const Plate& run : runs) {
        stream.runs[stream.run_count++] = {static_cast<std::uint32_t>(stream.size),
                                           static_cast<std::uint32_t>(run.pixels.size()),
                                           run.primitive, 0, run.depth};
        for (std::size_t i = 0; i < run.pixels.size(); ++i) {
            const int at = stream.size++;
            stream.pixel[at] = run.pixels[i];
            stream.samples[at] = static_cast<std::uint32_t>(run.samples[i]);
            stream.samples_high[at] = static_cast<std::uint32_t>(run.samples[i] >> 32);
            const double column = run.pixels[i] % kTileSize;
            stream.depth[at] =
                static_cast<float>(run.depth.precise_at + column * run.depth.precise_dx);
            stream.red[at] = run.color[0];
            stream.green[at] = run.color[1];
            stream.blue[at] = run.color[2];
            stream.opacity[at] = run.color[3];
        }
    }
}

// One store under test.
class Tile {
public:
    Tile(const MethodRow& row, const SampleSet& set)
        : method_(choose_method(row.id)),
          verbs_(row.verbs(targets_of(Simd::best), method_, set.count)),
          store_(verbs_.make({&set, &method_, {true, 0, 0}, kMostFragments})),
          set_(set)
    {
        verbs_.clear(store_.get(), {});
    }
    void insert(std::span<const Plate> runs)
    {
        FragmentStream stream(kMostFragments);
        fill_stream(runs, stream);
        verbs_.insert(store_.get(), stream, 0);
    }
    void merge(const Tile& other) { verbs_.merge(store_.get(), other.store_.get()); }
    std::vector<float> resolve(const Float4& background)
    {
        SampleColors colors(set_.count);
        for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
            for (std::size_t c = 0; c < 4; ++c) {
                std::fill_n(colors.channel(pixel, c), set_.count, background[c]);
            }
        }
        verbs_.resolve(store_.get(), colors);
        return {colors.values.data(), colors.values.data() + colors.values.size()};
    }

private:
    static constexpr int kMostFragments = 4096;

    ChosenMethod method_;
    StoreVerbs verbs_;
    std::shared_ptr<void> store_;
    const SampleSet& set_;
};

constexpr Float4 kBackground = {0.3f, 0.5f, 0.0f, 0.75f};
constexpr int kSampleCounts[] = {1, 2, 4, 8, 16, 32, 64};

std::vector<float> resolve_runs(const MethodRow& row, const SampleSet& set,
                                std::span<const Plate> runs)
{
    Tile tile(row, set);
    tile.insert(runs);
    return tile.resolve(kBackground);
}

const MethodRow& row_of(const char* id)
{
    return *choose_method(id).row;
}

}  // namespace

TEST(Verbs, AClearStoreShowsTheBackgroundBitForBit)
{
    for (const MethodRow& row : method_table()) {
        for (const int samples : kSampleCounts) {
            const SampleSet set = make_sample_set(samples, SamplePositions::standard);
            Tile tile(row, set);
            const std::vector<float> result = tile.resolve(kBackground);
            for (std::size_t i = 0; i < result.size(); ++i) {
                const std::size_t channel = i / static_cast<std::size_t>(samples) % 4;
                ASSERT_EQ(result[i], kBackground[channel]) << row.id;
            }
        }
    }
}

TEST(Verbs, OneFragmentGoesOver)
{
    std::mt19937 random(1);
    for (const MethodRow& row : method_table()) {
        if (row.exact_up_to == 0) continue;
        for (const int samples : kSampleCounts) {
            const SampleSet set = make_sample_set(samples, SamplePositions::standard);
            const std::vector<Plate> runs = random_runs(1, set, random);
            const std::vector<float> result = resolve_runs(row, set, runs);
            for (std::size_t i = 0; i < runs[0].pixels.size(); ++i) {
                for (std::size_t s = 0; s < static_cast<std::size_t>(samples); ++s) {
                    const bool covered = (runs[0].samples[i] >> s & 1) != 0;
                    const float a = covered ? runs[0].color[3] : 0.0f;
                    const std::size_t at =
                        4 * runs[0].pixels[i] * static_cast<std::size_t>(samples) + s;
                    for (std::size_t c = 0; c < 4; ++c) {
                        const float front = c < 3 ? runs[0].color[c] : 1.0f;
                        // One product, one difference and one sum, all below 1.
                        ASSERT_NEAR(result[at + c * static_cast<std::size_t>(samples)],
                                    a * front + (1 - a) * kBackground[c], 4 * 0x1p-24f)
                            << row.id << ", S = " << samples;
                    }
                }
            }
        }
    }
}

TEST(Verbs, OrderIndependentMethodsDoNotSeeTheOrder)
{
    std::mt19937 random(2);
    for (const MethodRow& row : method_table()) {
        if (row.any_order != Agreement::bits) continue;
        for (const int samples : kSampleCounts) {
            const SampleSet set = make_sample_set(samples, SamplePositions::standard);
            std::vector<Plate> runs = random_runs(45, set, random);
            const std::vector<float> expected = resolve_runs(row, set, runs);
            for (int round = 0; round < 5; ++round) {
                std::shuffle(runs.begin(), runs.end(), random);
                ASSERT_EQ(resolve_runs(row, set, runs), expected) << row.id << ", S = " << samples;
            }
        }
    }
}

TEST(Verbs, MergedPartsAreTheWhole)
{
    std::mt19937 random(3);
    for (const char* id : {"exact", "none"}) {
        const MethodRow& row = row_of(id);
        const SampleSet set = make_sample_set(8, SamplePositions::standard);
        const std::vector<Plate> runs = random_runs(30, set, random);
        const std::vector<float> expected = resolve_runs(row, set, runs);
        for (const std::size_t cut : {std::size_t{0}, std::size_t{7}, runs.size()}) {
            Tile first(row, set), second(row, set);
            first.insert(std::span(runs).first(cut));
            second.insert(std::span(runs).subspan(cut));
            second.merge(first);
            EXPECT_EQ(second.resolve(kBackground), expected) << id << " cut at " << cut;
        }
    }
}

// In the order of submission merging is associative, to rounding.
TEST(Verbs, BlendMergesWhatCameLaterOverWhatCameFirst)
{
    std::mt19937 random(4);
    const MethodRow& row = row_of("blend");
    const SampleSet set = make_sample_set(4, SamplePositions::standard);
    const std::vector<Plate> runs = random_runs(30, set, random);
    const std::vector<float> expected = resolve_runs(row, set, runs);
    Tile first(row, set), second(row, set);
    first.insert(std::span(runs).first(11));
    second.insert(std::span(runs).subspan(11));
    first.merge(second);
    const std::vector<float> merged = first.resolve(kBackground);
    for (std::size_t i = 0; i < merged.size(); ++i) {
        // 30 layers of three roundings each.
        ASSERT_NEAR(merged[i], expected[i], 90 * 0x1p-24f);
    }
}

// Against a plain sort in doubles at every sample.
TEST(Verbs, ExactSortsEverySample)
{
    std::mt19937 random(5);
    for (const int samples : kSampleCounts) {
        const SampleSet set = make_sample_set(samples, SamplePositions::standard);
        const std::vector<Plate> runs = random_runs(60, set, random);
        const std::vector<float> result = resolve_runs(row_of("exact"), set, runs);
        for (std::uint32_t p = 0; p < kUsedPixels; ++p) {
            for (std::size_t s = 0; s < static_cast<std::size_t>(samples); ++s) {
                std::vector<std::pair<std::pair<double, std::uint32_t>, const Plate*>> layers;
                for (const Plate& run : runs) {
                    const auto at = std::find(run.pixels.begin(), run.pixels.end(), p);
                    if (at == run.pixels.end()) continue;
                    const auto i = static_cast<std::size_t>(at - run.pixels.begin());
                    if ((run.samples[i] >> s & 1) == 0) continue;
                    const double x = p % kTileSize + static_cast<double>(set.x[s] - 128) / 256;
                    layers.push_back(
                        {{run.depth.precise_at + x * run.depth.precise_dx, run.primitive}, &run});
                }
                std::sort(layers.begin(), layers.end());
                double red = 0, transmittance = 1;
                for (const auto& layer : layers) {
                    const double a = static_cast<double>(layer.second->color[3]);
                    red += transmittance * a * static_cast<double>(layer.second->color[0]);
                    transmittance *= 1 - a;
                }
                red += transmittance * static_cast<double>(kBackground[0]);
                const std::size_t at = 4 * p * static_cast<std::size_t>(samples) + s;
                // 60 layers, each a few roundings of terms that sum to at most 1.
                ASSERT_NEAR(static_cast<double>(result[at]), red, 240 * 0x1p-24)
                    << "S = " << samples << ", pixel " << p << ", sample " << s;
            }
        }
    }
}

TEST(Methods, ChoosingByText)
{
    EXPECT_STREQ(choose_method("exact").row->id, "exact");
    const auto message = [](const char* text) -> std::string {
        try {
            choose_method(text);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("exakt"),
              "method: there is no method 'exakt'; there are blend, sorted-blend, exact, "
              "stochastic, weighted-average, wboit");
    EXPECT_EQ(message("exact:k=3"), "method: exact has no parameter 'k'; it has none");
    EXPECT_EQ(message("exact:k"), "method: 'k' is not NAME=VALUE");
}

}  // namespace sheer
