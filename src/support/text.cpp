// Numbers as text, and names that were meant.
#include "support/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace sheer {

namespace {

// Letters to insert, drop, replace or swap with the next that make b of a, none touched twice:
// Damerau. A Technique for Computer Detection and Correction of Spelling Errors. CACM 1964.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    using Row = std::vector<std::size_t>;
    Row before_last, last(b.size() + 1), row(b.size() + 1);
    for (std::size_t k = 0; k <= b.size(); ++k) row[k] = k;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last = std::exchange(last, row);
        row[0] = i;
        for (std::size_t k = 1; k <= b.size(); ++k) {
            const std::size_t wrong = a[i - 1] == b[k - 1] ? 0 : 1;
            row[k] = std::min({last[k] + 1, row[k - 1] + 1, last[k - 1] + wrong});
            if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1]) {
                row[k] = std::min(row[k], before_last[k - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

}  // namespace

std::string joined(std::span<const std::string> names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string suggestion(std::string_view typed, std::span<const std::string> names)
{
    constexpr std::size_t kLeastBeginning = 3;
    if (std::find(names.begin(), names.end(), typed) != names.end()) return "";
    const std::string* nearest = nullptr;
    std::size_t least = 0;
    for (const std::string& name : names) {
        const std::size_t most = std::max<std::size_t>(1, std::max(typed.size(), name.size()) / 3);
        const std::size_t distance = edit_distance(typed, name);
        const bool begins = typed.size() >= kLeastBeginning && name.starts_with(typed);
        if (typed.empty() || distance >= name.size() || (distance > most && !begins)) continue;
        if (nearest != nullptr && distance >= least) continue;
        nearest = &name;
        least = distance;
    }
    return nearest == nullptr ? "" : " (did you mean '" + *nearest + "'?)";
}

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

std::string in_one_line(std::string_view text, std::size_t max_length)
{
    std::size_t length = text.size();
    if (length > max_length) {
        length = max_length;
        // A UTF-8 character is not cut in two: its later bytes are 10xxxxxx.
        while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0u) == 0x80u) --length;
    }
    std::string line(text.substr(0, length));
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
    }
    return line;
}

}  // namespace sheer
