// What must be defined where a text of shaders/sheer/ is included (lanes/text_words.h).
#pragma once

#include "lanes/targets.h"

#include <hwy/highway.h>

#define SHEER_INLINE HWY_ATTR HWY_INLINE
#define SHEER_FN static HWY_ATTR HWY_INLINE
#define SHEER_INOUT(type) type&
