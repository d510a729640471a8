// Words and numbers of a text file, line by line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "support/read_file.h"

namespace sheer {

inline std::string_view as_text(const Bytes& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// What a line that ends with a backslash means.
enum class LineJoin { none, backslash };

class TextScanner {
public:
    // `text` must outlive the scanner; `path` is for messages, and so is how many lines of the file
    // come before the text. Fails where the text is UTF-16.
    TextScanner(std::string path, std::string_view text, LineJoin join = LineJoin::none,
                std::size_t lines_before = 0);

    // Goes to the start of the next line; false at the end of the text. A line ends with a line
    // feed, or a carriage return and one; in texts without any line feed, with a carriage return.
    bool next_line();

    // The next word of the line; empty at its end.
    std::string_view word();

    // What is left of the line, without blanks around it.
    std::string_view rest();

    // The next word as a number. Fails where it is none, is not finite or leaves the floats.
    float number() { return to_number(word()); }
    float to_number(std::string_view word) const;
    // The same, but it may be infinite or "nan".
    float to_any_number(std::string_view word) const;
    double to_double(std::string_view word) const;

    // The next word as a whole number that is not negative.
    std::uint64_t whole();

    std::size_t next_line_offset() const { return next_; }  // from the start of the text
    std::size_t bytes_left() const { return text_.size() - at_; }
    std::size_t line_number() const { return line_number_; }

    // Throws Error with Fault::input, "<path>: line <number>: <what>".
    [[noreturn]] void fail(const std::string& what) const;
    // The same about a word: "'<word>' <what>".
    [[noreturn]] void fail(std::string_view word, const std::string& what) const;

private:
    void skip_blanks();
    [[noreturn]] void refuse(std::string_view word) const;  // as a number

    std::string path_;
    std::string_view text_;
    LineJoin join_;
    char end_ = '\n';
    std::size_t at_ = 0, line_end_ = 0, next_ = 0;
    std::size_t line_number_ = 0;
    bool joined_ = false;  // the next line continues this one
};

}  // namespace sheer
