// One HTML file with everything that `compare` found: it works from disk, offline.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace sheer {

// The page without its data, as the build put it together of web/ (cmake/report_page.cmake).
std::string_view report_page();

// The page with them. What the data must hold, web/report/data.js says by using it.
std::string report_html(const nlohmann::ordered_json& data);

// "data:image/png;base64,...", or of another kind of file.
std::string data_address(std::string_view kind, std::span<const std::byte> bytes);
std::string png_address(std::span<const std::byte> png);

}  // namespace sheer
