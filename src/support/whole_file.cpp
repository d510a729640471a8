// Writing a file whole: a temporary file in the same folder, fsync, rename. POSIX promises that
// rename replaces its target in one step, within one file system; hence the same folder.
#include "support/whole_file.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sheer/error.h>

namespace sheer {
namespace {

std::string reason_of(int error)
{
    return std::generic_category().message(error);
}

// A signal that would end the program waits until the temporary file has become the real one or is
// gone. Only for the calling thread: while a command line tool writes its result there is no other.
class SignalsHeld {
public:
    SignalsHeld()
    {
        sigset_t held;
        sigemptyset(&held);
        for (const int signal : {SIGHUP, SIGINT, SIGTERM}) sigaddset(&held, signal);
        pthread_sigmask(SIG_BLOCK, &held, &before_);
    }
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

private:
    sigset_t before_;
};

// Where the bytes go.
struct Target {
    std::string path;    // symbolic links followed
    std::string folder;  // of path
    bool exists = false;
    bool direct = false;  // not by a temporary file
    mode_t mode = 0;
};

bool same_file(const struct stat& a, const struct stat& b)
{
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

bool is_standard_output(const struct stat& file)
{
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
        struct stat open_file;
        if (fstat(descriptor, &open_file) == 0 && same_file(file, open_file)) return true;
    }
    return false;
}

// These return what is wrong, or nothing.

std::string find_folder(const std::string& folder)
{
    struct stat status;
    if (stat(folder.c_str(), &status) == 0) {
        return S_ISDIR(status.st_mode) ? "" : "'" + folder + "' is not a directory";
    }
    if (errno == ENOENT) return "the directory '" + folder + "' does not exist";
    if (errno == ENOTDIR) return "a part of '" + folder + "' is not a directory";
    return reason_of(errno);
}

std::string find_target(const std::string& path, Target& target)
{
    if (path.empty()) return "the file name is empty";
    target.path = path;
    struct stat status;
    if (stat(path.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) return "is a directory";
        if (access(path.c_str(), W_OK) != 0) return reason_of(errno);
        target.exists = true;
        target.direct = !S_ISREG(status.st_mode) || is_standard_output(status);
        target.mode = status.st_mode & 07777;
        std::error_code none;
        const std::filesystem::path real = std::filesystem::canonical(path, none);
        if (!none) target.path = real.string();
    } else if (errno != ENOENT && errno != ENOTDIR) {
        return reason_of(errno);
    }
    if (path.back() == '/') return "names a directory, not a file";
    const std::filesystem::path folder = std::filesystem::path(target.path).parent_path();
    target.folder = folder.empty() ? "." : folder.string();
    return target.direct ? "" : find_folder(target.folder);
}

// A new file in the folder, or -1 and errno. The name does not depend on the target's, which may be
// as long as a name can be.
int create_temporary(const std::string& folder, std::string& name)
{
    static std::atomic<unsigned> counter{0};
    for (;;) {
        name = folder + "/.sheer-" + std::to_string(getpid()) + "-" + std::to_string(counter++) +
               ".tmp";
        const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST) return file;
    }
}

// These return errno, 0 if all is well.

int write_all(int file, std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = write(file, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) return errno;
        if (written > 0) bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

int write_and_close(int file, std::span<const std::byte> bytes, const Target& target)
{
    int error = write_all(file, bytes);
    if (!target.direct) {
        if (error == 0 && target.exists && fchmod(file, target.mode) != 0) error = errno;
        // Some file systems have no fsync and say so with EINVAL.
        if (error == 0 && fsync(file) != 0 && errno != EINVAL) error = errno;
    }
    // Full disks and exceeded quotas of network file systems may only show here.
    if (close(file) != 0 && error == 0 && errno != EINTR) error = errno;
    return error;
}

int write_directly(const Target& target, std::span<const std::byte> bytes)
{
    // Standard output may be a file that holds something already.
    const int file = open(target.path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    return file < 0 ? errno : write_and_close(file, bytes, target);
}

int write_beside(const Target& target, std::span<const std::byte> bytes)
{
    const SignalsHeld held;
    std::string temporary;
    const int file = create_temporary(target.folder, temporary);
    if (file < 0) return errno;
    int error = write_and_close(file, bytes, target);
    if (error == 0 && std::rename(temporary.c_str(), target.path.c_str()) != 0) error = errno;
    if (error != 0) unlink(temporary.c_str());
    return error;
}

}  // namespace

void write_whole_file(const std::string& path, std::span<const std::byte> bytes)
{
    Target target;
    std::string trouble = find_target(path, target);
    if (trouble.empty()) {
        const int error =
            target.direct ? write_directly(target, bytes) : write_beside(target, bytes);
        if (error != 0) trouble = reason_of(error);
    }
    if (!trouble.empty()) throw Error(Fault::work, path + ": " + trouble);
}

void check_writable(const std::string& path)
{
    Target target;
    std::string trouble = find_target(path, target);
    if (trouble.empty() && !target.direct) {
        // Only an attempt tells: permissions do not bind root, nor do they show read-only disks.
        const SignalsHeld held;
        std::string temporary;
        const int file = create_temporary(target.folder, temporary);
        if (file < 0) {
            trouble = reason_of(errno);
        } else {
            close(file);
            unlink(temporary.c_str());
        }
    }
    if (!trouble.empty()) throw Error(Fault::input, path + ": " + trouble);
}

}  // namespace sheer
