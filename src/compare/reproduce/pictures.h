// Pictures of figures: several in a row.
#pragma once

#include <span>

#include <sheer/image.h>

namespace sheer {

// From left to right, white between them. They are of one height.
Image side_by_side(std::span<const Image> pictures);

}  // namespace sheer
