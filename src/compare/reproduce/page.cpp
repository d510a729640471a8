// Markdown, JSON, CSV.
#include "compare/reproduce/page.h"

#include <cmath>
#include <cstdio>
#include <span>

#include "support/text.h"
#include "support/whole_file.h"

namespace sheer {

namespace {

std::string table_row(const std::vector<std::string>& cells)
{
    std::string line = "|";
    for (const std::string& cell : cells) line += " " + cell + " |";
    return line + "\n";
}

std::string markdown(const Table& table)
{
    std::string text = "\n## " + table.title + "\n\n" + table_row(table.columns);
    text += "|";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const bool is_text = !table.rows.empty() && table.rows.front()[i].value.is_string();
        text += is_text ? " --- |" : " ---: |";
    }
    text += "\n";
    for (const auto& row : table.rows) {
        std::vector<std::string> cells;
        for (const Cell& cell : row) cells.push_back(cell.text);
        text += table_row(cells);
    }
    return text;
}

Json table_json(const Table& table)
{
    Json rows = Json::array();
    for (const auto& row : table.rows) {
        Json object;
        for (std::size_t i = 0; i < row.size(); ++i) object[table.columns[i]] = row[i].value;
        rows.push_back(object);
    }
    return {{"title", table.title}, {"rows", rows}};
}

std::string csv_cell(const Json& value)
{
    if (value.is_null()) return "";
    if (!value.is_string()) return value.dump();
    const auto text = value.get<std::string>();
    return text.find_first_of(",\"\n") == std::string::npos ? text : value.dump();
}

}  // namespace

Cell words(const std::string& text)
{
    return {text, text};
}

Cell whole(long long number)
{
    return {std::to_string(number), number};
}

Cell number(double value, int digits)
{
    return {fixed(value, digits), std::isfinite(value) ? Json(value) : Json()};
}

Cell signed_number(double value, int digits)
{
    Cell cell = number(value, digits);
    if (value > 0 && std::isfinite(value)) cell.text.insert(0, "+");
    return cell;
}

Cell scientific(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2e", value);
    return {std::isfinite(value) ? text : "-", std::isfinite(value) ? Json(value) : Json()};
}

Cell printed(const std::string& as_in_the_paper)
{
    if (as_in_the_paper.empty()) return {"", Json()};
    return {as_in_the_paper, std::stod(as_in_the_paper)};
}

std::string Table::csv() const
{
    std::string text;
    for (std::size_t i = 0; i < columns.size(); ++i)
        text += std::string(i == 0 ? "" : ",") + columns[i];
    text += "\n";
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            text += std::string(i == 0 ? "" : ",") + csv_cell(row[i].value);
        }
        text += "\n";
    }
    return text;
}

Table claims_table(const Claims& claims)
{
    Table table{"Beside the paper",
                {"number", "paper", "ours", "difference", "band", "agrees", "if not, why"},
                {}};
    for (const Claim& claim : claims.all) {
        // As many digits as tell ours from the paper's, one more than printed, and show the band.
        const std::size_t point = claim.paper.find('.');
        int digits = point == std::string::npos ? 2 : static_cast<int>(claim.paper.size() - point);
        while (claim.band > 0 && claim.band * std::pow(10, digits) < 0.9) ++digits;
        table.rows.push_back({words(claim.what), printed(claim.paper), number(claim.ours, digits),
                              signed_number(claim.difference(), digits), number(claim.band, digits),
                              words(claim.agrees() ? "yes" : "no"),
                              words(claim.agrees() ? "" : claim.otherwise)});
    }
    return table;
}

Page::Page(const ReproduceEntry& entry, const ReproduceJob& job)
    : content_{entry.name, entry.paper, entry.shows, job.folder, {}}, done_(job.done)
{
    text_ = "# " + content_.name + "\n\n" + entry.paper + ".\n\n" + entry.shows + "\n";
    json_ = {{"name", entry.name},     {"paper", entry.paper},    {"shows", entry.shows},
             {"quick", job.quick},     {"tables", Json::array()}, {"pictures", Json::array()},
             {"claims", Json::array()}};
    if (job.quick) say("Made in a hurry (--quick): smaller pictures, fewer trials.");
}

void Page::say(const std::string& paragraph)
{
    content_.blocks.emplace_back(paragraph);
    text_ += "\n" + paragraph + "\n";
}

void Page::show(const std::string& file, const std::string& caption)
{
    content_.blocks.emplace_back(Picture{file, caption});
    text_ += "\n![" + caption + "](" + file + ")\n\n" + caption + "\n";
    json_["pictures"].push_back({{"file", file}, {"caption", caption}});
}

void Page::add(const Table& table)
{
    content_.blocks.emplace_back(table);
    text_ += markdown(table);
    json_["tables"].push_back(table_json(table));
}

void Page::compare(const Claims& claims)
{
    content_.blocks.emplace_back(claims);
    text_ += markdown(claims_table(claims)) + "\nBand: " + claims.band + "\n";
    for (const Claim& claim : claims.all) {
        json_["claims"].push_back({{"what", claim.what},
                                   {"paper", std::stod(claim.paper)},
                                   {"ours", claim.ours},
                                   {"band", claim.band},
                                   {"agrees", claim.agrees()},
                                   {"otherwise", claim.otherwise}});
    }
}

std::string Page::file(const std::string& suffix) const
{
    return content_.name + suffix;
}

std::string Page::path(const std::string& suffix) const
{
    return content_.folder + "/" + file(suffix);
}

void Page::write_text(const std::string& suffix, const std::string& text) const
{
    write_whole_file(path(suffix), std::as_bytes(std::span(text)));
}

void Page::write() const
{
    write_text(".md", text_);
    write_text(".json", json_.dump(2) + "\n");
    if (done_) done_(content_);
}

}  // namespace sheer
