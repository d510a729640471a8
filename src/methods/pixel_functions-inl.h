// The function of a method that approximates transmittance (shaders/sheer/transmittance.glsl), of
// each pixel of a tile. Lanes are fragments, and pixels where sums become what is kept.
//
// Nothing here depends on the number of samples. A pixel takes 8 bytes for each sum (4 at least)
// and 4 for each float kept.
#if defined(SHEER_PIXEL_FUNCTIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_PIXEL_FUNCTIONS_INL_H
#undef SHEER_PIXEL_FUNCTIONS_INL_H
#else
#define SHEER_PIXEL_FUNCTIONS_INL_H
#endif

#include "methods/depth_function.h"
#include "methods/translucent-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

// Fragments first, first + 1, ... of a stream, `some` of them, at most kChunk; there may be more up
// to a vector, of which nothing is taken.
struct FragmentChunk {
    const FragmentStream& stream;
    std::size_t first, some;
    const float* places;  // of the chunk's fragments
    const float* parts;   // of its pixel that each takes; null: all of it

    const float* opacity() const { return stream.opacity.data() + first; }
    const std::uint32_t* pixel() const { return stream.pixel.data() + first; }
};

class PixelFunctions {
    using Block = Lanes<16>;  // of fragments
    using Wide = WideLanes<kPrepared>;
    using Real = Block::real;
    using Text = TransmittanceText<Block>;
    static constexpr std::size_t kAround = 16;  // room for a vector

public:
    explicit PixelFunctions(std::unique_ptr<DepthFunction> function)
        : function_(std::move(function)),
          stride_(std::max(counts().sums, std::size_t{4})),
          sums_(kTilePixels * stride_),
          kept_(kTilePixels * counts().kept)
    {
    }

    const DepthFunction::Counts& counts() const { return function_->counts(); }
    int passes() const { return counts().passes; }
    void clear() { std::fill_n(sums_.data(), sums_.size(), std::int64_t{0}); }
    void merge(const PixelFunctions& other) { add_all(other.sums_, sums_); }
    const std::int64_t* sums(std::size_t pixel) const { return sums_.data() + pixel * stride_; }

    // Optical depths of the opacities or, the second time, of what is seen of them.
    HWY_NOINLINE void find_depths(const FragmentChunk& c, bool is_first, float* depths) const
    {
        alignas(64) float through[kChunk + kAround];
        if (!is_first) find_transmittances(c, through);
        for (std::size_t i = 0; i < c.some; i += Block::kCount) {
            Real seen = Real::load(c.opacity() + i);
            if (!is_first) seen = seen * Real::load(through + i);
            Text::optical_depth(seen).store(depths + i);
        }
    }

    // `depths` become those of the parts.
    HWY_NOINLINE void add_depths(const FragmentChunk& c, float* depths)
    {
        for (std::size_t i = 0; c.parts != nullptr && i < c.some; i += Block::kCount) {
            (Real::load(depths + i) * Real::load(c.parts + i)).store(depths + i);
        }
        function_->add_to_pixels(c.places, depths, c.some, c.pixel(), sums_.data(), stride_);
    }

    // Red, green, blue and weight.
    HWY_NOINLINE void add_colors(const FragmentChunk& c, const ExactGrid& colors)
    {
        const ExactGrid weights(-kColorBits);
        const FragmentStream& f = c.stream;
        alignas(64) float values[4][Block::kCount];
        alignas(64) float through[kChunk + kAround];
        alignas(64) std::int64_t units[4 * kChunk];
        find_transmittances(c, through);
        for (std::size_t i = 0; i < c.some; i += Block::kCount) {
            Real weight = Text::visible_alpha(Real::load(through + i), Real::load(c.opacity() + i));
            if (c.parts != nullptr) weight = weight * Real::load(c.parts + i);
            (weight * Real::load(f.red.data() + c.first + i)).store(values[0]);
            (weight * Real::load(f.green.data() + c.first + i)).store(values[1]);
            (weight * Real::load(f.blue.data() + c.first + i)).store(values[2]);
            weight.store(values[3]);
            for (std::size_t j = 0; j < Block::kCount; j += Wide::kCount) {
                typename Wide::whole four[4];
                for (std::size_t k = 0; k < 4; ++k) {
                    four[k] = exact_units<Wide>(Wide::real::load(values[k] + j),
                                                k < 3 ? colors : weights);
                }
                Wide::whole::store_in_turns(four, units + 4 * (i + j));
            }
        }
        for (std::size_t i = 0; i < c.some; ++i) {
            add_four(units + 4 * i, sums_.data() + c.pixel()[i] * stride_);
        }
    }

