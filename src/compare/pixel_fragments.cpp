// Gathered from the one tile that has the pixel; sorted sample by sample.
#include "compare/pixel_fragments.h"

#include <algorithm>

#include "geometry/meet.h"

namespace sheer {

namespace {

// A fragment at a sample.
struct Event {
    float depth, opacity;
    std::size_t sample;
};

std::vector<Event> events_of(const std::vector<PixelFragment>& fragments, const SampleSet& samples)
{
    std::vector<Event> events;
    for (const PixelFragment& f : fragments) {
        const DepthPlane& plane = f.run.depth;
        for (std::size_t s = 0; s < static_cast<std::size_t>(samples.count); ++s) {
            if ((f.samples >> s & 1) == 0) continue;
            const float offset = samples.offset_x[s] * plane.dx + samples.offset_y[s] * plane.dy;
            events.push_back({std::clamp(f.depth + offset, plane.least, plane.most), f.opacity, s});
        }
    }
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return a.depth < b.depth; });
    return events;
}

}  // namespace

void PixelFragments::take(const PixelRect& rect, const PixelRect& interior,
                          const ChannelShape& shape, const FragmentStream& stream)
{
    // Only the tile that has the pixel may look at what it writes: the others do so meanwhile.
    if (!meet(interior, {x_, y_, x_ + 1, y_ + 1}) || too_many_) return;
    eye = shape.eye;
    place = {rect.x0, rect.y0};
    in_tile = static_cast<std::uint32_t>((y_ - rect.y0) * kTileSize + x_ - rect.x0);
    for (std::size_t r = 0; r < static_cast<std::size_t>(stream.run_count); ++r) {
        const FragmentRun& run = stream.runs[r];
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            if (stream.pixel[i] != in_tile) continue;
            too_many_ = fragments.size() == most_;
            if (too_many_) {
                std::vector<PixelFragment>().swap(fragments);
                return;
            }
            fragments.push_back({run, stream.depth[i], stream.sample_bits(i), stream.red[i],
                                 stream.green[i], stream.blue[i], stream.opacity[i]});
        }
    }
}

void PixelFragments::fill(FragmentStream& stream) const
{
    stream.clear();
    for (const PixelFragment& f : fragments) {
        const int i = stream.size++;
        stream.runs[stream.run_count] = f.run;
        stream.runs[stream.run_count].first = static_cast<std::uint32_t>(i);
        stream.runs[stream.run_count++].count = 1;
        stream.pixel[i] = in_tile;
        stream.samples[i] = static_cast<std::uint32_t>(f.samples);
        stream.samples_high[i] = static_cast<std::uint32_t>(f.samples >> 32);
        stream.depth[i] = f.depth;
        stream.red[i] = f.red;
        stream.green[i] = f.green;
        stream.blue[i] = f.blue;
        stream.opacity[i] = f.opacity;
    }
}

std::vector<TransmittanceStep> transmittance_steps(const std::vector<PixelFragment>& fragments,
                                                   const SampleSet& samples)
{
    std::vector<double> left(static_cast<std::size_t>(samples.count), 1);
    std::vector<TransmittanceStep> steps;
    const std::vector<Event> events = events_of(fragments, samples);
    for (std::size_t i = 0; i < events.size(); ++i) {
        left[events[i].sample] *= 1 - static_cast<double>(events[i].opacity);
        if (i + 1 < events.size() && events[i + 1].depth == events[i].depth) continue;
        double sum = 0;
        for (const double l : left) sum += l;
        steps.push_back({events[i].depth, sum / static_cast<double>(left.size())});
    }
    return steps;
}

double transmittance_at(std::span<const TransmittanceStep> steps, float depth)
{
    const auto after =
        std::lower_bound(steps.begin(), steps.end(), depth,
                         [](const TransmittanceStep& step, float z) { return step.depth < z; });
    return after == steps.begin() ? 1 : (after - 1)->behind;
}

}  // namespace sheer
