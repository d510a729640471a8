// Random fragments of one tile, and one store under test.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <span>
#include <vector>

#include "lanes/targets.h"
#include "methods/fragment_lists.h"
#include "methods/method.h"
#include "reference/reference.h"

namespace sheer {

inline constexpr std::size_t kUsedPixels = 24;  // of the tile

inline constexpr std::uint32_t tile_pixel(std::size_t used)
{
    return static_cast<std::uint32_t>(41 * used);  // all over the tile's columns and rows
}

// Fragments of one triangle: one in each used pixel of which it covers a sample.
struct Plate {
    DepthPlane depth = {};
    std::uint32_t primitive = 0, object = 0;
    std::array<std::uint64_t, kUsedPixels> samples = {};
    Float4 color = {};  // straight, opacity last
};
using Plates = std::vector<Plate>;

// As FragmentStream::place has it, in the tile's first pixel: another place on its surface for each
// plate, and another plane over the screen, of all sizes, some along an axis.
inline std::array<float, 9> first_place_of(const Plate& plate)
{
    // Cheap to seed; its first number is nearly the seed.
    std::minstd_rand random(plate.primitive * 69621u + 1);
    random.discard(3);
    std::uniform_real_distribution<float> uniform(-1, 1);
    std::array<float, 9> place;
    for (float& c : place) c = uniform(random);
    const float size = std::ldexp(1.0f, static_cast<int>(random() >> 8 & 15u) - 12);
    for (std::size_t c = 3; c < 9; ++c) place[c] *= size;
    if ((random() >> 8 & 3u) == 0) place[3] = place[6] = 0;
    return place;
}

// The same in another pixel.
inline std::array<float, 9> place_at(std::array<float, 9> place, std::uint32_t pixel)
{
    for (std::size_t c = 0; c < 3; ++c) {
        place[c] += static_cast<float>(pixel % kTileSize) * place[3 + c] +
                    static_cast<float>(pixel / kTileSize) * place[6 + c];
    }
    return place;
}

// FragmentStream::level of the plate: below the first, between two, and beyond the paper's sixth.
inline float level_of(const Plate& plate)
{
    return static_cast<float>(plate.primitive % 9) - 1.25f;
}

// `at` at the centre of the tile's first pixel. Wide enough that clamping changes nothing.
inline DepthPlane make_plane(double at, double dx, double dy)
{
    const double reach = (kTileSize + 1) * (std::abs(dx) + std::abs(dy));
    DepthPlane plane{static_cast<float>(dx),
                     static_cast<float>(dy),
                     static_cast<float>(at - reach),
                     static_cast<float>(at + reach),
                     0,
                     at,
                     dx,
                     dy};
    plane.slack = depth_slack(plane, 0);
    return plane;
}

inline float depth_at_center(const DepthPlane& plane, std::uint32_t pixel)
{
    return static_cast<float>(plane.precise_at + (pixel % kTileSize * plane.precise_dx +
                                                  pixel / kTileSize * plane.precise_dy));
}

struct RandomPlates {
    const SampleSet& set;
    std::mt19937& random;
    bool perspective = false;  // depth is -1 / distance

    // A third at one of four depths, a third cut one another in and around 1 to 2 metres, the rest
    // are anywhere from 0.1 to 500 metres.
    DepthPlane plane()
    {
        std::uniform_real_distribution<double> uniform(0, 1);
        const auto kind = random() % 3;
        const double z = kind == 0   ? 1.0 + 0.25 * static_cast<double>(random() % 4)
                         : kind == 1 ? 1.0 + uniform(random)
                                     : 0.1 * std::pow(5000.0, uniform(random));
        const auto at = static_cast<double>(static_cast<float>(perspective ? -1 / z : z));
        const double tilt = kind == 1 ? 0.004 : 0.0;
        return make_plane(at, tilt * (uniform(random) - 0.5), tilt * (uniform(random) - 0.5));
    }
    std::uint64_t some_samples() { return (std::uint64_t{random()} << 32 | random()) & set.all(); }