    // Makes of the sums what is kept, in pixels that `touched` names, and of the sums 0. The first
    // ones are copied to `depths`, where that is not null.
    HWY_NOINLINE void prepare(const char* touched, bool is_first, std::int64_t* depths)
    {
        for (std::size_t pixel = 0; pixel < kTilePixels; pixel += kPrepared) {
            if (!any_of(touched + pixel)) continue;
            alignas(64) PreparedSums sums;
            read_sums(pixel, sums);
            for (std::size_t i = 0; i < kPrepared; ++i) {
                std::int64_t* at = sums_.data() + (pixel + i) * stride_;
                if (depths != nullptr) depths[pixel + i] = at[0];
                std::fill_n(at, stride_, std::int64_t{0});
            }
            keep(pixel, sums, is_first);
        }
    }

    float transmittance_at(std::size_t pixel, float place) const
    {
        const std::uint32_t pixels[kAround] = {static_cast<std::uint32_t>(pixel)};
        const float places[kAround] = {place};
        alignas(64) float values[kAround];
        function_->find_transmittances(kept(), pixels, places, 1, values);
        return values[0];
    }

protected:
    static bool any_of(const char* touched)
    {
        return std::any_of(touched, touched + kPrepared, [](char t) { return t != 0; });
    }

    // Of pixels `pixel`, `pixel` + 1, ...
    void read_sums(std::size_t pixel, PreparedSums& sums) const
    {
        const ExactGrid grid(-kDepthBits);
        for (std::size_t k = 0; k < counts().sums; ++k) {
            alignas(64) std::int64_t units[kPrepared];
            for (std::size_t i = 0; i < kPrepared; ++i) units[i] = this->sums(pixel + i)[k];
            for (std::size_t i = 0; i < kPrepared; i += Wide::kCount) {
                exact_sum<Wide>(units + i, grid).store(&sums[k][i]);
            }
        }
    }
    void keep(std::size_t pixel, const PreparedSums& sums, bool is_first)
    {
        function_->prepare(sums, kept_.data() + pixel, kTilePixels, is_first);
    }
    const DepthFunction& function() const { return *function_; }

    // A place in each of pixels `pixel`, ..., kPrepared of them.
    void find_transmittances(std::size_t pixel, const float* places, float* values) const
    {
        alignas(64) std::uint32_t pixels[kPrepared + kAround] = {};
        for (std::size_t i = 0; i < kPrepared; ++i) {
            pixels[i] = static_cast<std::uint32_t>(pixel + i);
        }
        function_->find_transmittances(kept(), pixels, places, kPrepared, values);
    }

private:
    static_assert(kTilePixels == 1 << 10);
    KeptNumbers kept() const { return {kept_.data(), 1, 10, 1}; }

    void find_transmittances(const FragmentChunk& c, float* values) const
    {
        function_->find_transmittances(kept(), c.pixel(), c.places, c.some, values);
    }

    std::unique_ptr<DepthFunction> function_;
    std::size_t stride_;
    AlignedArray<std::int64_t> sums_;
    AlignedArray<float> kept_;
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_PIXEL_FUNCTIONS_INL_H
