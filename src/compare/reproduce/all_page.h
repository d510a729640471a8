// Entries of `sheer reproduce` on one page.
#pragma once

#include <string>
#include <vector>

#include "compare/reproduce/page.h"

namespace sheer {

struct AllPage {
    const std::vector<PageContent>& entries;
    std::string tool, command;  // that made it
    bool quick;
};

// HTML that needs nothing else: pictures and charts, which are read from the entries' folders, are
// in it.
std::string all_page_html(const AllPage& page);

}  // namespace sheer
