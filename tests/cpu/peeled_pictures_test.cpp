// Pictures peeled until nothing is left are the exact ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <sheer/sheer.h>

#include "cpu/fragment_sink.h"
#include "cpu/frame.h"
#include "cpu/small_pictures.h"

namespace sheer::test {
namespace {

constexpr double kSame = 1e-5;  // times the larger of 1 and the colour
constexpr const char* kPeeling[] = {"depth-peeling", "dual-depth-peeling",
                                    "bucket-peeling:peels=4096"};

struct Place {
    float depth, slack;
};

// The pixels where floats may not tell which of two surfaces is nearer: their depths at the centre
// differ by no more than their slacks.
class Doubts : public FragmentSink {
public:
    explicit Doubts(const View& view)
        : width_(view.width), pixels_(static_cast<std::size_t>(view.width * view.height))
    {
    }

    void take(const PixelRect& rect, const PixelRect& interior, const ChannelShape&,
              const FragmentStream& stream) override
    {
        for_each_inside(rect, interior, stream,
                        [&](const FragmentRun& run, std::size_t, int x, int y, float depth) {
                            pixels_[static_cast<std::size_t>(y * width_ + x)].push_back(
                                {depth, run.depth.slack});
                        });
    }

    std::size_t count()
    {
        return static_cast<std::size_t>(
            std::count_if(pixels_.begin(), pixels_.end(), [](auto& places) {
                std::sort(places.begin(), places.end(),
                          [](const Place& a, const Place& b) { return a.depth < b.depth; });
                return std::adjacent_find(
                           places.begin(), places.end(), [](const Place& near, const Place& far) {
                               return far.depth - near.depth <= near.slack + far.slack;
                           }) != places.end();
            }));
    }

private:
    int width_;
    std::vector<std::vector<Place>> pixels_;
};

View small_view(int samples)
{
    View view = square(64, samples);
    view.positions = SamplePositions::center;
    return view;
}

double difference(const std::array<float, 4>& a, const std::array<float, 4>& b)
{
    double most = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        const double scale = std::max(1.0, std::abs(static_cast<double>(b[c])));
        most = std::max(most, std::abs(static_cast<double>(a[c]) - b[c]) / scale);
    }
    return most;
}

// Where surfaces cross and nearly touch, floats do not know the order in some pixels.
TEST(PeeledPictures, AreExact)
{
    std::size_t doubtful = 0;
    for (const char* source : {"builtin:foliage", "builtin:motor?detail=0.2", "builtin:cloth"}) {
        const Scene scene = load(source);
        Doubts doubts(small_view(1));
        Take take{.method = choose_method("exact"), .keys = {frame_key(1, 0)}};
        render_takes(scene, small_view(1), {}, {.takes = {&take, 1}, .sink = &doubts});
        doubtful += doubts.count();
        for (const int samples : {1, 8}) {
            View view = small_view(samples);
            if (samples > 1) view.positions = SamplePositions::standard;
            const Image exact = draw(scene, view, "exact");
            for (const char* method : kPeeling) {
                SCOPED_TRACE(std::string(source) + ", " + method);
                const Image peeled = draw(scene, view, method);
                for (std::size_t p = 0; p < exact.pixels.size(); ++p) {
                    EXPECT_LE(difference(peeled.pixels[p], exact.pixels[p]), kSame) << p;
                }
            }
        }
    }
    // Else there would be little to say.
    EXPECT_GT(doubtful, 100u);
}

// Coincident to the last bit: ids decide, here and there.
TEST(PeeledPictures, AreExactWithTies)
{
    for (const int samples : {1, 4}) {
        const Scene scene = load(
            "builtin:layers?n=12&alpha=0.2,0.7,0.3,0.5&color=1,0,0;0,1,0;0,0,1;1,1,0;0,1,1;1,0,1"
            "&depth=1,1,2,2,2,3,3,3,3,4&order=random&seed=5&background=0.5,0.5,0.5");
        const Image exact = draw(scene, small_view(samples), "exact");
        for (const char* method : kPeeling) {
            const Image peeled = draw(scene, small_view(samples), method);
            for (std::size_t p = 0; p < exact.pixels.size(); ++p) {
                ASSERT_LE(difference(peeled.pixels[p], exact.pixels[p]), kSame) << method;
            }
        }
    }
}

}  // namespace
}  // namespace sheer::test
