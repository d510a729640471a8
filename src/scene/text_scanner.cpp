// Numbers are read by std::from_chars: fast, exact, and without regard to the machine's language.
#include "scene/text_scanner.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "scene/mesh_files.h"

namespace sheer {

namespace {

constexpr bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// from_chars takes no plus.
std::string_view without_plus(std::string_view word)
{
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    return word;
}

template <class T>
std::errc parse(std::string_view word, T& value)
{
    const std::string_view digits = without_plus(word);
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    return error == std::errc() && stop != end ? std::errc::invalid_argument : error;
}

}  // namespace

TextScanner::TextScanner(std::string path, std::string_view text, LineJoin join,
                         std::size_t lines_before)
    : path_(std::move(path)), text_(text), join_(join), line_number_(lines_before)
{
    if (text_.starts_with("\xfe\xff") || text_.starts_with("\xff\xfe")) {
        fail_in_file(path_, "UTF-16 text is not supported, only UTF-8 is");
    }
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    if (text_.find('\n') == std::string_view::npos) end_ = '\r';
}

bool TextScanner::next_line()
{
    do {
        if (next_ >= text_.size()) return false;
        const std::size_t feed = text_.find(end_, next_);
        at_ = next_;
        line_end_ = feed == std::string_view::npos ? text_.size() : feed;
        next_ = line_end_ + (feed != std::string_view::npos);
        if (line_end_ > at_ && text_[line_end_ - 1] == '\r') --line_end_;
        ++line_number_;
        const bool continues = std::exchange(joined_, false);
        if (join_ == LineJoin::backslash && line_end_ > at_ && text_[line_end_ - 1] == '\\') {
            joined_ = true;
            --line_end_;
        }
        if (!continues) break;
    } while (true);
    return true;
}

void TextScanner::skip_blanks()
{
    while (at_ < line_end_ && is_blank(text_[at_])) ++at_;
}

std::string_view TextScanner::word()
{
    skip_blanks();
    while (at_ == line_end_ && joined_) {
        joined_ = false;
        if (!next_line()) break;
        skip_blanks();
    }
    const std::size_t start = at_;
    while (at_ < line_end_ && !is_blank(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
}

std::string_view TextScanner::rest()
{
    skip_blanks();
    std::size_t end = line_end_;
    while (end > at_ && is_blank(text_[end - 1])) --end;
    const std::string_view text = text_.substr(at_, end - at_);
    at_ = line_end_;
    return text;
}

void TextScanner::refuse(std::string_view word) const
{
    if (word.empty()) fail("a number is missing");
    fail(word, "is not a number");
}

float TextScanner::to_any_number(std::string_view word) const
{
    float value = 0;
    const std::errc error = parse(word, value);
    // Below the smallest float as well as above the largest one.
    if (error == std::errc::result_out_of_range) value = static_cast<float>(to_double(word));
    if (error == std::errc::invalid_argument) refuse(word);
    return value;
}

float TextScanner::to_number(std::string_view word) const
{
    const float value = to_any_number(word);
    if (!std::isfinite(value)) fail(word, "is not a finite number");
    return value;
}

double TextScanner::to_double(std::string_view word) const
{
    double value = 0;
    const std::errc error = parse(word, value);
    if (error == std::errc::invalid_argument) refuse(word);
    if (error != std::errc()) fail(word, "is too large or too small a number");
    return value;
}

std::uint64_t TextScanner::whole()
{
    const std::string_view text = word();
    std::uint64_t value = 0;
    if (parse(text, value) != std::errc()) fail(text, "is not a whole number");
    return value;
}

void TextScanner::fail(const std::string& what) const
{
    fail_in_file(path_, "line " + std::to_string(line_number_) + ": " + what);
}

void TextScanner::fail(std::string_view word, const std::string& what) const
{
    constexpr std::size_t kMostShown = 40;
    std::string shown(word.substr(0, kMostShown));
    for (char& c : shown) c = static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? '?' : c;
    fail("'" + shown + (word.size() > kMostShown ? "...' " : "' ") + what);
}

}  // namespace sheer
