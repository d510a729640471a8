// Coverage of single triangles against the definition (docs/numerics.md), sample by sample in
// 64-bit integers, for every number of samples and every level of vector instructions.
#include <gtest/gtest.h>

#include <random>

#include <sheer/error.h>

#include "cpu/coverage_counter.h"

namespace sheer {

namespace {

bool covers(const Triangle& t, const SamplePoint& p)
{
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const std::int64_t dx = t.x[j] - t.x[i], dy = t.y[j] - t.y[i];
        const std::int64_t e = dx * (p.y - t.y[i]) - dy * (p.x - t.x[i]);
        const bool top_or_left = dy < 0 || (dy == 0 && dx > 0);
        if (e < 0 || (e == 0 && !top_or_left)) return false;
    }
    return true;
}

// Corners within `spread` subpixels of a random place in or around the picture.
bool random_triangle(int spread, std::mt19937& random, Triangle& t)
{
    const auto place = [&](int most) {
        return static_cast<int>(random() % static_cast<unsigned>(most));
    };
    SamplePoint corners[3];
    const SamplePoint center{place(80 * kSubpixels) - 5 * kSubpixels,
                             place(60 * kSubpixels) - 5 * kSubpixels};
    for (SamplePoint& c : corners) {
        c = {center.x + place(2 * spread + 1) - spread, center.y + place(2 * spread + 1) - spread};
        if (random() % 4 == 0) c.x &= ~(kSubpixels / 2 - 1);  // edges through samples
        if (random() % 4 == 0) c.y &= ~(kSubpixels / 2 - 1);
    }
    if (random() % 5 == 0) corners[1].y = corners[0].y;
    t = screen_triangle(corners[0], corners[1], corners[2]);
    const std::int64_t area = std::int64_t{t.x[1] - t.x[0]} * (t.y[2] - t.y[0]) -
                              std::int64_t{t.x[2] - t.x[0]} * (t.y[1] - t.y[0]);
    if (area < 0) t = screen_triangle(corners[0], corners[2], corners[1]);
    return area != 0;
}

void check_level(Simd level)
{
    std::mt19937 random(5);
    for (const int samples : {1, 2, 4, 8, 16, 32, 64}) {
        for (const SamplePositions positions :
             {SamplePositions::standard, SamplePositions::center}) {
            CoverageCounter counter(70, 50, samples, positions);
            for (const int spread : {40, 300, 3000, 20000, 400000, 8000000}) {
                for (int round = 0; round < 8; ++round) {
                    Geometry geometry;
                    geometry.chunks.emplace_back();
                    Triangle t;
                    if (!random_triangle(spread, random, t)) continue;
                    geometry.chunks[0].triangles.push_back(t);
                    const std::vector<std::uint8_t>& counts =
                        counter.count(geometry, targets_of(level));
                    std::size_t wrong = 0;
                    for (std::size_t i = 0; i < counts.size(); ++i) {
                        wrong += counts[i] != (covers(t, counter.position(i)) ? 1 : 0);
                    }
                    ASSERT_EQ(wrong, 0u) << "S = " << samples << ", spread " << spread;
                }
            }
        }
    }
}

}  // namespace

TEST(Coverage, IsTheDefinition)
{
    for (const Simd level : {Simd::scalar, Simd::sse4, Simd::avx2, Simd::avx512, Simd::neon}) {
        try {
            targets_of(level);
        } catch (const Error&) {
            continue;  // not on this machine
        }
        check_level(level);
    }
}

}  // namespace sheer
