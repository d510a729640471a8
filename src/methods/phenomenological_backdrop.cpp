// Sample by sample in plain numbers: looking up takes most of the time.
#include "methods/phenomenological_backdrop.h"

#include <algorithm>
#include <bit>

#include "lanes/lone.h"

namespace sheer {

namespace {

struct Text {
    using L = Lone<float>;
#include "lanes/text_words.h"
#include "sheer/phenomenological.glsl"
};

// A unit of D in pixels of a picture 1080 high, as the paper's filter has it; in others as large a
// part of the height.
constexpr float kDiffusionPixels = 200.0f, kDiffusionHeight = 1080.0f;
// Of the picture's width and height: what an offset in the paper's format, 8 times as large and in
// [-1, 1], can be.
constexpr float kMostOffset = 0.125f;
// Where nothing is behind, in metres.
constexpr float kFar = 1e30f;

// With what turns no ray: towards the eye, as long as 1.
Text::real3 normal_of(const DepthPlane& plane, float depth, Text::real3 ray, bool orthographic,
                      BackdropPicture::Scale scale)
{
    // Of the plane's equation: away from the eye. -depth is 1 / distance under perspective, which
    // is linear along the ray's slopes: all of a plane n p = 1 at p = distance times ray.
    const float x = -plane.dx * scale.x, y = -plane.dy * scale.y;
    const float z = orthographic ? 1.0f : -depth - (x * ray.x + y * ray.y);
    const float inverse = -1.0f / std::sqrt(x * x + y * y + z * z);
    return {x * inverse, y * inverse, z * inverse};
}

}  // namespace

PhenomenologicalSettings phenomenological_settings(const ChosenMethod& method)
{
    return {1.0f - static_cast<float>(method.real("diffusion")),
            static_cast<float>(method.real("refraction"))};
}

PhenomenologicalBackdrop::PhenomenologicalBackdrop(const StoreShape& shape)
    : set_(*shape.samples),
      picture_(*shape.backdrop),
      settings_(phenomenological_settings(*shape.method)),
      eye_(shape.eye),
      changes_(kTilePixels * static_cast<std::size_t>(set_.count))
{
}

void PhenomenologicalBackdrop::clear(const TilePlace& place)
{
    place_ = place;
    if (any_) std::fill(changes_.begin(), changes_.end(), Change{});
    any_ = false;
}

PhenomenologicalBackdrop::Change PhenomenologicalBackdrop::change_of(const FragmentStream& stream,
                                                                     const FragmentRun& run,
                                                                     std::size_t i) const
{
    const auto pixel = static_cast<int>(stream.pixel[i]);
    const int column = place_.x + pixel % kTileSize, row = place_.y + pixel / kTileSize;
    const float depth = std::clamp(stream.depth[i], run.depth.least, run.depth.most);
    const float z = eye_.orthographic ? depth : -1.0f / depth;
    const float nearness = picture_.nearness(column, row);
    const float behind = nearness > 0 ? std::max(1.0f / nearness - z, 0.0f) : kFar;

    Change change;
    if (settings_.diffuses()) {
        const float pixels =
            static_cast<float>(picture_.height()) * (kDiffusionPixels / kDiffusionHeight);
        change.variance =
            pixels * pixels *
            Text::phenomenological_diffusion(stream.opacity[i], settings_.collimation, z, behind);
    }
    // Rays that leave glass go on as they are, as in the paper.
    if (!settings_.refracts() || run.back_facing) return change;
    const BackdropPicture::Scale scale = picture_.scale();
    const auto width = static_cast<float>(picture_.width());
    const auto height = static_cast<float>(picture_.height());
    Text::real3 ray(0, 0, 1);
    if (!eye_.orthographic) {
        ray.x = (static_cast<float>(column) + 0.5f - 0.5f * width) / scale.x;
        ray.y = (static_cast<float>(row) + 0.5f - 0.5f * height) / scale.y;
    }
    const auto turned = Text::phenomenological_refraction(
        ray, normal_of(run.depth, depth, ray, eye_.orthographic, scale), settings_.eta);
    const float part = eye_.orthographic ? behind : behind / (z + behind);
    const auto offset = [&](float tangent, float pixels, float size) {
        return std::clamp(tangent * part * pixels, -kMostOffset * size, kMostOffset * size);
    };
    change.x = offset(turned.x, scale.x, width);
    change.y = offset(turned.y, scale.y, height);
    return change;
}

void PhenomenologicalBackdrop::insert(const FragmentStream& stream)
{
    const auto samples = static_cast<std::size_t>(set_.count);
    for (int r = 0; r < stream.run_count; ++r) {
        const FragmentRun& run = stream.runs[r];
        for (std::size_t i = run.first; i < run.first + run.count; ++i) {
            const Change change = change_of(stream, run, i);
            any_ = true;
            for (std::uint64_t left = stream.sample_bits(i) & set_.all(); left != 0;
                 left &= left - 1) {
                const auto s = static_cast<std::size_t>(std::countr_zero(left));
                Change& sum = changes_[stream.pixel[i] * samples + s];
                sum = {sum.variance + change.variance, sum.x + change.x, sum.y + change.y};
            }
        }
    }
}

void PhenomenologicalBackdrop::merge(const PhenomenologicalBackdrop& other)
{
    any_ = any_ || other.any_;
    for (std::size_t i = 0; i < changes_.size(); ++i) {
        Change& sum = changes_[i];
        const Change& more = other.changes_[i];
        sum = {sum.variance + more.variance, sum.x + more.x, sum.y + more.y};
    }
}

void PhenomenologicalBackdrop::replace(SampleColors& backdrop) const
{
    if (!any_) return;
    const auto samples = static_cast<std::size_t>(set_.count);
    const float most_x = kMostOffset * static_cast<float>(picture_.width());
    const float most_y = kMostOffset * static_cast<float>(picture_.height());
    for (std::size_t i = 0; i < changes_.size(); ++i) {
        const Change& change = changes_[i];
        const bool moves = change.x != 0 || change.y != 0;
        if (!(change.variance > 0) && !moves) continue;
        const std::size_t pixel = i / samples, s = i % samples;
        float* channels[4];
        Float4 color;
        for (std::size_t c = 0; c < 4; ++c) {
            channels[c] = backdrop.channel(pixel, c) + s;
            color[c] = *channels[c];
        }
        const float x = static_cast<float>(place_.x + static_cast<int>(pixel % kTileSize)) + 0.5f +
                        std::clamp(change.x, -most_x, most_x);
        const float y = static_cast<float>(place_.y + static_cast<int>(pixel / kTileSize)) + 0.5f +
                        std::clamp(change.y, -most_y, most_y);
        if (moves) color = picture_.between(x, y);
        if (change.variance > 0) color = picture_.blurred(x, y, change.variance, color);
        for (std::size_t c = 0; c < 4; ++c) *channels[c] = color[c];
    }
}

}  // namespace sheer
