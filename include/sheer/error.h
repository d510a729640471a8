// The one exception that leaves the library, besides those that a caller's own functions throw. Its
// text is one line that names the file or the argument and what is wrong with it.
#pragma once

#include <stdexcept>
#include <string>

namespace sheer {

enum class Fault {
    input,  // the command, an argument or a file is wrong: exit code 2
    work,   // the work failed: a full disk, no memory: exit code 1
};

class Error : public std::runtime_error {
public:
    Error(Fault fault, const std::string& text) : std::runtime_error(text), fault_(fault) {}
    Fault fault() const { return fault_; }

private:
    Fault fault_;
};

}  // namespace sheer
