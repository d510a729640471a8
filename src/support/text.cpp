// Numbers as text.
#include "support/text.h"

#include <cmath>
#include <cstdio>

namespace sheer {

std::string fixed(double number, int digits)
{
    if (!std::isfinite(number)) return "-";
    char text[64];
    const int length = std::snprintf(text, sizeof text, "%.*f", digits, number);
    if (length <= 0 || length >= static_cast<int>(sizeof text)) return "-";
    // No "-0.00".
    const bool is_zero = std::string_view(text).find_first_not_of("-0.") == std::string_view::npos;
    return is_zero && text[0] == '-' ? text + 1 : text;
}

}  // namespace sheer
