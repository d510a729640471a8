// What --over means, and which values it takes where none are given.
#include "cli/bench_over.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "cli/values.h"
#include "support/parallel.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr int kMostLayers = 256;

[[noreturn]] void refuse(const std::string& what)
{
    throw Error(Fault::input, what);
}

Axis parse_axis(const std::string& option, const std::string& text)
{
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        if (text == kAxes[i]) return static_cast<Axis>(i);
    }
    const std::vector<std::string> names(kAxes.begin(), kAxes.end());
    refuse(option + ": '" + text + "' is none of " + joined(names) + suggestion(text, names));
}

// What grows along the axis.
std::uint64_t amount_of(Axis axis, const Setting& setting)
{
    const View& view = setting.given.view;
    switch (axis) {
        case Axis::threads: return static_cast<std::uint64_t>(setting.given.options.threads);
        case Axis::size:
            return static_cast<std::uint64_t>(view.width) * static_cast<std::uint64_t>(view.height);
        case Axis::samples: return static_cast<std::uint64_t>(view.samples);
        case Axis::layers: break;
    }
    return static_cast<std::uint64_t>(setting.layers);
}

Setting parse_value(const std::string& option, Axis axis, const std::string& text)
{
    Setting setting{.given = {}, .value = text};
    View& view = setting.given.view;
    switch (axis) {
        case Axis::threads:
            setting.given.options.threads = parse_whole(option, text, 1, 4096);
            break;
        case Axis::size: {
            const Size size = parse_size(option, text);
            view.width = size.width;
            view.height = size.height;
            break;
        }
        case Axis::samples: view.samples = parse_whole(option, text, 1, 64); break;
        case Axis::layers: setting.layers = parse_whole(option, text, 1, kMostLayers); break;
    }
    return setting;
}

std::string usual_threads()
{
    const int most = std::max(2, hardware_threads());
    std::string text;
    for (int threads = 1; threads < most; threads *= 2) text += std::to_string(threads) + ",";
    return text + std::to_string(most);
}

// A quarter of the sides, half of them, and the size itself: 16 times the pixels.
std::string usual_sizes(const View& view)
{
    std::string text;
    for (const int part : {4, 2, 1}) {
        text += size_text(std::max(1, view.width / part), std::max(1, view.height / part));
        if (part > 1) text += ",";
    }
    return text;
}

std::string usual_values(Axis axis, const View& view)
{
    switch (axis) {
        case Axis::threads: return usual_threads();
        case Axis::size: return usual_sizes(view);
        case Axis::samples: return "1,2,4,8,16";
        case Axis::layers: break;
    }
    return "1,2,4,8";
}

std::vector<Setting> parse_values(const std::string& option, Axis axis, const std::string& text)
{
    std::vector<Setting> values;
    for (const std::string& part : split(text, ',')) {
        values.push_back(parse_value(option, axis, part));
        const std::size_t n = values.size();
        if (n > 1 && amount_of(axis, values[n - 1]) <= amount_of(axis, values[n - 2])) {
            refuse(option + ": '" + text + "' does not grow from value to value");
        }
    }
    if (values.size() < 2) refuse(option + ": '" + text + "' is one value; growth takes two");
    return values;
}

// With the view and the options as they were given, but for what the axis is about.
Setting complete(Axis axis, const Setting& value, const ViewOptions& given)
{
    Setting setting{given, value.layers, value.value};
    View& view = setting.given.view;
    if (axis == Axis::threads) setting.given.options.threads = value.given.options.threads;
    if (axis == Axis::samples) view.samples = value.given.view.samples;
    if (axis == Axis::size) {
        view.width = value.given.view.width;
        view.height = value.given.view.height;
    }
    return setting;
}

}  // namespace

Over parse_over(const std::string& option, const std::string& text)
{
    const std::size_t sign = text.find('=');
    Over over{parse_axis(option, text.substr(0, sign)), {}};
    if (sign != std::string::npos) {
        over.values = parse_values(option, over.axis, text.substr(sign + 1));
    }
    return over;
}

std::vector<Setting> settings_over(const Over& over, const ViewOptions& given,
                                   const std::vector<int>& samples, const CLI::App& command)
{
    const std::string name = axis_name(over.axis);
    // A size alone is the one that the usual ones are parts of.
    const bool may_be_given =
        over.axis == Axis::layers || (over.axis == Axis::size && over.values.empty());
    if (!may_be_given && command.get_option("--" + name)->count() > 0) {
        refuse("--" + name + ": '--over " + name + "' goes through several; give them as '--over " +
               name + "=...'");
    }
    if (over.axis != Axis::samples && samples.size() != 1) {
        refuse("--samples: one number is needed with '--over " + name + "'");
    }
    ViewOptions one = given;
    one.view.samples = samples.front();
    std::vector<Setting> values = over.values;
    if (values.empty()) {
        values = parse_values("--over " + name, over.axis, usual_values(over.axis, given.view));
    }
    for (Setting& value : values) value = complete(over.axis, value, one);
    return values;
}

}  // namespace sheer
