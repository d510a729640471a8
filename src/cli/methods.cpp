// sheer methods: the table of methods, for people and for programs.
#include <memory>

#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/output.h"
#include "methods/method.h"

namespace sheer {

namespace {

const char* name_of(Bias bias)
{
    switch (bias) {
        case Bias::exact: return "exact";
        case Bias::unbiased: return "unbiased";
        case Bias::consistent: return "consistent";
        case Bias::neither: break;
    }
    return "neither";
}

const char* name_of(Agreement agreement)
{
    switch (agreement) {
        case Agreement::bits: return "bits";
        case Agreement::rounding: return "rounding";
        case Agreement::none: break;
    }
    return "none";
}

// Whether the stores of a scene's parts, merged, are the whole scene's.
const char* parts_merge(const MethodTraits& traits)
{
    return traits.merges_in_order ? "in order" : name_of(traits.merge);
}

std::string exact_up_to(const MethodRow& row)
{
    return row.traits.exact_up_to < 0 ? "any" : std::to_string(row.traits.exact_up_to);
}

Json parameters_json(const MethodRow& row)
{
    Json parameters = Json::array();
    for (const Parameter& p : row.parameters) {
        parameters.push_back(
            {{"name", p.name}, {"values", p.values}, {"default", p.standard}, {"what", p.what}});
    }
    return parameters;
}

Json methods_json()
{
    Json methods = Json::array();
    for (const MethodRow& row : method_table()) {
        // Any number of fragments is no number: null.
        const Json most = row.traits.exact_up_to < 0 ? Json() : Json(row.traits.exact_up_to);
        methods.push_back(
            {{"id", row.id},
             {"title", row.title},
             {"citation", row.citation},
             {"continuum",
              {{"contribute", row.continuum.contribute},
               {"store", row.continuum.store},
               {"merge", row.continuum.merge},
               {"normalise", row.continuum.normalise}}},
             {"parameters", parameters_json(row)},
             {"passes", row.traits.passes},
             {"bytes_per_pixel", row.traits.bytes_formula()},
             {"bounded", row.traits.bounded},
             {"order_independent", row.traits.any_order != Agreement::none},
             {"any_order", name_of(row.traits.any_order)},
             {"merge", name_of(row.traits.merge)},
             {"merges_in_order", row.traits.merges_in_order},
             {"random", row.traits.random},
             {"coloured", row.colored_verbs != nullptr},
             {"unbiased", row.traits.bias == Bias::exact || row.traits.bias == Bias::unbiased},
             {"bias", name_of(row.traits.bias)},
             {"exact_up_to", most},
             {"bench_only", row.bench_only}});
    }
    Json json;
    json["methods"] = methods;
    return json;
}

std::string properties_table()
{
    const auto yes = [](bool value) { return value ? "yes" : "no"; };
    TextTable table{.left = 1, .last_is_prose = true, .rows = {}};
    table.rows.push_back({"method", "passes", "bytes a pixel", "bounded", "any order",
                          "parts merge", "coloured", "on average", "exact up to", "what it is"});
    for (const MethodRow& row : method_table()) {
        table.rows.push_back({row.id, std::to_string(row.traits.passes), row.traits.bytes_formula(),
                              yes(row.traits.bounded), name_of(row.traits.any_order),
                              parts_merge(row.traits), yes(row.colored_verbs != nullptr),
                              name_of(row.traits.bias), exact_up_to(row),
                              row.title + std::string(row.bench_only ? " (bench only)" : "")});
    }
    return table.text();
}

std::string continuum_table()
{
    TextTable table{.left = 4, .last_is_prose = true, .rows = {}};
    table.rows.push_back({"method", "a fragment contributes", "what is stored",
                          "one too many: merge", "of what was given up: normalise"});
    for (const MethodRow& row : method_table()) {
        const ContinuumPlace& place = row.continuum;
        table.rows.push_back({row.id, place.contribute, place.store, place.merge, place.normalise});
    }
    return table.text();
}

// The table of docs/continuum.md.
std::string methods_markdown()
{
    std::string text =
        "| method | contribute | store | merge | normalise | bytes a pixel | passes | any order | "
        "parts merge | on average | exact up to |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const MethodRow& row : method_table()) {
        const ContinuumPlace& place = row.continuum;
        const std::string cells[] = {"`" + std::string(row.id) + "`",
                                     place.contribute,
                                     place.store,
                                     place.merge,
                                     place.normalise,
                                     row.traits.bytes_formula(),
                                     std::to_string(row.traits.passes),
                                     name_of(row.traits.any_order),
                                     parts_merge(row.traits),
                                     name_of(row.traits.bias),
                                     exact_up_to(row)};
        for (const std::string& cell : cells) text += "| " + cell + " ";
        text += "|\n";
    }
    return text;
}

std::string methods_text()
{
    std::string text = properties_table() + "\n" + continuum_table();
    text +=
        "\nS: samples a pixel; N: fragments of the pixel; exact up to: fragments a sample\n"
        "any order: the same for every order of the fragments, bit for bit or to rounding\n"
        "parts merge: so are the merged stores of parts of the scene, pass by pass; or in the "
        "parts' order\n\n";
    for (const MethodRow& row : method_table()) {
        text += std::string(row.id) + ": " + row.citation + "\n";
        TextTable table{.left = 2, .last_is_prose = true, .rows = {}};
        for (const Parameter& p : row.parameters) {
            table.rows.push_back({"    " + std::string(p.name) + "=" + p.values,
                                  std::string("(") + p.standard + ")", p.what});
        }
        text += table.text();
    }
    return text;
}

}  // namespace

void add_methods_command(CLI::App& tool)
{
    CLI::App* command = tool.add_subcommand("methods", "List the methods and their properties");
    const auto json = std::make_shared<bool>(false), markdown = std::make_shared<bool>(false);
    CLI::Option* for_programs =
        command->add_flag("--json", *json, "For programs; exact_up_to is null for any number");
    for_programs->disable_flag_override();
    command->add_flag("--markdown", *markdown, "The table of docs/continuum.md")
        ->disable_flag_override()
        ->excludes(for_programs);
    command->footer(examples_help(
        {"sheer methods", "sheer methods --json", "sheer methods --markdown",
         "sheer methods --json | jq -r '.methods[] | select(.order_independent) | .id'"}));
    command->callback([json, markdown] {
        print(*json ? json_text(methods_json()) : *markdown ? methods_markdown() : methods_text());
    });
}

}  // namespace sheer
