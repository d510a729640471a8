// sheer: the command line tool. Parses, hands over to a subcommand, and turns whatever went wrong
// into one line on standard error and an exit code: 0 done, 1 the work failed, 2 the command or its
// input is wrong.
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include <sheer/error.h>

#include "cli/commands.h"
#include "cli/help_text.h"
#include "cli/output.h"
#include "support/text.h"

namespace sheer {

namespace {

constexpr int kWorkFailed = 1;
constexpr int kWrongInput = 2;

// Full disks and closed pipes are to be errors of the calls that meet them, not the end.
void prepare_process()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    // A stream that is closed from the start stays one that can't be used: without this, the first
    // file opened would take its number, and messages would end up in that file.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) != -1) continue;
        const int opposite = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
        if (open("/dev/null", opposite) < 0) return;
    }
}

int report(const std::string& what, int exit_code)
{
    std::fputs(("sheer: " + one_line(what) + "\n").c_str(), stderr);
    return exit_code;
}

void add_commands(CLI::App& tool)
{
    tool.get_formatter()->column_width(34);
    tool.set_help_flag("-h,--help", "Print this help and exit");
    tool.set_version_flag("--version", "sheer " SHEER_VERSION, "Print the version and exit");
    tool.require_subcommand(1);
    add_render_command(tool);
    add_info_command(tool);
    add_methods_command(tool);
    add_bench_command(tool);
    add_compare_command(tool);
    add_diff_command(tool);
    add_transmittance_command(tool);
    add_reproduce_command(tool);
    tool.footer("'sheer COMMAND --help' says more about a command.\n\n" +
                examples_help({"sheer render builtin:windy-hill -o hill.png",
                               "sheer render scene.glb -o scene.exr --method blend --samples 4",
                               "sheer info scene.glb", "sheer methods",
                               "sheer bench builtin:motor --size 500x500 --samples 1,8",
                               "sheer compare scene.glb -o out",
                               "sheer diff blend.exr exact.exr -o error.png",
                               "sheer transmittance builtin:smoke --pixel 512,384 -o smoke.svg",
                               "sheer reproduce stochastic-examples -o out"}) +
                "\n" + methods_help() + "\n" + scenes_help());
}

// Of the command that was given, or of the tool.
std::vector<std::string> option_names(const CLI::App& tool)
{
    const auto commands = tool.get_subcommands();
    const CLI::App& command = commands.empty() ? tool : *commands.front();
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

// What the parser found wrong, in the words of a person. CLI11 names what it could not place in
// reverse order, and only after whatever is missing because of it.
std::string explain(const CLI::ParseError& error, const CLI::App& tool)
{
    const std::vector<std::string> unknown = tool.remaining(true);
    for (const std::string& word : unknown) {
        if (word.starts_with('-')) {
            return "there is no option '" + word + "'" + suggestion(word, option_names(tool));
        }
    }
    if (tool.get_subcommands().empty()) {
        if (unknown.empty()) return "a command is needed";
        std::vector<std::string> commands;
        for (const CLI::App* command : tool.get_subcommands({})) {
            commands.push_back(command->get_name());
        }
        return "there is no command '" + unknown.front() + "'" +
               suggestion(unknown.front(), commands);
    }
    if (!unknown.empty()) return "'" + unknown.front() + "' is one argument too many";
    return error.what();
}

std::string help_pointer(const CLI::App& tool)
{
    const auto commands = tool.get_subcommands();
    const std::string command = commands.empty() ? "" : commands.front()->get_name() + " ";
    return "; see 'sheer " + command + "--help'";
}

int run(int argc, const char* const* argv)
{
    CLI::App tool("Transparent scenes without sorting.", "sheer");
    add_commands(tool);
    try {
        tool.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        print(tool.help());
    } catch (const CLI::CallForVersion& version) {
        print(std::string(version.what()) + "\n");
    } catch (const CLI::ParseError& error) {
        return report(explain(error, tool) + help_pointer(tool), kWrongInput);
    }
    return 0;
}

}  // namespace

}  // namespace sheer

int main(int argc, char** argv)
{
    using namespace sheer;
    prepare_process();
    try {
        return run(argc, argv);
    } catch (const Error& error) {
        return report(error.what(), error.fault() == Fault::input ? kWrongInput : kWorkFailed);
    } catch (const std::bad_alloc&) {
        return report("there is not enough memory", kWorkFailed);
    } catch (const std::exception& error) {
        return report(error.what(), kWorkFailed);
    }
}
