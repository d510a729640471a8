// Numbers as people type them, read to their last character and refused where they do not fit.
#include "cli/values.h"

#include <cmath>

#include <sheer/image.h>

#include "support/text.h"

namespace sheer {

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& what)
{
    throw Error(Fault::input, option + ": '" + text + "' is not " + what);
}

// Between `least` and `most` numbers with commas between them.
std::vector<float> parse_floats(const std::string& option, const std::string& text,
                                std::pair<std::size_t, std::size_t> count, const std::string& what)
{
    const std::vector<std::string> parts = split(text, ',');
    if (parts.size() < count.first || parts.size() > count.second) refuse(option, text, what);
    std::vector<float> numbers;
    for (const std::string& part : parts) numbers.push_back(parse_float(option, part));
    return numbers;
}

}  // namespace

float parse_float(const std::string& option, const std::string& text)
{
    // As a double first: what underflows a float is a fine 0, what overflows it is refused below.
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const auto result = static_cast<float>(value);
    if (error != std::errc() || stop != end || !std::isfinite(result)) {
        refuse(option, text, "a finite number");
    }
    return result;
}

Float3 parse_point(const std::string& option, const std::string& text, const char* form)
{
    const auto n = parse_floats(option, text, {3, 3}, form);
    return {n[0], n[1], n[2]};
}

Float4 parse_background(const std::string& option, const std::string& text)
{
    const auto n = parse_floats(option, text, {3, 4}, "R,G,B or R,G,B,A");
    return {n[0], n[1], n[2], n.size() == 4 ? n[3] : 1.0f};
}

float parse_fov(const std::string& option, const std::string& text)
{
    const float degrees = parse_float(option, text);
    if (!(degrees > 0 && degrees < 180)) refuse(option, text, "between 0 and 180 degrees");
    return degrees;
}

Size parse_size(const std::string& option, const std::string& text)
{
    const auto side = [](std::string_view digits, int& pixels) {
        const char* const end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, pixels);
        return error == std::errc() && stop == end && pixels >= 1 && pixels <= kMaxImageSize;
    };
    const std::vector<std::string> parts = split(text, 'x');
    Size size{};
    if (parts.size() != 2 || !side(parts[0], size.width) || !side(parts[1], size.height)) {
        refuse(option, text,
               "WIDTHxHEIGHT, each from 1 to " + std::to_string(kMaxImageSize) + " pixels");
    }
    return size;
}

}  // namespace sheer
