// What an entry of `sheer reproduce` leaves: a page to read, and the same numbers as JSON.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "compare/claim.h"
#include "compare/reproduce/reproduce.h"

namespace sheer {

using Json = nlohmann::ordered_json;

struct Cell {
    std::string text;
    Json value;
};

Cell words(const std::string& text);
Cell whole(long long number);
Cell number(double value, int digits);             // "-" and null for what is not finite
Cell signed_number(double value, int digits);      // "+0.3"
Cell scientific(double value);                     // "1.23e-05"
Cell printed(const std::string& as_in_the_paper);  // "0.17"; empty: the paper says nothing

struct Table {
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows;  // as long as `columns`

    std::string csv() const;  // numbers with all their digits
};

struct Picture {
    std::string file, caption;
};

// All of a page in its order; a string is a paragraph.
struct PageContent {
    std::string name, paper, shows, folder;
    std::vector<std::variant<std::string, Table, Picture, Claims>> blocks;
};

// As NAME.md and the page of all show them.
Table claims_table(const Claims& claims);

class Page {
public:
    Page(const ReproduceEntry& entry, const ReproduceJob& job);

    void say(const std::string& paragraph);
    void show(const std::string& file, const std::string& caption);  // a picture in the folder
    void add(const Table& table);
    void compare(const Claims& claims);

    // Where that file of this entry lies: FOLDER/NAME.suffix.
    std::string path(const std::string& suffix) const;
    std::string file(const std::string& suffix) const;  // NAME.suffix

    void write_text(const std::string& suffix, const std::string& text) const;
    void write() const;  // NAME.md and NAME.json; tells job.done

private:
    PageContent content_;
    std::function<void(const PageContent&)> done_;
    std::string text_;
    Json json_;
};

}  // namespace sheer
