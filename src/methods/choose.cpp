// ID[:NAME=VALUE]... against the table.
#include <algorithm>
#include <charconv>

#include <sheer/error.h>

#include "methods/method.h"
#include "support/text.h"

namespace sheer {

namespace {

std::string quoted(std::string_view text)
{
    return "'" + std::string(text) + "'";
}

const MethodRow& find_row(std::string_view id)
{
    std::vector<std::string> known;
    for (const MethodRow& row : method_table()) {
        if (row.id == id) return row;
        if (!row.bench_only) known.emplace_back(row.id);
    }
    throw Error(Fault::input, "method: there is no method " + quoted(id) + suggestion(id, known) +
                                  "; there are " + joined(known));
}

std::size_t find_parameter(const MethodRow& row, std::string_view name)
{
    for (std::size_t i = 0; i < row.parameters.size(); ++i) {
        if (row.parameters[i].name == name) return i;
    }
    std::vector<std::string> known;
    for (const Parameter& parameter : row.parameters) known.emplace_back(parameter.name);
    throw Error(Fault::input, "method: " + std::string(row.id) + " has no parameter " +
                                  quoted(name) + suggestion(name, known) + "; it has " +
                                  (known.empty() ? "none" : joined(known)));
}

template <class Number>
bool in_range(std::string_view range, std::string_view value)
{
    const auto number = [](std::string_view text, Number& result) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
        return error == std::errc() && end == text.data() + text.size();
    };
    const std::size_t dots = range.find("..");
    Number least{}, most{}, chosen{};
    return number(range.substr(0, dots), least) && number(range.substr(dots + 2), most) &&
           number(value, chosen) && chosen >= least && chosen <= most;
}

bool allowed(const Parameter& parameter, std::string_view value)
{
    const auto choices = split(parameter.values, '|');
    return std::any_of(choices.begin(), choices.end(), [&](std::string_view choice) {
        if (choice.find("..") == std::string_view::npos) return choice == value;
        const bool is_real =
            choice.substr(0, choice.find("..")).find('.') != std::string_view::npos;
        return is_real ? in_range<double>(choice, value) : in_range<long>(choice, value);
    });
}

}  // namespace

const std::string& ChosenMethod::value(std::string_view parameter) const
{
    return values[find_parameter(*row, parameter)];
}

std::string ChosenMethod::parameters_text() const
{
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) text += ':';
        text += row->parameters[i].name;
        text += '=';
        text += values[i];
    }
    return text;
}

int ChosenMethod::number(std::string_view parameter) const
{
    return std::stoi(value(parameter));
}

double ChosenMethod::real(std::string_view parameter) const
{
    const std::string& text = value(parameter);
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

FragmentWants ChosenMethod::wants() const
{
    return row->wants != nullptr ? row->wants(*this) : FragmentWants{};
}

MethodTraits ChosenMethod::traits() const
{
    return row->traits_of != nullptr ? row->traits_of(*this) : row->traits;
}

std::string MethodTraits::bytes_formula() const
{
    std::string text;
    const auto add = [&](int bytes, const char* of) {
        if (bytes != 0) text += (text.empty() ? "" : " + ") + std::to_string(bytes) + of;
    };
    add(bytes_per_sample, " S");
    add(bytes_per_fragment, " N");
    add(bytes_per_fragment_and_sample, " S N");
    add(bytes_besides, "");
    if (bytes_of_pictures > 0) text += " + " + fixed(bytes_of_pictures, 4);
    return text.empty() ? "0" : text;
}

MethodRow with_standard_traits(MethodRow row)
{
    ChosenMethod standard{&row, {}};
    for (const Parameter& p : row.parameters) standard.values.emplace_back(p.standard);
    row.traits = row.traits_of(standard);
    return row;
}

void check_method(const ChosenMethod& method, int samples)
{
    const auto refusal = method.row->refusal;
    const std::string text = refusal != nullptr ? refusal(method, samples) : "";
    if (!text.empty()) {
        throw Error(Fault::input, "method: " + std::string(method.row->id) + ": " + text);
    }
}

ChosenMethod choose_method(std::string_view text)
{
    const auto parts = split(text, ':');
    ChosenMethod chosen{&find_row(parts[0]), {}};
    for (const Parameter& p : chosen.row->parameters) chosen.values.emplace_back(p.standard);
    std::vector<bool> is_given(chosen.values.size());
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::size_t equals = parts[i].find('=');
        if (equals == std::string_view::npos) {
            throw Error(Fault::input, "method: " + quoted(parts[i]) + " is not NAME=VALUE");
        }
        const std::string value = parts[i].substr(equals + 1);
        const std::size_t at = find_parameter(*chosen.row, parts[i].substr(0, equals));
        const Parameter& parameter = chosen.row->parameters[at];
        if (!allowed(parameter, value)) {
            throw Error(Fault::input, "method: " + std::string(chosen.row->id) + ": " +
                                          parameter.name + " is " + parameter.values + ", not " +
                                          quoted(value) +
                                          suggestion(value, split(parameter.values, '|')));
        }
        if (is_given[at]) {
            throw Error(Fault::input, "method: " + std::string(chosen.row->id) + ": " +
                                          parameter.name + " is given twice");
        }
        is_given[at] = true;
        chosen.values[at] = value;
    }
    return chosen;
}

}  // namespace sheer
