// Pieces of charts as SVG.
#pragma once

#include <string>

#include "support/text.h"

namespace sheer::svg {

// Told apart by people who see few colours: M. Okabe, K. Ito, "Color universal design", 2002.
// Black is the first.
inline constexpr const char* kColors[] = {"#000000", "#0072B2", "#D55E00", "#009E73",
                                          "#CC79A7", "#E69F00", "#56B4E9"};

struct Point {
    double x, y;
};

inline std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        if (c == '&') {
            result += "&amp;";
        } else if (c == '<') {
            result += "&lt;";
        } else {
            result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
        }
    }
    return result;
}

// `more`: further attributes, after a space.
inline std::string text_at(Point at, const std::string& text, const std::string& more = "")
{
    return "<text x=\"" + fixed(at.x, 1) + "\" y=\"" + fixed(at.y, 1) + "\"" + more + ">" +
           escaped(text) + "</text>\n";
}

inline std::string line_between(Point a, Point b, const std::string& style)
{
    return "<line x1=\"" + fixed(a.x, 1) + "\" y1=\"" + fixed(a.y, 1) + "\" x2=\"" + fixed(b.x, 1) +
           "\" y2=\"" + fixed(b.y, 1) + "\" " + style + "/>\n";
}

}  // namespace sheer::svg
