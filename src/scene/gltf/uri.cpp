// URIs of buffers and images (glTF 2.0, section 2.8; RFC 2397 for data URIs, RFC 3986 for the
// rest).
//
// Writers differ in whether they percent-encode file names, so a name that does not exist decoded
// is tried as it stands.

#include "scene/gltf/uri.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <sheer/error.h>

#include "support/lies_below.h"
#include "support/text.h"

namespace sheer::gltf {

namespace {

constexpr int kNotADigit = -1;

int hex_digit(char c)
{
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return kNotADigit;
}

// A percent sign without two digits behind it stands for itself.
std::string percent_decode(std::string_view text)
{
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool may_be_escape = text[i] == '%' && i + 2 < text.size();
        const int high = may_be_escape ? hex_digit(text[i + 1]) : kNotADigit;
        const int low = may_be_escape ? hex_digit(text[i + 2]) : kNotADigit;
        if (high == kNotADigit || low == kNotADigit) {
            decoded += text[i];
        } else {
            decoded += static_cast<char>(high * 16 + low);
            i += 2;
        }
    }
    return decoded;
}

std::array<std::int8_t, 256> make_base64_digits()
{
    constexpr std::string_view kAlphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<std::int8_t, 256> digits;
    digits.fill(kNotADigit);
    for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
        digits[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::int8_t>(i);
    }
    return digits;
}

Bytes decode_base64(const Value& uri, std::string_view text)
{
    static const std::array<std::int8_t, 256> digits = make_base64_digits();
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
    if (text.size() % 4 == 1) uri.fail("the base64 data is cut off");
    Bytes bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;  // the last digits, of which `pending` bits are not written yet
    int pending = 0;
    for (const char c : text) {
        const std::int8_t digit = digits[static_cast<unsigned char>(c)];
        if (digit == kNotADigit) uri.fail("the base64 data holds a character that is not base64");
        bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFFu;
        pending += 6;
        if (pending >= 8) {
            pending -= 8;
            bytes.push_back(static_cast<std::uint8_t>(bits >> pending & 0xFFu));
        }
    }
    return bytes;
}

// The scheme of RFC 3986 in front of the colon, or nothing. One letter is a drive, not a scheme.
std::string_view scheme_of(std::string_view uri)
{
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::size_t end = 0;
    while (end < uri.size() && (is_letter(uri[end]) || (uri[end] >= '0' && uri[end] <= '9') ||
                                uri[end] == '+' || uri[end] == '-' || uri[end] == '.')) {
        ++end;
    }
    const bool is_scheme = end > 1 && end < uri.size() && uri[end] == ':' && is_letter(uri[0]);
    return is_scheme ? uri.substr(0, end) : std::string_view();
}

}  // namespace

bool is_data_uri(std::string_view uri)
{
    constexpr std::string_view kScheme = "data:";
    const auto is_same = [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    };
    return uri.size() >= kScheme.size() &&
           std::equal(uri.begin(), uri.begin() + kScheme.size(), kScheme.begin(), is_same);
}

Bytes decode_data_uri(const Value& uri)
{
    const std::string_view text = uri.text();
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) uri.fail("the data URI has no comma before its data");
    const std::string_view data = text.substr(comma + 1);
    if (text.substr(0, comma).ends_with(";base64")) return decode_base64(uri, data);
    const std::string decoded = percent_decode(data);
    return Bytes(decoded.begin(), decoded.end());
}

std::string path_of_uri(const Value& uri, const std::string& base, bool anywhere)
{
    namespace fs = std::filesystem;
    const std::string& text = uri.text();
    if (text.empty()) uri.fail("must not be empty");
    if (const std::string_view scheme = scheme_of(text); !scheme.empty()) {
        uri.fail(std::string(scheme.substr(0, 40)) +
                 ": addresses are not read, only files and data URIs are");
    }
    const fs::path folder = fs::path(base).parent_path();
    const std::string decoded = percent_decode(text);
    if (decoded.find('\0') != std::string::npos) uri.fail("a path cannot hold a zero byte");
    const fs::path as_decoded = folder / decoded;
    const fs::path as_written = folder / text;
    std::error_code ignored, fault;
    const bool is_there = fs::exists(as_decoded, fault);
    if (fault == std::errc::filename_too_long) {
        uri.fail("\"" + in_one_line(text, 80) + "...\" is too long for a file's name");
    }
    const bool only_as_written = !is_there && fs::exists(as_written, ignored);
    const fs::path& path = only_as_written ? as_written : as_decoded;
    if (!anywhere && !lies_below(folder, path)) {
        uri.fail("\"" + in_one_line(text, 80) +
                 "\" is outside of the scene's folder (--allow-any-file lets it be read)");
    }
    return path.string();
}

Bytes read_referenced_file(const Value& uri, const std::string& path)
{
    try {
        return read_file(path);
    } catch (const Error& e) {
        uri.fail(e.what());
    }
}

}  // namespace sheer::gltf
