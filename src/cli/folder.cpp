// By std::filesystem, with a line that names the folder.
#include "cli/folder.h"

#include <filesystem>
#include <system_error>

#include <sheer/error.h>

namespace sheer {

void make_folder(const std::string& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder)) {
        throw Error(Fault::input,
                    folder + ": can't be made a folder" + (error ? ": " + error.message() : ""));
    }
}

}  // namespace sheer
