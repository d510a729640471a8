#include "methods/mask_table.h"

#include <map>
#include <mutex>

#include "lanes/lone.h"

namespace sheer {

namespace {

struct Text {
    using L = Lone<float>;
#include "lanes/text_words.h"
#include "sheer/random.glsl"
#include "sheer/stochastic_masks.glsl"
};

std::shared_ptr<const MaskTable> make_table(int samples)
{
    constexpr std::uint32_t kColumns = kMaskColumns, kRows = kMaskRows;
    auto table = std::make_shared<MaskTable>();
    table->low.reserve(kColumns * kRows);
    if (samples > 32) table->high.reserve(kColumns * kRows);
    for (std::uint32_t row = 0; row < kRows; ++row) {
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const Text::SampleBits bits = Text::mask_of_table(row, column, samples);
            table->low.push_back(bits.low);
            if (samples > 32) table->high.push_back(bits.high);
        }
    }
    return table;
}

}  // namespace

std::shared_ptr<const MaskTable> mask_table(int samples)
{
    static std::mutex mutex;
    static std::map<int, std::weak_ptr<const MaskTable>> tables;
    static std::shared_ptr<const MaskTable> latest;
    const std::lock_guard lock(mutex);
    std::shared_ptr<const MaskTable> table = tables[samples].lock();
    if (!table) tables[samples] = table = make_table(samples);
    latest = table;
    return table;
}

}  // namespace sheer
