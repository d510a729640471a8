// A method that approximates transmittance with functions of a picture of fewer pixels: how that is
// added up, and how the pixels of the whole picture read it (shaders/sheer/reduced_moments.glsl).
// pixel_functions-inl.h says what is added up.
#if defined(SHEER_REDUCED_PIXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SHEER_REDUCED_PIXELS_INL_H
#undef SHEER_REDUCED_PIXELS_INL_H
#else
#define SHEER_REDUCED_PIXELS_INL_H
#endif

#include <bit>

#include "lanes/lone.h"
#include "methods/reduced_moments.h"
#include "methods/transmittance_pixels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sheer::HWY_NAMESPACE {

template <class L>
struct ReducedText {
#include "lanes/text_words.h"
#include "sheer/reduced_moments.glsl"
};

// A tile of the reduced picture. Fragments count in proportion to the samples that they cover.
//
// The farthest opaque depth of what a texel shows hides what is behind it, as nothing nearer hides
// it in all of its pixels. Fragments with opacity 1 are left out: they hide the same in their own
// pixels alone.
template <class Function>
class ReducedTile : public PixelFunctions<Function> {
    using Base = PixelFunctions<Function>;
    using Wide = WideLanes<8>;
    static constexpr std::size_t kNumbers = Function::kSums;

public:
    explicit ReducedTile(const StoreShape& shape)
        : Base(*shape.method),
          set_(*shape.samples),
          range_(depth_range(shape)),
          places_(shape.stream_capacity + FragmentStream::kSlack),
          kept_(kTilePixels * kNumbers * static_cast<std::size_t>(this->passes()))
    {
        std::fill_n(touched_, kTilePixels, static_cast<char>(1));
    }

    void clear()
    {
        Base::clear();
        pass_ = 0;
    }

    void insert(const FragmentStream& f, const float* farthest, int pass)
    {
        for (; pass_ < pass; ++pass_) finish_pass();
        for (int r = 0; r < f.run_count; ++r) {
            const FragmentRun& run = f.runs[r];
            warp_depths(range_, f, run, places_.data());
            for (std::size_t i = 0; i < run.count; i += kChunk) {
                add(f, run, run.first + i, std::min(kChunk, run.count - i), farthest);
            }
        }
    }

    void write(const PixelRect& rect, ReducedMoments& to)
    {
        for (; pass_ < this->passes(); ++pass_) finish_pass();
        const auto count = static_cast<std::size_t>(rect.x1 - rect.x0);
        for (int y = rect.y0; y < rect.y1; ++y) {
            const auto first = static_cast<std::size_t>((y - rect.y0) * kTileSize);
            for (std::size_t k = 0; k < static_cast<std::size_t>(to.numbers); ++k) {
                std::copy_n(kept_.data() + k * kTilePixels + first, count, to.row(y, k) + rect.x0);
            }
        }
    }

private:
    // Of one run, each in a pixel of its own.
    void add(const FragmentStream& f, const FragmentRun& run, std::size_t first, std::size_t some,
             const float* farthest)
    {
        alignas(64) float parts[kChunk], depths[kChunk];
        const float part = 1.0f / static_cast<float>(set_.count);
        for (std::size_t i = 0; i < some; ++i) {
            const std::size_t at = first + i;
            const float depth = std::clamp(f.depth[at], run.depth.least, run.depth.most);
            const bool seen = f.opacity[at] < 1 && !(depth > farthest[f.pixel[at]]);
            const int samples = std::popcount(f.sample_bits(at) & set_.all());
            parts[i] = seen ? static_cast<float>(samples) * part : 0.0f;
        }
        const FragmentChunk chunk{f, first, some, places_.data() + first, parts};
        this->find_depths(chunk, pass_ == 0, depths);
        this->add_depths(chunk, depths);
    }

