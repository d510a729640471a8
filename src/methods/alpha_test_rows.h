// The rows of methods that leave of each fragment something opaque or nothing.
#pragma once

#include "methods/method.h"

namespace sheer {

MethodRow alpha_test_row();
MethodRow alpha_test_then_blend_row();
MethodRow stochastic_alpha_test_row();
MethodRow hashed_alpha_test_row();
MethodRow alpha_to_coverage_row();
MethodRow hashed_alpha_to_coverage_row();
MethodRow screen_door_row();

}  // namespace sheer
