// Blocks to elements; what stands in paragraphs is the little Markdown that entries use.
#include "compare/reproduce/all_page.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <string_view>

#include "compare/report/report.h"
#include "support/read_file.h"

namespace sheer {

namespace {

constexpr std::string_view kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy"
  content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<title>Sheer: the papers' tables and figures</title>
<link rel="icon" href="data:,">
<style>
:root {
  color-scheme: light dark;
  --back: #fff; --text: #1b1b1f; --quiet: #5c5c66; --line: #d5d5dc; --soft: #f3f3f6;
  --accent: #2456b8; --good: #1c7a37; --bad: #b3441a;
}
@media (prefers-color-scheme: dark) {
  :root {
    --back: #17171a; --text: #ececf0; --quiet: #a5a5b0; --line: #3a3a42; --soft: #222227;
    --accent: #8fb4ff; --good: #7fd696; --bad: #ffa07a;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 1rem; max-width: 72rem; background: var(--back); color: var(--text);
  font: 16px/1.5 system-ui, sans-serif;
}
h1, h2, h3 { line-height: 1.25; overflow-wrap: anywhere; }
h2 { margin-top: 3rem; border-top: 1px solid var(--line); padding-top: 1rem; }
a { color: var(--accent); }
.quiet { color: var(--quiet); }
.wide { overflow-x: auto; border: 1px solid var(--line); border-radius: .4rem; margin: .5rem 0; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
caption { text-align: left; font-weight: 600; padding: .3rem .6rem; }
th, td { padding: .2rem .6rem; text-align: right; border-bottom: 1px solid var(--line); }
th { background: var(--soft); }
td { white-space: nowrap; }
td.text, th.text { text-align: left; }
td.long { white-space: normal; min-width: 18rem; }
.yes { color: var(--good); font-weight: 600; }
.no { color: var(--bad); font-weight: 600; }
figure { margin: 1rem 0; }
figure > div { overflow-x: auto; }
figcaption { color: var(--quiet); font-size: .9rem; }
@media (max-width: 40rem) { body { padding: .6rem; } }
</style>
</head>
<body>
)";

constexpr std::size_t kLongText = 40;  // letters of a cell that may have lines

std::string escaped(std::string_view text)
{
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&': html += "&amp;"; break;
            case '<': html += "&lt;"; break;
            case '>': html += "&gt;"; break;
            case '"': html += "&quot;"; break;
            default: html += c;
        }
    }
    return html;
}

// `code` and *emphasis*, each on what has an end.
std::string inline_html(std::string_view text)
{
    std::string html;
    while (!text.empty()) {
        const std::size_t mark = text.find_first_of("`*");
        html += escaped(text.substr(0, mark));
        if (mark == std::string_view::npos) break;
        const char which = text[mark];
        text.remove_prefix(mark + 1);
        const std::size_t end = text.find(which);
        const bool is_mark = end != std::string_view::npos && end > 0 &&
                             (which == '`' || (text[0] != ' ' && text[end - 1] != ' '));
        if (!is_mark) {
            html += which;
            continue;
        }
        const std::string tag = which == '`' ? "code" : "em";
        html += "<" + tag + ">" + escaped(text.substr(0, end)) + "</" + tag + ">";
        text.remove_prefix(end + 1);
    }
    return html;
}

std::string cell_html(const Cell& cell, bool judged)
{
    std::string classes = cell.value.is_string() ? "text" : "";
    if (cell.text.size() > kLongText) classes += " long";
    if (judged) classes += cell.text == "yes" ? " yes" : " no";
    return "<td class=\"" + classes + "\">" + inline_html(cell.text) + "</td>";
}

std::string table_html(const Table& table, std::size_t judged_column)
{
    std::string html = "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" +
                       escaped(table.title) + "\"><table><caption>" + inline_html(table.title) +
                       "</caption>\n<thead><tr>";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const bool is_text = !table.rows.empty() && table.rows.front()[i].value.is_string();
        html += std::string("<th scope=\"col\"") + (is_text ? " class=\"text\">" : ">") +
                inline_html(table.columns[i]) + "</th>";
    }
    html += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) html += cell_html(row[i], i == judged_column);
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string picture_html(const Picture& picture, const std::string& folder)
{
    const std::string path = folder + "/" + picture.file;
    const bool is_svg = std::filesystem::path(path).extension() == ".svg";
    const Bytes bytes = read_file(path);
    return "<figure><div><img src=\"" +
           data_address(is_svg ? "image/svg+xml" : "image/png", std::as_bytes(std::span(bytes))) +
           "\" alt=\"" + escaped(picture.caption) + "\"></div><figcaption>" +
           inline_html(picture.caption) + "</figcaption></figure>\n";
}

