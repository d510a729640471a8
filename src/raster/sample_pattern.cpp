// Where a pixel's samples are: the standard multisample positions and Hammersley points.
//
// Standard: Vulkan 1.3 specification, "Multisampling", table "Standard sample locations"; the same
// points, as offsets from the centre in 1/16 pixel, are Direct3D's
// D3D11_STANDARD_MULTISAMPLE_PATTERN. Hammersley: J. M. Hammersley, "Monte Carlo methods for
// solving multivariable problems", 1960.
#include "raster/sample_pattern.h"

#include <span>
#include <string>

#include <sheer/error.h>

namespace sheer {

namespace {

struct Offset {
    int x, y;  // 1/16 pixel from the centre, x to the right, y down
};

constexpr Offset kStandard1[] = {{0, 0}};
constexpr Offset kStandard2[] = {{4, 4}, {-4, -4}};
constexpr Offset kStandard4[] = {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
constexpr Offset kStandard8[] = {{1, -3}, {-1, 3},  {5, 1}, {-3, -5},
                                 {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
constexpr Offset kStandard16[] = {{1, 1},  {-1, -3}, {-3, 2}, {4, -1}, {-5, -2}, {2, 5},
                                  {5, 3},  {3, -5},  {-2, 6}, {0, -7}, {-4, -6}, {-6, 4},
                                  {-8, 0}, {7, -4},  {6, 7},  {-7, -8}};

constexpr int kPixel = 256;
constexpr int kCenter = kPixel / 2;

std::span<const Offset> standard_offsets(int samples)
{
    switch (samples) {
        case 1: return kStandard1;
        case 2: return kStandard2;
        case 4: return kStandard4;
        case 8: return kStandard8;
        case 16: return kStandard16;
        default: return {};
    }
}

int reversed_bits(int value, int samples)
{
    int reversed = 0;
    for (int bit = 1; bit < samples; bit *= 2) {
        reversed = 2 * reversed + ((value & bit) != 0 ? 1 : 0);
    }
    return reversed;
}

}  // namespace

std::vector<SamplePoint> sample_pattern(int samples, SamplePositions positions)
{
    const std::span<const Offset> offsets = standard_offsets(samples);
    if (offsets.empty() && samples != 32 && samples != kMaxSamples) {
        throw Error(Fault::input, "samples: " + std::to_string(samples) +
                                      " is none of 1, 2, 4, 8, 16, 32 and 64");
    }
    if (positions == SamplePositions::center) {
        return std::vector<SamplePoint>(static_cast<std::size_t>(samples), {kCenter, kCenter});
    }
    std::vector<SamplePoint> points;
    for (const Offset& offset : offsets) {
        points.push_back({kCenter + 16 * offset.x, kCenter + 16 * offset.y});
    }
    if (offsets.empty()) {
        // A cell's half makes the mean the pixel's centre and keeps every point off the pixel's
        // edge.
        const int cell = kPixel / samples;
        for (int i = 0; i < samples; ++i) {
            points.push_back({i * cell + cell / 2, reversed_bits(i, samples) * cell + cell / 2});
        }
    }
    return points;
}

}  // namespace sheer
