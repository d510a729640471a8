// Brings a tile's fragments to stores, as often as they need them.
//
// A store that sees them once takes them as they come, in streams of the second-level cache's size.
// Where they are needed more than once, by several passes, takes or keys, the tile's stream is kept
// and gone through again; a tile whose stream would be too large is rasterised again instead. A
// store that grows beyond what it may take has its tile split into halves that are done one after
// the other.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "cpu/frame.h"
#include "cpu/stopwatch.h"
#include "cpu/tile_fragments.h"
#include "methods/method.h"

namespace sheer {

// The stream and the store of a tile share the second-level cache: about 150 KB of fragments.
inline constexpr int kStreamFragments = 4096;
// For more than one pass, all of a tile's: 55 MB at most. That they leave the cache costs a tenth
// of what rasterising them again does. A head of hair has 360,000 in its fullest tiles
// (docs/performance.md).
inline constexpr int kKeptFragments = 524288;

// A store and what it is fed.
struct TileStore {
    const StoreVerbs* verbs;
    std::shared_ptr<void> store;
    bool divides;                                 // MethodTraits::divides
    std::vector<Stopwatch> storing;               // of each pass; clearing is the first's
    std::uint64_t fragments = 0;                  // of all pictures drawn with it
    Stopwatch raster_shade = {}, resolving = {};  // the first: for this store alone
};

// What is behind the tile's transparent fragments, and how they are rasterised.
struct TileSetting {
    TileJob job;  // its region is the whole tile
    Float4 background;
    TilePlace place;
};

class TilePasses {
public:
    TilePasses(TileFragmentsFunction fragments, OpaqueTile opaque, FragmentStream stream);

    // Rasterises the tile for stores that want fragments in the same order, and keeps the stream if
    // it is not too long. Not needed before `draw`.
    void keep(const TileSetting& setting);
    void forget() { kept_ = false; }

    // From here on only fragments of some pixels, of kTilePixels, go to stores: those where
    // `chosen` is not 0. Fewer each time; null: all, once what was kept is forgotten.
    void restrict_to(const std::vector<char>* chosen);

    // One picture of the tile: `colors` are what the store makes of its fragments over what is
    // behind them. Throws Error(Fault::work) when the store can't hold one pixel's.
    void draw(const TileSetting& setting, TileStore& store, SampleColors& colors);

    // All fragments in order, as for a single pass.
    template <class Consume>
    void visit(const TileSetting& setting, Consume&& consume)
    {
        rasterise(setting.job, nullptr, [&](const FragmentStream& stream) {
            consume(stream);
            return true;
        });
    }

    double ms_keeping(const FragmentWants& wants) const;

private:
    template <class Consume>
    bool rasterise(const TileJob& job, const float* hidden_behind, Consume&& consume);
    bool feed(const TileSetting& setting, const PixelRect& region, TileStore& store);
    void draw_region(const TileSetting& setting, const PixelRect& region, TileStore& store,
                     SampleColors& colors);
    void resolve(const TileSetting& setting, const PixelRect& region, TileStore& store,
                 SampleColors& colors);

    TileFragmentsFunction fragments_;
    TileScratch scratch_;
    OpaqueTile opaque_;
    FragmentStream stream_;
    bool kept_ = false;  // stream_ and opaque_ are the whole tile's
    const std::vector<char>* chosen_ = nullptr;
    std::vector<std::pair<FragmentWants, Stopwatch>> keeping_;
};

template <class Consume>
bool TilePasses::rasterise(const TileJob& job, const float* hidden_behind, Consume&& consume)
{
    const FragmentConsumer consumer{[](void* context, const FragmentStream& stream) {
                                        return (*static_cast<Consume*>(context))(stream);
                                    },
                                    &consume, hidden_behind};
    return fragments_(job, scratch_, opaque_, stream_, consumer) &&
           (stream_.size == 0 || consume(stream_));
}

}  // namespace sheer