std::string block_html(const PageContent& entry, std::size_t i)
{
    constexpr std::size_t kNoColumn = ~std::size_t{0}, kAgrees = 5;
    const auto& block = entry.blocks[i];
    if (const auto* text = std::get_if<std::string>(&block)) {
        return "<p>" + inline_html(*text) + "</p>\n";
    }
    if (const auto* table = std::get_if<Table>(&block)) return table_html(*table, kNoColumn);
    if (const auto* picture = std::get_if<Picture>(&block)) {
        return picture_html(*picture, entry.folder);
    }
    const auto& claims = std::get<Claims>(block);
    return table_html(claims_table(claims), kAgrees) +
           "<p class=\"quiet\">Band: " + inline_html(claims.band) + "</p>\n";
}

struct Count {
    std::size_t agree = 0, all = 0;
};

Count count_claims(const PageContent& entry)
{
    Count count;
    for (const auto& block : entry.blocks) {
        const auto* claims = std::get_if<Claims>(&block);
        if (claims == nullptr) continue;
        for (const Claim& claim : claims->all) {
            ++count.all;
            count.agree += claim.agrees() ? 1 : 0;
        }
    }
    return count;
}

std::string count_text(const Count& count)
{
    return count.all == 0 ? "none is compared"
                          : std::to_string(count.agree) + " of " + std::to_string(count.all);
}

std::string contents_html(const std::vector<PageContent>& entries)
{
    std::string html =
        "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Contents\"><table>\n"
        "<thead><tr><th scope=\"col\" class=\"text\">entry</th><th scope=\"col\" class=\"text\">"
        "shows</th><th scope=\"col\" class=\"text\">numbers that agree</th></tr></thead>\n"
        "<tbody>\n";
    std::string paper;
    for (const PageContent& entry : entries) {
        if (entry.paper != paper) {
            paper = entry.paper;
            html += "<tr><th scope=\"colgroup\" class=\"text\" colspan=\"3\">" + escaped(paper) +
                    "</th></tr>\n";
        }
        const Count count = count_claims(entry);
        const std::string judged = count.all == 0             ? "text quiet"
                                   : count.agree == count.all ? "text yes"
                                                              : "text no";
        html += "<tr><td class=\"text\"><a href=\"#" + entry.name + "\">" + entry.name +
                "</a></td><td class=\"text long\">" + inline_html(entry.shows) +
                "</td><td class=\"" + judged + "\">" + count_text(count) + "</td></tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

}  // namespace

std::string all_page_html(const AllPage& page)
{
    Count all;
    for (const PageContent& entry : page.entries) {
        const Count count = count_claims(entry);
        all.agree += count.agree;
        all.all += count.all;
    }
    std::string html(kHead);
    html += "<header><h1>The papers' tables and figures</h1>\n<p>";
    if (all.all > 0) {
        html += "Ours beside theirs: " + std::to_string(all.agree) + " of " +
                std::to_string(all.all) +
                " printed numbers agree within their bands. Those that do not stand here with what "
                "is known of why. ";
    }
    html += "Made by <code>" + escaped(page.command) + "</code>, " + escaped(page.tool) + ".</p>\n";
    if (page.quick) {
        html +=
            "<p class=\"no\">Made in a hurry (--quick): smaller pictures and fewer trials, so "
            "that measured numbers are off.</p>\n";
    }
    html += "</header>\n<main>\n<nav aria-label=\"Entries\">" + contents_html(page.entries) +
            "</nav>\n";
    for (const PageContent& entry : page.entries) {
        html += "<section id=\"" + entry.name + "\"><h2>" + entry.name + "</h2>\n<p>" +
                inline_html(entry.shows) + ".</p>\n<p class=\"quiet\">" + escaped(entry.paper) +
                ".</p>\n";
        for (std::size_t i = 0; i < entry.blocks.size(); ++i) html += block_html(entry, i);
        html += "</section>\n";
    }
    return html + "</main>\n</body>\n</html>\n";
}

}  // namespace sheer
