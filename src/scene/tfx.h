// Hair in TressFX 4 files (.tfx): strands of equally many vertices.
//
// Advanced Micro Devices. TressFX 4.1, TressFXAsset.h. 2019.
#pragma once

#include <string>

#include <sheer/scene.h>

#include "support/read_file.h"

namespace sheer {

// One mesh of lines. Such a file holds no width; strands are given a thousandth of the longest side
// of the box around them. Throws Error with Fault::input, "<path>: <what>".
Scene read_tfx(const std::string& path, const Bytes& content);

}  // namespace sheer
