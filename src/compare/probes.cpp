// Kept as they come, sorted by (depth, primitive) at the end: no order of arrival shows.
#include "compare/probes.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sheer {

namespace {

int spacing_for(int width, int height, int most)
{
    const double pixels = static_cast<double>(width) * height;
    return std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / most))));
}

}  // namespace

Probes::Probes(int width, int height, int most, std::uint64_t most_bytes)
    : spacing_(spacing_for(width, height, most)),
      first_(spacing_ / 2),
      columns_((std::max(width - first_, 1) + spacing_ - 1) / spacing_),
      rows_((std::max(height - first_, 1) + spacing_ - 1) / spacing_),
      kept_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      most_layers_(most_bytes / kBytesOfLayer / kept_.size()),
      too_many_(kept_.size()),
      samples_(kept_.size())
{
}

void Probes::take(const PixelRect& rect, const PixelRect& interior, const ChannelShape& shape,
                  const FragmentStream& stream)
{
    const auto keep = [&](const FragmentRun& run, std::size_t i, int x, int y, float depth) {
        if (x % spacing_ != first_ % spacing_ || y % spacing_ != first_ % spacing_) return;
        const auto probe = static_cast<std::size_t>(y / spacing_ * columns_ + x / spacing_);
        if (too_many_[probe] != 0) return;
        if (kept_[probe].size() == most_layers_) {
            too_many_[probe] = 1;
            std::vector<Kept>().swap(kept_[probe]);
            return;
        }
        const std::uint64_t samples = stream.sample_bits(i);
        samples_[probe] = shape.samples;
        kept_[probe].push_back({depth,
                                run.primitive,
                                samples,
                                {.depth = shape.eye.orthographic ? depth : -1 / depth,
                                 .opacity = stream.opacity[i],
                                 .coverage = static_cast<float>(std::popcount(samples)) /
                                             static_cast<float>(shape.samples),
                                 .color = {stream.red[i], stream.green[i], stream.blue[i]}}});
    };
    for_each_inside(rect, interior, stream, keep);
}

std::vector<Probe> Probes::results() const
{
    std::vector<Probe> probes;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        std::vector<Kept> kept = kept_[i];
        std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) {
            return a.depth != b.depth ? a.depth < b.depth : a.primitive < b.primitive;
        });
        const auto columns = static_cast<std::size_t>(columns_);
        Probe probe{first_ + static_cast<int>(i % columns) * spacing_,
                    first_ + static_cast<int>(i / columns) * spacing_,
                    {},
                    too_many_[i] != 0};
        std::vector<double> left(static_cast<std::size_t>(samples_[i]), 1);
        for (const Kept& one : kept) {
            double sum = 0;
            for (std::size_t s = 0; s < left.size(); ++s) {
                if (one.samples >> s & 1) left[s] *= 1 - double{one.step.opacity};
                sum += left[s];
            }
            probe.steps.push_back(one.step);
            probe.steps.back().behind = sum / static_cast<double>(left.size());
        }
        probes.push_back(std::move(probe));
    }
    return probes;
}

}  // namespace sheer
