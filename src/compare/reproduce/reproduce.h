// The papers' tables and figures, ours beside theirs: `sheer reproduce`.
#pragma once

#include <functional>
#include <span>
#include <string>

#include <sheer/render.h>

namespace sheer {

struct PageContent;

struct ReproduceJob {
    std::string folder;                    // for results; exists
    std::string scenes;                    // a folder of scene files; empty: none
    bool quick = false;                    // smaller pictures, fewer trials: to see that it works
    Options options;                       // threads and simd count
    std::function<void(double)> progress;  // with the part done, in [0, 1]
    // Gets what an entry has written; may be empty.
    std::function<void(const PageContent&)> done = {};
};

// A scene that an entry draws.
struct EntryScene {
    const char* name;  // in files' names and tables
    const char* source;
    const char* quick_source;

    const char* of(const ReproduceJob& job) const { return job.quick ? quick_source : source; }
};

// Writes NAME.md, the tables as one reads them, NAME.json, the same with all digits, and what
// pictures belong to it. Throws Error as `render` and `write_image` do.
struct ReproduceEntry {
    const char* name;
    const char* paper;
    const char* shows;  // one line
    void (*run)(const ReproduceEntry&, const ReproduceJob&);
};

std::span<const ReproduceEntry> reproduce_entries();

// Throws Error(Fault::input) when there is none of that name.
const ReproduceEntry& find_reproduce_entry(const std::string& name);

}  // namespace sheer
