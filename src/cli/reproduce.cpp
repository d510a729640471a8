// sheer reproduce: the papers' tables and figures.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <sheer/error.h>

#include "cli/command_words.h"
#include "cli/commands.h"
#include "cli/folder.h"
#include "cli/help_text.h"
#include "cli/output.h"
#include "cli/values.h"
#include "cli/view_options.h"
#include "compare/reproduce/all_page.h"
#include "compare/reproduce/reproduce.h"
#include "support/progress.h"
#include "support/whole_file.h"

namespace sheer {

namespace {

struct ReproduceRequest {
    std::vector<std::string> names;
    ReproduceJob job;
    std::string command;  // as it was given
};

std::string list_text()
{
    TextTable table{.left = 2, .last_is_prose = true, .rows = {}};
    for (const ReproduceEntry& entry : reproduce_entries()) {
        table.rows.push_back({entry.name, entry.shows});
    }
    return table.text();
}

std::vector<const ReproduceEntry*> chosen_entries(const std::vector<std::string>& names)
{
    std::vector<const ReproduceEntry*> chosen;
    for (const std::string& name : names) {
        if (name != "all") {
            chosen.push_back(&find_reproduce_entry(name));
            continue;
        }
        for (const ReproduceEntry& entry : reproduce_entries()) chosen.push_back(&entry);
    }
    return chosen;
}

void check_is_folder(const std::string& path)
{
    if (path.empty() || std::filesystem::is_directory(path)) return;
    throw Error(Fault::input, path + ": not a folder");
}

void run_reproduce(ReproduceRequest request)
{
    if (std::ranges::find(request.names, "list") != request.names.end()) {
        if (request.names.size() > 1) throw Error(Fault::input, "NAME: 'list' stands alone");
        print(list_text());
        return;
    }
    const auto entries = chosen_entries(request.names);
    if (request.job.folder.empty()) throw Error(Fault::input, "--output is required");
    check_is_folder(request.job.scenes);
    make_folder(request.job.folder);
    const std::string all = request.job.folder + "/index.html";
    check_writable(all);
    std::vector<PageContent> pages;
    request.job.done = [&pages](const PageContent& page) { pages.push_back(page); };
    for (const ReproduceEntry* entry : entries) {
        for (const char* suffix : {".md", ".json"}) {
            check_writable(request.job.folder + "/" + entry->name + suffix);
        }
    }
    for (const ReproduceEntry* entry : entries) {
        {
            ProgressBar bar(entry->name);
            request.job.progress = [&bar](double part) { bar.update(part); };
            entry->run(*entry, request.job);
        }
        print(one_line(request.job.folder + "/" + entry->name) + ".md\n");
    }
    const std::string html =
        all_page_html({pages, "sheer " SHEER_VERSION, request.command, request.job.quick});
    write_whole_file(all, std::as_bytes(std::span(html)));
    print(one_line(all) + "\n");
}

}  // namespace

void add_reproduce_command(CLI::App& tool)
{
    CLI::App* command =
        tool.add_subcommand("reproduce", "Make the papers' tables and figures, ours beside theirs");
    const auto request = std::make_shared<ReproduceRequest>();
    command
        ->add_option("NAME", request->names,
                     "What to make: names, 'all', or 'list' to see what there is")
        ->required();
    add_value(*command, "-o,--output", "DIR", "A folder for the results, made if missing; required",
              [request](auto&, auto& text) { request->job.folder = text; });
    add_value(*command, "--scenes", "DIR",
              "Scene files for 'continuum-table', which takes five glTF files below it",
              [request](auto&, auto& text) { request->job.scenes = text; });
    add_value(*command, "--threads", "N", "0: all that the machine has (0)",
              [request](auto& option, auto& text) {
                  request->job.options.threads = parse_whole(option, text, 0, 4096);
              });
    command
        ->add_flag("--quick", request->job.quick,
                   "Smaller pictures and fewer trials: seconds instead of minutes")
        ->disable_flag_override();
    command->footer(
        "For each name DIR gets NAME.md to read, NAME.json with all digits, and pictures; "
        "index.html\nis all of them on one page that needs no other file, with what agrees with "
        "the paper.\n\nTables and figures:\n" +
        list_text() + "\n" +
        examples_help({"sheer reproduce list", "sheer reproduce stochastic-examples -o out",
                       "sheer reproduce all -o out --quick"}));
    command->callback([request, command] {
        request->command = "sheer reproduce " + shell_line(given_words(*command, {}));
        run_reproduce(*request);
    });
}

}  // namespace sheer
