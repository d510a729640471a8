// Runs the tool as a shell would, in a folder of the test's own, and keeps what it said.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/test_folder.h"

namespace sheer::test {

struct Outcome {
    int exit_code = -1;  // -1: ended by a signal
    std::string out, err;
    // Bytes; at least what the test itself had, since it begins as a copy of it.
    std::uint64_t peak_memory = 0;
};

// What is unusual about a run.
struct Circumstances {
    std::string standard_output = {};  // a file that exists; else what is written there is kept
    bool closed_output = false;
    long file_size_limit = -1;  // bytes; a disk that fills up
};

class Tool {
public:
    Outcome run(const std::vector<std::string>& arguments, const Circumstances& how = {}) const
    {
        const pid_t child = fork();
        if (child < 0) throw std::runtime_error("fork failed");
        if (child == 0) become_tool(arguments, how);
        int status = 0;
        rusage usage{};
        wait4(child, &status, 0, &usage);
        Outcome outcome;
#ifdef __APPLE__
        constexpr std::uint64_t kUnit = 1;
#else
        constexpr std::uint64_t kUnit = 1024;
#endif
        outcome.peak_memory = static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
        if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
        outcome.out = text_of(logs_.file("out"));
        outcome.err = text_of(logs_.file("err"));
        return outcome;
    }

    // A path in the folder that the tool runs in, which starts empty.
    std::string file(const std::string& name) const
    {
        return folder_.file(name);
    }
    const TestFolder& folder() const
    {
        return folder_;
    }

private:
    [[noreturn]] void become_tool(const std::vector<std::string>& arguments,
                                  const Circumstances& how) const
    {
        constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC;
        std::vector<char*> argv;
        std::vector<std::string> words = arguments;
        words.insert(words.begin(), SHEER_TOOL);
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);

        dup2(open(logs_.file("err").c_str(), kNew, 0600), STDERR_FILENO);
        dup2(open(logs_.file("out").c_str(), kNew, 0600), STDOUT_FILENO);
        if (!how.standard_output.empty()) {
            dup2(open(how.standard_output.c_str(), O_WRONLY), STDOUT_FILENO);
        }
        if (how.closed_output) close(STDOUT_FILENO);
        if (how.file_size_limit >= 0) {
            const auto bytes = static_cast<rlim_t>(how.file_size_limit);
            const rlimit limit{bytes, bytes};
            setrlimit(RLIMIT_FSIZE, &limit);
        }
        if (chdir(folder_.path().c_str()) == 0) execv(argv[0], argv.data());
        _exit(127);
    }

    TestFolder folder_, logs_;
};

}  // namespace sheer::test
