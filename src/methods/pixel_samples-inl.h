// What each sample has of its own where a method that approximates transmittance
// (shaders/sheer/transmittance.glsl) has one function for each pixel of a tile
// (pixel_functions-inl.h).
//
// Where pixels have several samples, a fragment's optical depth counts in proportion to those that
// it covers, so that the triangles of a surface make no seams; what all let through is exact at
// each sample, and colours are divided by their weights after the filter. A sample takes 8 bytes
// for what all let through and 20 for what is opaque.
#if defined(SHEER_PIXEL_SAMPLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_PIXEL_SAMPLES_INL_H
#undef SHEER_PIXEL_SAMPLES_INL_H
#else
#define SHEER_PIXEL_SAMPLES_INL_H
#endif

#include "methods/pixel_functions-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

class PixelSamples {
public:
    virtual ~PixelSamples() = default;

    // As in TranslucentFragments.
    virtual void clear() = 0;
    virtual void look(const FragmentStream& f) = 0;
    virtual void see(const FragmentStream& f) = 0;
    virtual float place(float depth) const = 0;
    virtual const char* touched() const = 0;
    virtual ExactGrid color_grid() const = 0;

    virtual void merge(const PixelSamples& other) = 0;
    // Of each sample what all let through, as optical depth.
    virtual std::int64_t* depths() = 0;
    // Fragments first, first + 1, ... with the part of its pixel's samples at which each counts.
    virtual FragmentChunk chunk(const FragmentStream& f, std::size_t first, std::size_t some) = 0;
    virtual void add_depths(const FragmentChunk& c, const float* depths) = 0;
    // With the sums of colours and their weight.
    virtual void resolve(SampleColors& backdrop, const PixelFunctions& functions) const = 0;
    virtual float mean_shown(float light, std::size_t pixel, float depth) = 0;
};

// Of pixel_samples.cpp.
std::unique_ptr<PixelSamples> make_pixel_samples(const StoreShape& shape);

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_PIXEL_SAMPLES_INL_H
