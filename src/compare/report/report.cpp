// Data into the page.
#include "compare/report/report.h"

#include <cstdint>

namespace sheer {

namespace {

// RFC 4648, section 4.
std::string base64(std::span<const std::byte> bytes)
{
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits = bits << 8 |
                   (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const bool beyond = i + k > bytes.size();  // k digits need k bytes, but the first none
            text += beyond ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
        }
    }
    return text;
}

// Names come out of files: nothing of them may end the element that the data stand in.
std::string without_markup(const std::string& json)
{
    std::string text;
    text.reserve(json.size());
    for (const char c : json) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

}  // namespace

std::string report_html(const nlohmann::ordered_json& data)
{
    constexpr std::string_view kPlace = "@DATA@";
    const std::string_view page = report_page();
    const std::size_t place = page.find(kPlace);
    std::string text(page.substr(0, place));
    text +=
        without_markup(data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    text += page.substr(place + kPlace.size());
    return text;
}

std::string data_address(std::string_view kind, std::span<const std::byte> bytes)
{
    return "data:" + std::string(kind) + ";base64," + base64(bytes);
}

std::string png_address(std::span<const std::byte> png)
{
    return data_address("image/png", png);
}

}  // namespace sheer
