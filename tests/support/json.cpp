#include "support/json.h"

#include <ostream>

template class nlohmann::basic_json<>;

namespace nlohmann {

void PrintTo(const json& value, std::ostream* to)
{
    *to << value.dump();
}

}  // namespace nlohmann

namespace sheer::test {

Json parse_json(const std::string& text)
{
    return Json::parse(text);
}

}  // namespace sheer::test
