// The options that say what is seen and how it is drawn, for every command that draws.
#pragma once

#include <CLI/CLI.hpp>

#include <sheer/render.h>

namespace sheer {

struct ViewOptions {
    View view;
    Options options;
};

// `given` is filled while the command line is parsed and outlives `command`. The number of samples
// is each command's own.
void add_view_options(CLI::App& command, ViewOptions& given);

// Options of some commands only: a list of numbers of samples, and the seed.
void add_samples_list(CLI::App& command, std::vector<int>& samples);
void add_seed(CLI::App& command, Options& options);

// An option whose value reaches `read` as it was typed, with the option's name.
using ReadValue = std::function<void(const std::string& option, const std::string& text)>;
CLI::Option* add_value(CLI::App& command, const std::string& names, const std::string& value,
                       const std::string& what, ReadValue read);

// Throws Error(Fault::input) that names the option when there is no such method, or when it is for
// `bench` alone.
void check_makes_picture(const std::string& option, const std::string& method);

// Throws Error(Fault::input) that names the option, for use before a scene is loaded.
void check_view_options(const ViewOptions& given);

}  // namespace sheer