    Plates make(int count)
    {
        std::uniform_real_distribution<float> uniform(0, 1);
        Plates plates;
        for (int i = 0; i < count; ++i) {
            const auto number = static_cast<std::uint32_t>(i);
            Plate plate{plane(), number, number / 3, {}, {}};
            for (std::uint64_t& samples : plate.samples) samples = some_samples();
            plate.color = {uniform(random), uniform(random), uniform(random),
                           random() % 8 == 0 ? 1.0f : uniform(random)};
            plates.push_back(plate);
        }
        return plates;
    }
};

inline void fill_stream(std::span<const Plate> plates, FragmentStream& stream)
{
    stream.clear();
    for (const Plate& plate : plates) {
        const auto first = static_cast<std::uint32_t>(stream.size);
        const auto first_place = stream.placed ? first_place_of(plate) : std::array<float, 9>{};
        for (std::size_t i = 0; i < kUsedPixels; ++i) {
            if (plate.samples[i] == 0) continue;
            const int at = stream.size++;
            stream.pixel[at] = tile_pixel(i);
            stream.samples[at] = static_cast<std::uint32_t>(plate.samples[i]);
            stream.samples_high[at] = static_cast<std::uint32_t>(plate.samples[i] >> 32);
            stream.depth[at] = depth_at_center(plate.depth, tile_pixel(i));
            stream.red[at] = plate.color[0];
            stream.green[at] = plate.color[1];
            stream.blue[at] = plate.color[2];
            stream.opacity[at] = plate.color[3];
            if (!stream.placed) continue;
            const std::array<float, 9> place = place_at(first_place, tile_pixel(i));
            for (std::size_t c = 0; c < 9; ++c) stream.place[c][at] = place[c];
            stream.level[at] = level_of(plate);
        }
        const auto count = static_cast<std::uint32_t>(stream.size) - first;
        if (count == 0) continue;
        stream.runs[stream.run_count++] = {first, count, plate.primitive, plate.object,
                                           plate.depth};
    }
}

// A tile's colours, in the order of SampleColors.
using Colors = std::vector<float>;

inline bool same_bits(const Colors& a, const Colors& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

inline std::size_t color_index(const SampleSet& set, std::uint32_t pixel, std::size_t s,
                               std::size_t channel)
{
    return (4 * pixel + channel) * static_cast<std::size_t>(set.count) + s;
}

// Numbers from 0 to 1, these two among them, that repeat after a prime's number of them.
inline Colors random_backdrop(const SampleSet& set, std::mt19937& random)
{
    std::uniform_real_distribution<float> uniform(0, 1);
    std::array<float, 1021> pool;
    for (float& c : pool) {
        const auto kind = random() % 8;
        c = kind == 0 ? 0.0f : kind == 1 ? 1.0f : uniform(random);
    }
    Colors colors(4 * kTilePixels * static_cast<std::size_t>(set.count));
    for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = pool[i % pool.size()];
    return colors;
}

// What one store is made for.
struct Setting {
    ChosenMethod method;
    const SampleSet* set;
    Simd level = Simd::best;
    EyeSpace eye = {true, 0.1f, 500.0f};
    bool filter_mixes_pixels = true;
    const ReducedMoments* reduced = nullptr;
};

// One store under test, clear at first.
class Tile {
public:
    explicit Tile(const Setting& setting)
        : setting_(setting),
          verbs_(setting.method.row->verbs(targets_of(setting.level), setting.method,
                                           setting.set->count)),
          store_(verbs_.make({setting.set, &setting_.method, setting.eye, kMostFragments,
                              ~std::size_t{0}, setting.filter_mixes_pixels, setting.reduced}))
    {
        verbs_.clear(store_.get(), {64, 32, 0x1234567u});
    }
    Tile(const Tile&) = delete;
    Tile& operator=(const Tile&) = delete;

    void insert(std::span<const Plate> plates)
    {
        seen_.insert(seen_.end(), plates.begin(), plates.end());
        insert(plates, 0);
    }
    // All of `later` arrived later, for the methods that see it. Merged after the first pass.
    void merge(const Tile& later)
    {
        verbs_.merge(store_.get(), later.store_.get());
        seen_.insert(seen_.end(), later.seen_.begin(), later.seen_.end());
    }

    // After the passes that are left.
    SampleColors resolve_samples(const Colors& backdrop)
    {
        const MethodTraits traits = setting_.method.traits();
        const auto done = [&] { return verbs_.done != nullptr && verbs_.done(store_.get()); };
        for (; pass_ < traits.passes && !done(); ++pass_) insert(seen_, pass_);
        SampleColors colors(setting_.set->count, traits.divides);
        std::copy(backdrop.begin(), backdrop.end(), colors.values.data());
        verbs_.resolve(store_.get(), colors);
        return colors;
    }
    // Of a method that divides, the filter being a sample's.
    Colors resolve(const Colors& backdrop)
    {
        SampleColors colors = resolve_samples(backdrop);
        if (setting_.method.traits().divides) test::add_fraction(colors);
        return {colors.values.data(), colors.values.data() + colors.values.size()};
    }

private:
    static constexpr int kMostFragments = 4096;

    void insert(std::span<const Plate> plates, int pass)
    {
        constexpr std::size_t kMost = kMostFragments / kUsedPixels;
        static FragmentStream placed(kMostFragments, false, true), unplaced(kMostFragments);
        FragmentStream& stream = setting_.method.wants().places ? placed : unplaced;
        for (; !plates.empty(); plates = plates.subspan(std::min(kMost, plates.size()))) {
            fill_stream(plates.first(std::min(kMost, plates.size())), stream);
            verbs_.insert(store_.get(), stream, pass);
        }
    }

    Setting setting_;
    StoreVerbs verbs_;
    std::shared_ptr<void> store_;
    Plates seen_;
    int pass_ = 1;  // to come
};

inline Colors resolve_plates(const Setting& setting, std::span<const Plate> plates,
                             const Colors& backdrop)
{
    Tile tile(setting);
    tile.insert(plates);
    return tile.resolve(backdrop);
}

inline constexpr int kSampleCounts[] = {1, 2, 4, 8, 16, 32, 64};

// One of each of kSampleCounts.
inline const std::vector<SampleSet>& sample_sets()
{
    static const std::vector<SampleSet> sets = [] {
        std::vector<SampleSet> made;
        for (const int samples : kSampleCounts) {
            made.push_back(make_sample_set(samples, SamplePositions::standard));
        }
        return made;
    }();
    return sets;
}

// The fragments of a sample in the order of arrival, as the oracle wants them.
inline std::vector<reference::Fragment> fragments_at(std::span<const Plate> plates,
                                                     const SampleSet& set, std::size_t used,
                                                     std::size_t s)
{
    std::vector<reference::Fragment> fragments;
    for (const Plate& plate : plates) {
        if ((plate.samples[used] >> s & 1) == 0) continue;
        reference::Fragment fragment;
        fragment.depth = precise_depth(plate.depth, set, tile_pixel(used), s);
        fragment.opacity = static_cast<double>(plate.color[3]);
        std::fill_n(fragment.transmittance, 3, 1 - fragment.opacity);
        for (std::size_t c = 0; c < 3; ++c) fragment.color[c] = static_cast<double>(plate.color[c]);
        fragment.id = plate.primitive;
        fragments.push_back(fragment);
    }
    return fragments;
}

// No method's answer is above it, but for rounding.
inline double largest_input(std::span<const Plate> plates, const Colors& backdrop)
{
    float most = 1;  // of alpha
    for (const float c : backdrop) most = std::max(most, c);
    for (const Plate& plate : plates) {
        for (std::size_t c = 0; c < 3; ++c) most = std::max(most, plate.color[c]);
    }
    return static_cast<double>(most);
}

inline double largest_difference(const Colors& a, const Colors& b)
{
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    }
    return most;
}

}  // namespace sheer
