// Small things about text.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sheer {

// The parts between separators: one more than there are separators, empty ones included.
inline std::vector<std::string> split(std::string_view text, char separator)
{
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

// With that many digits after the point; "-" for what is not finite.
std::string fixed(double number, int digits);

// "blend, exact, wboit"
std::string joined(std::span<const std::string> names);

// " (did you mean 'exact'?)" of the name that is nearest to what was typed: the one with the fewest
// letters more, less, wrong or swapped with the next, a third of them at most, or one that begins
// like it. Empty where there is none such, or where it is one of them.
std::string suggestion(std::string_view typed, std::span<const std::string> names);

// `text` without control characters, which would break a message's one line, and of `max_length`
// bytes at most.
std::string in_one_line(std::string_view text, std::size_t max_length);

// "640x480"
inline std::string size_text(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace sheer
