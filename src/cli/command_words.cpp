// From what the parser keeps.
#include "cli/command_words.h"

#include <algorithm>

namespace sheer {

namespace {

std::string quoted(const std::string& word)
{
    constexpr const char* kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

}  // namespace

std::vector<std::string> given_words(const CLI::App& command, const std::vector<std::string>& but)
{
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || std::find(but.begin(), but.end(), name) != but.end()) continue;
        for (const std::string& value : option->results()) {
            if (!option->get_positional()) words.push_back(name);
            if (option->get_positional() || option->get_items_expected_max() > 0) {
                words.push_back(value);
            }
        }
    }
    return words;
}

std::string shell_line(const std::vector<std::string>& words)
{
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + quoted(word);
    return line;
}

}  // namespace sheer
