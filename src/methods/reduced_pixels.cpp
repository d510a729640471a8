// A method that approximates transmittance with functions of a picture of fewer pixels: how that is
// added up, and how the pixels of the whole picture read it (shaders/sheer/reduced_moments.glsl).
// pixel_functions-inl.h says what is added up.
#include "methods/method.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/reduced_pixels.cpp"
#include "lanes/targets.h"

#include <bit>

#include <hwy/foreach_target.h>

#include "lanes/lone.h"
#include "methods/pixel_samples-inl.h"
#include "methods/reduced_moments.h"
#include "methods/transmittance_stores-inl.h"

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
class ReducedTile : public PixelFunctions {
    using Wide = WideLanes<kPrepared>;

public:
    ReducedTile(const StoreShape& shape, OwnFunction function)
        : PixelFunctions(std::move(function)),
          set_(*shape.samples),
          range_(depth_range(shape)),
          places_(shape.stream_capacity + FragmentStream::kSlack),
          kept_(kTilePixels * counts().sums * static_cast<std::size_t>(passes()))
    {
        std::fill_n(touched_, kTilePixels, static_cast<char>(1));
    }

    void clear()
    {
        PixelFunctions::clear();
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
        for (; pass_ < passes(); ++pass_) finish_pass();
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
        find_depths(chunk, pass_ == 0, depths);
        add_depths(chunk, depths);
    }

    void finish_pass()
    {
        const std::size_t numbers = counts().sums;
        double* to = kept_.data() + static_cast<std::size_t>(pass_) * numbers * kTilePixels;
        for (std::size_t pixel = 0; pixel < kTilePixels; pixel += kPrepared) {
            alignas(64) PreparedSums sums;
            read_sums(pixel, sums);
            function().round_texels(sums);
            for (std::size_t k = 0; k < numbers; ++k) {
                std::copy_n(sums[k], kPrepared, to + k * kTilePixels + pixel);
            }
        }
        if (pass_ + 1 < passes()) prepare(touched_, pass_ == 0, nullptr);
    }

    const SampleSet& set_;
    DepthRange range_;
    int pass_ = 0;
    AlignedArray<float> places_;
    AlignedArray<double> kept_;  // of each pass and number, a tile's pixels
    char touched_[kTilePixels];
};

// Makes of what the reduced picture has around a tile's pixels what is kept for each of these.
class ReducedFunctions : public PixelFunctions {
    using Wide = WideLanes<kPrepared>;
    using Text = ReducedText<Wide>;
    using Real = typename Wide::real;

public:
    ReducedFunctions(const StoreShape& shape, OwnFunction function)
        : PixelFunctions(std::move(function)),
          reduced_(shape.reduced),
          rows_(counts().sums * static_cast<std::size_t>(passes()) * kTileSize)
    {
    }

    // `own`: of each pixel the sums of d_i and d_i z_i, or null.
    void read(const TilePlace& place, const char* touched, const std::int64_t* own)
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
            for (std::size_t x = 0; x < kTileSize; x += kPrepared) {
                if (any_of(touched + first + x)) keep_pixels(first, x, own);
            }
        }
    }

private:
    // Of a row of the tile, each number of its pixels.
    void mix_rows(const TilePlace& place, int y)
    {
        if (reduced_ == nullptr) {
            std::fill_n(rows_.data(), rows_.size(), 0.0);
            return;
        }
        using One = ReducedText<Lone<double>>;
        const ReducedMoments& r = *reduced_;
        const TexelPair rows(place.y + y, r.picture_height, r.height);
        for (std::size_t k = 0; k < static_cast<std::size_t>(r.numbers); ++k) {
            const double *above = r.row(rows.first, k), *below = r.row(rows.second, k);
            for (int x = 0; x < kTileSize; ++x) {
                const TexelPair& columns = columns_[x];
                number(k)[x] = One::reduced_mix(
                    One::reduced_mix(above[columns.first], below[columns.first], rows.part),
                    One::reduced_mix(above[columns.second], below[columns.second], rows.part),
                    columns.part);
            }
        }
    }

    // Of kPrepared pixels, all that is kept.
    void keep_pixels(std::size_t row, std::size_t x, const std::int64_t* own)
    {
        const std::size_t pixel = row + x;
        Missing missing;
        find_missing(pixel, x, own, missing);
        for (int pass = 0; pass < passes(); ++pass) {
            // The second time of what is seen of it.
            if (pass > 0 && own != nullptr) see(pixel, missing);
            alignas(64) PreparedSums sums;
            const std::size_t first = static_cast<std::size_t>(pass) * counts().sums;
            for (std::size_t i = 0; i < kPrepared; i += Wide::kCount) {
                const Real keeps = Real::load(missing.keeps + i);
                const Real place = Real::load(missing.place + i);
                Real power = Real::load(missing.depth + i);
                for (std::size_t k = 0; k < counts().sums; ++k) {
                    (keeps * Real::load(number(first + k) + x + i) + power).store(&sums[k][i]);
                    power = power * place;
                }
            }
            keep(pixel, sums, pass == 0);
        }
    }

    // The fragments that no texel has seen.
    struct Missing {
        alignas(64) double keeps[kPrepared], depth[kPrepared], place[kPrepared];
    };
    void find_missing(std::size_t pixel, std::size_t x, const std::int64_t* own, Missing& to)
    {
        const ExactGrid grid(-kDepthBits);
        for (std::size_t i = 0; i < kPrepared; i += Wide::kCount) {
            typename Text::MissingFragment missing{Real(1.0), Real(0.0), Real(0.0)};
            if (own != nullptr) {
                const std::int64_t* at = own + pixel + i;
                missing = Text::missing_fragment(
                    Real::load(number(0) + x + i), Real::load(number(1) + x + i),
                    exact_sum<Wide>(at, grid), exact_sum<Wide>(at + kTilePixels, grid));
            }
            missing.keeps.store(to.keeps + i);
            missing.depth.store(to.depth + i);
            missing.place.store(to.place + i);
        }
    }
    // Their optical depths become those that are seen.
    void see(std::size_t pixel, Missing& missing) const
    {
        using L = Lanes<kPrepared>;
        using Alike = TransmittanceText<L>;
        alignas(64) float places[kPrepared + L::kCount], depths[kPrepared];
        alignas(64) float through[kPrepared + 16];
        for (std::size_t i = 0; i < kPrepared; i += Wide::kCount) {
            Real::load(missing.place + i).store(places + i);
            Real::load(missing.depth + i).store(depths + i);
        }
        find_transmittances(pixel, places, through);
        for (std::size_t i = 0; i < kPrepared; i += L::kCount) {
            const auto all = typename L::real(1.0f) -
                             Alike::exp_of(typename L::real(0.0f) - L::real::load(depths + i));
            const auto opacity = L::min(all, typename L::real(1 - 0x1p-24f));
            Alike::optical_depth(opacity * L::real::load(through + i)).store(depths + i);
        }
        std::copy_n(depths, kPrepared, missing.depth);
    }

    double* number(std::size_t k) { return rows_.data() + k * kTileSize; }

    const ReducedMoments* reduced_;
    TexelPair columns_[kTileSize];
    AlignedArray<double> rows_;  // of each pass and number, a row of the tile
};

