// Paths are compared part by part, once all links in them are followed.
#include "support/lies_below.h"

#include <algorithm>
#include <system_error>

namespace sheer {

bool lies_below(const std::filesystem::path& folder, const std::filesystem::path& path)
{
    std::error_code fault;
    const auto from = weakly_canonical(absolute(folder.empty() ? "." : folder), fault);
    if (fault) return false;
    const auto to = weakly_canonical(absolute(path), fault);
    if (fault) return false;
    return std::mismatch(from.begin(), from.end(), to.begin(), to.end()).first == from.end();
}

}  // namespace sheer