    void finish_pass()
    {
        const ExactGrid grid(-kDepthBits);
        double* to = kept_.data() + static_cast<std::size_t>(pass_) * kNumbers * kTilePixels;
        for (std::size_t pixel = 0; pixel < kTilePixels; pixel += Wide::kCount) {
            typename Wide::real sums[kNumbers];
            for (std::size_t k = 0; k < kNumbers; ++k) {
                alignas(64) std::int64_t units[Wide::kCount];
                for (std::size_t i = 0; i < Wide::kCount; ++i) units[i] = this->sums(pixel + i)[k];
                sums[k] = exact_sum<Wide>(units, grid);
            }
            this->function_.template round_texels<Wide>(sums);
            for (std::size_t k = 0; k < kNumbers; ++k) sums[k].store(to + k * kTilePixels + pixel);
        }
        if (pass_ + 1 < this->passes()) this->prepare(touched_, pass_ == 0, nullptr);
    }

    const SampleSet& set_;
    DepthRange range_;
    int pass_ = 0;
    AlignedArray<float> places_;
    AlignedArray<double> kept_;  // of each pass and number, a tile's pixels
    char touched_[kTilePixels];
};

template <class Function>
ReducedVerbs reduced_verbs_of()
{
    using Tile = ReducedTile<Function>;
    ReducedVerbs verbs;
    verbs.make = [](const StoreShape& shape) -> std::shared_ptr<void> {
        return std::make_shared<Tile>(shape);
    };
    verbs.clear = [](void* tile) { static_cast<Tile*>(tile)->clear(); };
    verbs.insert = [](void* tile, const FragmentStream& stream, const float* farthest, int pass) {
        static_cast<Tile*>(tile)->insert(stream, farthest, pass);
    };
    verbs.write = [](void* tile, const PixelRect& rect, ReducedMoments& to) {
        static_cast<Tile*>(tile)->write(rect, to);
    };
    return verbs;
}

// Makes of what the reduced picture has around a tile's pixels what is kept for each of these.
template <class Function>
class ReducedFunctions : public PixelFunctions<Function> {
    using Base = PixelFunctions<Function>;
    using Wide = WideLanes<8>;
    using Text = ReducedText<Wide>;
    using Real = typename Wide::real;
    static constexpr std::size_t kNumbers = Function::kSums;

public:
    explicit ReducedFunctions(const StoreShape& shape)
        : Base(*shape.method), reduced_(shape.reduced)
    {
    }

    // `own`: of each pixel the sums of d_i and d_i z_i, or null.
    HWY_NOINLINE void read(const TilePlace& place, const char* touched, const std::int64_t* own)
    {
        for (int x = 0; reduced_ != nullptr && x < kTileSize; ++x) {
            columns_[x] = TexelPair(place.x + x, reduced_->picture_width, reduced_->width);
        }
        for (int y = 0; y < kTileSize; ++y) {
            const auto first = static_cast<std::size_t>(y * kTileSize);
            if (std::all_of(touched + first, touched + first + kTileSize,
                            [](char t) { return t == 0; })) {
                continue;
            }
            mix_rows(place, y);
            for (std::size_t x = 0; x < kTileSize; x += Wide::kCount) {
                if (this->any_of(touched + first + x)) keep_pixels(first, x, own);
            }
        }
    }

private:
    static constexpr std::size_t kMostNumbers = 2 * kNumbers;

    // Of a row of the tile, each number of its pixels.
    void mix_rows(const TilePlace& place, int y)
    {
        if (reduced_ == nullptr) {
            for (auto& row : rows_) std::fill_n(row, kTileSize, 0.0);
            return;
        }
        using One = ReducedText<Lone<double>>;
        const ReducedMoments& r = *reduced_;
        const TexelPair rows(place.y + y, r.picture_height, r.height);
        for (std::size_t k = 0; k < static_cast<std::size_t>(r.numbers); ++k) {
            const double *above = r.row(rows.first, k), *below = r.row(rows.second, k);
            for (int x = 0; x < kTileSize; ++x) {
                const TexelPair& columns = columns_[x];
                rows_[k][x] = One::reduced_mix(
                    One::reduced_mix(above[columns.first], below[columns.first], rows.part),
                    One::reduced_mix(above[columns.second], below[columns.second], rows.part),
                    columns.part);
            }
        }
    }