class ReducedPixels final : public TransmittanceStore {
public:
    ReducedPixels(const StoreShape& shape, OwnFunction function)
        : functions_(shape, std::move(function)),
          samples_(make_pixel_samples(shape)),
          last_(shape.method->traits().passes - 1),
          own_(last_ > 1 ? 2 * kTilePixels : 0)
    {
    }

    void clear(const TilePlace& place) override
    {
        place_ = place;
        samples_->clear();
        functions_.clear();
        std::fill_n(own_.data(), own_.size(), std::int64_t{0});
        has_read_ = false;
    }

    void insert(const FragmentStream& f, int pass) override
    {
        if (pass == 0) return samples_->look(f);
        samples_->see(f);
        const auto size = static_cast<std::size_t>(f.size);
        if (pass == last_) read();
        for (std::size_t first = 0; first < size; first += kChunk) {
            const std::size_t some = std::min(kChunk, size - first);
            const FragmentChunk chunk = samples_->chunk(f, first, some);
            if (pass == 1) add_depths(chunk);
            if (pass == last_) functions_.add_colors(chunk, samples_->color_grid());
        }
    }

    void merge(const TransmittanceStore& other) override
    {
        const auto& same = static_cast<const ReducedPixels&>(other);
        samples_->merge(*same.samples_);
        functions_.merge(same.functions_);
        add_all(same.own_, own_);
    }

    void resolve(SampleColors& backdrop) override { samples_->resolve(backdrop, functions_); }

private:
    void read()
    {
        if (has_read_) return;
        has_read_ = true;
        functions_.read(place_, samples_->touched(), own_.size() > 0 ? own_.data() : nullptr);
    }

    void add_depths(const FragmentChunk& chunk)
    {
        alignas(64) float depths[kChunk];
        functions_.find_depths(chunk, true, depths);
        samples_->add_depths(chunk, depths);
        if (own_.size() > 0) add_own(chunk, depths);
    }

    void add_own(const FragmentChunk& c, const float* depths)
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

    ReducedFunctions functions_;
    std::unique_ptr<PixelSamples> samples_;
    int last_;
    TilePlace place_;
    bool has_read_ = false;
    AlignedArray<std::int64_t> own_;
};

OwnStore make_reduced_pixels(const StoreShape& shape, OwnFunction function)
{
    return std::make_unique<ReducedPixels>(shape, std::move(function));
}

ReducedVerbs reduced_tile_verbs()
{
    using Tile = ReducedTile;
    ReducedVerbs verbs;
    verbs.clear = [](void* tile) { static_cast<Tile*>(tile)->clear(); };
    verbs.insert = [](void* tile, const FragmentStream& stream, const float* farthest, int pass) {
        static_cast<Tile*>(tile)->insert(stream, farthest, pass);
    };
    verbs.write = [](void* tile, const PixelRect& rect, ReducedMoments& to) {
        static_cast<Tile*>(tile)->write(rect, to);
    };
    return verbs;
}
std::shared_ptr<void> make_reduced_tile(const StoreShape& shape, OwnFunction function)
{
    return std::make_shared<ReducedTile>(shape, std::move(function));
}

}  // namespace sheer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
