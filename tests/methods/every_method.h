// Every row of the table of methods, with every combination of its parameters' values.
#pragma once

#include <string>
#include <vector>

#include "methods/method.h"
#include "support/text.h"

namespace sheer {

// Of a range of whole numbers: both ends and the standard value.
inline std::vector<std::string> values_of(const Parameter& parameter)
{
    const std::string values = parameter.values;
    const std::size_t dots = values.find("..");
    if (dots != std::string::npos) {
        return {values.substr(0, dots), parameter.standard, values.substr(dots + 2)};
    }
    std::vector<std::string> choices;
    for (const auto& choice : split(values, '|')) choices.emplace_back(choice);
    return choices;
}

inline std::vector<ChosenMethod> every_choice(const MethodRow& row)
{
    std::vector<std::string> texts = {row.id};
    for (const Parameter& parameter : row.parameters) {
        std::vector<std::string> longer;
        for (const std::string& text : texts) {
            for (const std::string& value : values_of(parameter)) {
                longer.push_back(text + ":" + parameter.name + "=" + value);
            }
        }
        texts = std::move(longer);
    }
    std::vector<ChosenMethod> choices;
    for (const std::string& text : texts) choices.push_back(choose_method(text));
    return choices;
}

inline std::vector<ChosenMethod> every_method()
{
    std::vector<ChosenMethod> all;
    for (const MethodRow& row : method_table()) {
        for (const ChosenMethod& choice : every_choice(row)) all.push_back(choice);
    }
    return all;
}

inline std::string name_of(const ChosenMethod& method)
{
    const std::string parameters = method.parameters_text();
    return method.row->id + (parameters.empty() ? "" : ":" + parameters);
}

}  // namespace sheer
