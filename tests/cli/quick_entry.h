// A quick run of one entry of `sheer reproduce`, and its numbers.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cli/run_tool.h"
#include "support/json.h"

namespace sheer::test {

inline Json reproduce(const Tool& tool, const std::string& name)
{
    const Outcome outcome = tool.run({"reproduce", name, "--quick", "-o", "out/deep"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "out/deep/" + name + ".md\nout/deep/index.html\n");
    EXPECT_TRUE(text_of(tool.file("out/deep/" + name + ".md")).starts_with("# " + name + "\n"));
    const Json json = parse_json(text_of(tool.file("out/deep/" + name + ".json")));
    EXPECT_EQ(json["name"], name);
    EXPECT_EQ(json["quick"], true);
    for (const Json& picture : json["pictures"]) {
        const std::string file = tool.file("out/deep/" + picture["file"].get<std::string>());
        EXPECT_GT(text_of(file).size(), 0u) << file;
    }
    return json;
}

}  // namespace sheer::test