    HWY_INLINE void keep_pixels(std::size_t row, std::size_t x, const std::int64_t* own)
    {
        typename Text::MissingFragment missing{Real(1.0), Real(0.0), Real(0.0)};
        if (own != nullptr) {
            const ExactGrid grid(-kDepthBits);
            missing = Text::missing_fragment(Real::load(&rows_[0][x]), Real::load(&rows_[1][x]),
                                             exact_sum<Wide>(own + row + x, grid),
                                             exact_sum<Wide>(own + kTilePixels + row + x, grid));
        }
        for (int pass = 0; pass < this->passes(); ++pass) {
            // The second time of what is seen of it.
            const Real depth = pass == 0 || own == nullptr
                                   ? missing.depth
                                   : this->seen_depth(row + x, missing.place, missing.depth);
            Real sums[kNumbers], power = depth;
            const std::size_t first = static_cast<std::size_t>(pass) * kNumbers;
            for (std::size_t k = 0; k < kNumbers; ++k) {
                sums[k] = missing.keeps * Real::load(&rows_[first + k][x]) + power;
                power = power * missing.place;
            }
            this->keep(row + x, sums, pass == 0);
        }
    }

    const ReducedMoments* reduced_;
    TexelPair columns_[kTileSize];
    alignas(64) double rows_[kMostNumbers][kTileSize] = {};
};

template <int S, class Function>
class ReducedPixels {
public:
    explicit ReducedPixels(const StoreShape& shape)
        : functions_(shape),
          samples_(shape),
          last_(shape.method->traits().passes - 1),
          own_(last_ > 1 ? 2 * kTilePixels : 0)
    {
    }

    void clear(const TilePlace& place)
    {
        place_ = place;
        samples_.clear();
        functions_.clear();
        std::fill_n(own_.data(), own_.size(), std::int64_t{0});
        has_read_ = false;
    }

    void insert(const FragmentStream& f, int pass)
    {
        if (pass == 0) return samples_.fragments.look(f);
        samples_.fragments.see(f);
        const auto size = static_cast<std::size_t>(f.size);
        if (pass == last_) read();
        for (std::size_t first = 0; first < size; first += kChunk) {
            const std::size_t some = std::min(kChunk, size - first);
            const FragmentChunk chunk{f, first, some, samples_.fragments.places() + first,
                                      samples_.parts(f, first, some)};
            if (pass == 1) add_depths(chunk);
            if (pass == last_) functions_.add_colors(chunk, samples_.fragments.color_grid());
        }
    }

    // After the same pass, or before any of the other's.
    void merge(const ReducedPixels& other)
    {
        samples_.merge(other.samples_);
        functions_.merge(other.functions_);
        add_all(other.own_, own_);
    }

    void resolve(SampleColors& backdrop)
    {
        samples_.resolve(backdrop, [&](std::size_t pixel) { return functions_.sums(pixel); });
    }

private:
    void read()
    {
        if (has_read_) return;
        has_read_ = true;
        functions_.read(place_, samples_.fragments.touched(),
                        own_.size() > 0 ? own_.data() : nullptr);
    }

    void add_depths(const FragmentChunk& chunk)
    {
        alignas(64) float depths[kChunk];
        functions_.find_depths(chunk, true, depths);
        samples_.add_depths(chunk, depths);
        if (own_.size() > 0) add_own(chunk, depths);
    }

    HWY_NOINLINE void add_own(const FragmentChunk& c, const float* depths)
    {
        using Wide = WideLanes<8>;
        using Real = typename Wide::real;
        const ExactGrid grid(-kDepthBits);
        alignas(64) std::int64_t units[2][Wide::kCount];
        for (std::size_t i = 0; i < c.some; i += Wide::kCount) {
            Real depth = Real::load(depths + i);
            if (c.parts != nullptr) depth = depth * Real::load(c.parts + i);
            exact_units<Wide>(depth, grid).store(units[0]);
            exact_units<Wide>(depth * Real::load(c.places + i), grid).store(units[1]);
            for (std::size_t j = 0; j < Wide::kCount && i + j < c.some; ++j) {
                for (std::size_t k = 0; k < 2; ++k) {
                    std::int64_t& sum = own_[k * kTilePixels + c.pixel()[i + j]];
                    sum = add_wrapping(sum, units[k][j]);
                }
            }
        }
    }

    ReducedFunctions<Function> functions_;
    PixelSamples<S> samples_;
    int last_;
    TilePlace place_;
    bool has_read_ = false;
    AlignedArray<std::int64_t> own_;
};

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHEER_REDUCED_PIXELS_INL_H
