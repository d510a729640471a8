// What people type after an option, as numbers and choices. Everything here throws
// Error(Fault::input) with a line that begins with the option's name.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sheer/error.h>
#include <sheer/scene.h>

namespace sheer {

struct Size {
    int width, height;
};

// All of them finite.
float parse_float(const std::string& option, const std::string& text);
Float3 parse_point(const std::string& option, const std::string& text, const char* form = "X,Y,Z");
Float4 parse_background(const std::string& option, const std::string& text);
float parse_fov(const std::string& option, const std::string& text);  // degrees

Size parse_size(const std::string& option, const std::string& text);

template <class T>
T parse_whole(const std::string& option, std::string_view text, T least, T most)
{
    T value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && stop == end && value >= least && value <= most) return value;
    throw Error(Fault::input, option + ": '" + std::string(text) + "' is not a whole number from " +
                                  std::to_string(least) + " to " + std::to_string(most));
}

template <class T, std::size_t N>
T parse_choice(const std::string& option, std::string_view text,
               const std::array<std::pair<const char*, T>, N>& choices)
{
    std::string known;
    for (const auto& [name, value] : choices) {
        if (text == name) return value;
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    throw Error(Fault::input, option + ": '" + std::string(text) + "' is none of " + known);
}

// Runs a check of the library, whose complaints begin with an argument's name and a colon, and puts
// the option's name there: `option`, or two dashes before the argument's name where it is empty.
template <class Check>
auto check_option(const std::string& option, Check check) -> decltype(check())
{
    try {
        return check();
    } catch (const Error& error) {
        const std::string text = error.what();
        const std::size_t colon = text.find(':');
        if (option.empty() || colon == std::string::npos) throw Error(error.fault(), "--" + text);
        throw Error(error.fault(), option + text.substr(colon));
    }
}

}  // namespace sheer
