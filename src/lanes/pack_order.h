// For each set of up to eight lanes, their numbers one after the other (the rest 0).
#pragma once

#include <array>
#include <cstdint>

namespace sheer {

constexpr std::array<std::array<std::uint8_t, 8>, 256> make_pack_order()
{
    std::array<std::array<std::uint8_t, 8>, 256> order = {};
    for (unsigned bits = 0; bits < 256; ++bits) {
        std::size_t next = 0;
        for (unsigned lane = 0; lane < 8; ++lane) {
            if ((bits >> lane & 1) != 0) order[bits][next++] = static_cast<std::uint8_t>(lane);
        }
    }
    return order;
}

alignas(64) inline constexpr auto kPackOrder = make_pack_order();

}  // namespace sheer
