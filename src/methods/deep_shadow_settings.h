// The parameters of deep-shadow-map, and a curve's vertex in memory.
#pragma once

#include <charconv>
#include <string>

#include "methods/method.h"

namespace sheer {

struct DeepShadowSettings {
    float error;    // of a curve, at most
    bool corrects;  // the sum is made to add up to what is covered
};

inline DeepShadowSettings deep_shadow_settings(const ChosenMethod& method)
{
    const std::string& text = method.value("error");
    float error = 0;
    std::from_chars(text.data(), text.data() + text.size(), error);
    return {error, method.value("correction") == "on"};
}

struct CurveVertex {
    float z, v;
};

}  // namespace sheer
