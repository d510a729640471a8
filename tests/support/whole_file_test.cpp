// Files appear whole or not at all, failures say why, and nothing else is left in the folder.
#include "support/whole_file.h"

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sheer/error.h>

#include "test_folder.h"

namespace sheer {
namespace {

namespace fs = std::filesystem;

void write_text(const std::string& path, const std::string& text)
{
    write_whole_file(path, bytes_of(text));
}

void expect_error(Fault fault, const std::string& text, const std::function<void()>& action)
{
    try {
        action();
        ADD_FAILURE() << "no error; expected: " << text;
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), text);
        EXPECT_EQ(error.fault(), fault) << text;
    }
}

// Both functions say the same.
void expect_refused(const std::string& path, const std::string& reason)
{
    expect_error(Fault::work, path + ": " + reason, [&] { write_text(path, "text"); });
    expect_error(Fault::input, path + ": " + reason, [&] { check_writable(path); });
}

TEST(WholeFile, IsWritten)
{
    const TestFolder folder;
    const std::string large(3'000'000, 'x');
    for (const std::string& text : {std::string("text"), std::string(), large}) {
        write_text(folder.file("a"), text);
        EXPECT_EQ(text_of(folder.file("a")), text);
        EXPECT_EQ(folder.entries(), 1);
    }
}

TEST(WholeFile, KeepsPermissionsOfTheFileItReplaces)
{
    const TestFolder folder;
    const std::string path = folder.file("a");
    write_text(path, "old");
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
    write_text(path, "new");
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(text_of(path), "new");
}

TEST(WholeFile, FollowsSymbolicLinks)
{
    const TestFolder folder;
    fs::create_directory(folder.file("inner"));
    write_text(folder.file("inner/a"), "old");
    fs::create_symlink("inner/a", folder.file("link"));
    write_text(folder.file("link"), "new");
    EXPECT_TRUE(fs::is_symlink(folder.file("link")));
    EXPECT_EQ(text_of(folder.file("inner/a")), "new");
}

TEST(WholeFile, TakesNamesAsLongAsTheyCanBe)
{
    const TestFolder folder;
    write_text(folder.file(std::string(255, 'n')), "text");
    EXPECT_EQ(folder.entries(), 1);
    expect_refused(folder.file(std::string(256, 'n')), "File name too long");
}

TEST(WholeFile, SaysWhatIsWrongWithThePath)
{
    const TestFolder folder;
    write_text(folder.file("file"), "text");
    const std::string missing = folder.file("missing");
    expect_refused(missing + "/a", "the directory '" + missing + "' does not exist");
    expect_refused(folder.file("file/a"), "'" + folder.file("file") + "' is not a directory");
    expect_refused(folder.file("file/a/b"),
                   "a part of '" + folder.file("file/a") + "' is not a directory");
    expect_refused(folder.path(), "is a directory");
    expect_refused(folder.file("new/"), "names a directory, not a file");
    expect_refused("", "the file name is empty");
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_EQ(text_of(folder.file("file")), "text");
}

TEST(WholeFile, RespectsPermissions)
{
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const TestFolder folder;
    write_text(folder.file("a"), "text");
    fs::permissions(folder.file("a"), fs::perms::owner_read);
    expect_refused(folder.file("a"), "Permission denied");
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    expect_refused(folder.file("b"), "Permission denied");
    fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(WholeFile, NoticesFoldersThatTakeNoFiles)
{
    if (!fs::exists("/proc/self")) GTEST_SKIP() << "no /proc";
    EXPECT_THROW(check_writable("/proc/a"), Error);
    EXPECT_THROW(write_text("/proc/a", "text"), Error);
}

TEST(WholeFile, CheckLeavesEverythingAsItIs)
{
    const TestFolder folder;
    check_writable(folder.file("a"));
    EXPECT_EQ(folder.entries(), 0);
    write_text(folder.file("a"), "text");
    check_writable(folder.file("a"));
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_EQ(text_of(folder.file("a")), "text");
}

TEST(WholeFile, ReportsFullDevices)
{
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    check_writable("/dev/full");
    expect_error(Fault::work, "/dev/full: No space left on device",
                 [] { write_text("/dev/full", "text"); });
    write_text("/dev/null", "text");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

// The limit on a file's size stands in for a disk that fills up half way.
TEST(WholeFile, KeepsTheOldFileWhenTheDiskFillsUp)
{
    const TestFolder folder;
    write_text(folder.file("a"), "old");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 1000;
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const auto write = [&] { write_text(folder.file("a"), std::string(5000, 'x')); };
    expect_error(Fault::work, folder.file("a") + ": File too large", write);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, SIG_DFL);
    EXPECT_EQ(text_of(folder.file("a")), "old");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WholeFile, WritesIntoFifos)
{
    const TestFolder folder;
    const std::string path = folder.file("fifo");
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    check_writable(path);  // would wait for ever, did it open the fifo
    std::string read;
    std::thread reader([&] { read = text_of(path); });
    write_text(path, "text");
    reader.join();
    EXPECT_EQ(read, "text");
    EXPECT_TRUE(fs::is_fifo(path));
}

// Runs the action in a process of its own.
pid_t start(const std::function<void()>& action)
{
    const pid_t child = fork();
    if (child != 0) return child;
    action();
    _exit(0);
}

TEST(WholeFile, AppendsToItsOwnStandardOutput)
{
    const TestFolder folder;
    const std::string path = folder.file("out");
    write_text(path, "before ");
    const pid_t child = start([&] {
        dup2(open(path.c_str(), O_WRONLY | O_APPEND), STDOUT_FILENO);
        write_text("/dev/stdout", "after");
    });
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(text_of(path), "before after");
}

TEST(WholeFile, LeavesNothingBehindWhenInterrupted)
{
    const TestFolder folder;
    const std::string text(100'000, 'x');
    write_text(folder.file("a"), text);
    for (int i = 0; i < 30; ++i) {
        const pid_t child = start([&] {
            for (;;) write_text(folder.file("a"), text);
        });
        usleep(static_cast<useconds_t>(1000 + 317 * i));
        kill(child, SIGTERM);
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status));
        ASSERT_EQ(folder.entries(), 1);
        ASSERT_EQ(text_of(folder.file("a")), text);
    }
}

}  // namespace
}  // namespace sheer
