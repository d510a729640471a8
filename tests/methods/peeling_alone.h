// The texts of peeling, for texts_alone.h, which has the rest.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "methods/layered_alone.h"

namespace sheer::test {

// Until a pass finds nothing.
template <class L>
struct DepthPeelingAlone : LayersAlone<L> {
    using T = Texts<L>;
    using Store = typename T::DepthPeel;
    static constexpr int kPasses = 4096;
    const int peels = this->method.number("peels");
    mutable int begun = 0;

    Store clear() const
    {
        begun = 0;
        return T::depth_peeling_clear(this->beyond_any());
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        if (this->pass != begun) s = T::depth_peeling_begin(s, this->beyond_any());
        begun = this->pass;
        return T::depth_peeling_insert(s, this->layer(i, at));
    }
    bool done(const Store& s) const
    {
        return this->pass + 1 == peels || !(s.nearest.depth < this->beyond_any());
    }
    static auto all(const Store& s)
    {
        return T::depth_peeling_begin(s, DepthPeelingAlone::beyond_any()).front;
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::layer_resolve(all(s), behind);
    }
    static auto transmittance(const Store& s) { return DepthPeelingAlone::through(all(s)); }
    static auto keep(const Store& s)
    {
        return DepthPeelingAlone::kept(all(s).color, all(s).opacity, all(s).depth);
    }
};

template <class L>
struct DualPeelingAlone : LayersAlone<L> {
    using T = Texts<L>;
    using Store = typename T::DualPeel;
    static constexpr int kPasses = 4096;
    const int peels = this->method.number("peels");
    mutable int begun = 0;

    Store clear() const
    {
        begun = 0;
        return T::dual_peeling_clear(this->beyond_any());
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        if (this->pass != begun) s = T::dual_peeling_begin(s, this->beyond_any());
        begun = this->pass;
        return T::dual_peeling_insert(s, this->layer(i, at));
    }
    bool done(const Store& s) const
    {
        return this->pass + 1 == peels || !(s.nearest.depth < this->beyond_any());
    }
    static auto all(const Store& s)
    {
        const Store last = T::dual_peeling_begin(s, DualPeelingAlone::beyond_any());
        return T::layer_over(last.front, last.back);
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::layer_resolve(all(s), behind);
    }
    static auto transmittance(const Store& s) { return DualPeelingAlone::through(all(s)); }
    static auto keep(const Store& s)
    {
        return DualPeelingAlone::kept(all(s).color, all(s).opacity, all(s).depth);
    }
};

template <class L>
struct BucketPeelingAlone : LayersAlone<L> {
    using T = Texts<L>;
    static constexpr int kPasses = 4096 + 2;
    const bool adaptive = this->method.value("borders") == "adaptive";
    const int buckets = this->method.number("buckets");
    const int passes = this->method.traits().passes;
    struct Store {
        typename T::BucketRange range;
        std::vector<std::uint32_t> bins, before;
        std::vector<typename T::DepthPeel> peels;
        int begun;
    };

    int first_peel() const { return adaptive ? 2 : 1; }

    Store clear() const
    {
        return {T::bucket_range_clear(this->beyond_any()), std::vector<std::uint32_t>(32),
                std::vector<std::uint32_t>(33),
                std::vector(static_cast<std::size_t>(buckets),
                            T::depth_peeling_clear(this->beyond_any())),
                0};
    }
    Store insert(Store s, std::size_t i, std::size_t at) const
    {
        if (this->pass != s.begun) begin(s);
        const bool covered = this->lists.covers(i, at);
        const typename L::real depth(this->lists.depth_at(i, at));
        if (this->pass == 0) {
            s.range = T::bucket_range_insert(s.range, covered, depth);
            return s;
        }
        if (!adaptive) {
            peel(s, T::bucket_place(s.range, covered, depth, buckets), i, at);
            return s;
        }
        const std::uint32_t bin = T::bucket_place(s.range, covered, depth, 1024);
        const std::uint32_t word = T::bucket_word(bin);
        if (this->pass == 1) {
            s.bins[word] = T::bucket_mark(s.bins[word], covered, bin);
            return s;
        }
        const std::uint32_t rank = T::bucket_rank(s.before[word], s.bins[word], bin);
        peel(s, T::bucket_of_rank(rank, s.before[32], buckets), i, at);
        return s;
    }
    void begin(Store& s) const
    {
        s.begun = this->pass;
        if (this->pass == first_peel()) {
            for (std::size_t w = 0; w < 32; ++w) {
                s.before[w + 1] = s.before[w] + T::bit_count(s.bins[w]);
            }
        }
        if (this->pass <= first_peel()) return;
        for (auto& peel : s.peels) peel = T::depth_peeling_begin(peel, this->beyond_any());
    }
    void peel(Store& s, std::uint32_t bucket, std::size_t i, std::size_t at) const
    {
        s.peels[bucket] = T::depth_peeling_insert(s.peels[bucket], this->layer(i, at));
    }
    bool done(const Store& s) const
    {
        if (this->pass < first_peel()) return false;
        if (this->pass + 1 == passes) return true;
        return std::none_of(s.peels.begin(), s.peels.end(), [](const auto& peel) {
            return peel.nearest.depth < BucketPeelingAlone::beyond_any();
        });
    }
    static auto all(const Store& s)
    {
        auto sum = BucketPeelingAlone::nothing();
        for (const auto& peel : s.peels) {
            const auto last = T::depth_peeling_begin(peel, BucketPeelingAlone::beyond_any());
            sum = T::layer_over(sum, last.front);
        }
        return sum;
    }
    static auto resolve(const Store& s, typename T::real3 behind)
    {
        return T::layer_resolve(all(s), behind);
    }
    static auto transmittance(const Store& s) { return BucketPeelingAlone::through(all(s)); }
    static auto keep(const Store& s)
    {
        return BucketPeelingAlone::kept(all(s).color, s.range.nearest, s.range.farthest);
    }
};

}  // namespace sheer::test
