// The filters of EXT_meshopt_compression, in place: what stands in the bytes becomes what the
// accessors of them expect. All bytes are little-endian, and whole elements.
#pragma once

#include <cstdint>
#include <span>

namespace sheer::gltf {

// Elements of four signed integers, of 8 bits each where the stride is 4 and of 16 where it is 8:
// two octahedral coordinates and what stands for 1 become a normalized unit vector. The fourth
// stays.
void decode_octahedral(std::span<std::uint8_t> bytes, std::size_t stride);

// Four 16-bit integers each: three components and the place of the fourth become a normalized unit
// quaternion.
void decode_quaternions(std::span<std::uint8_t> bytes);

// 32 bits each: an exponent and a signed mantissa become a float.
void decode_exponential(std::span<std::uint8_t> bytes);

}  // namespace sheer::gltf
