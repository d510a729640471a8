// A loop over independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace sheer {

// That this process may use, at least 1.
int hardware_threads();

// Calls body(index, thread) once for each index in [0, count), thread in [0, threads) telling the
// threads apart. Indices are handed out in order, the calling thread works too, and with one thread
// all runs on it. When a body throws, no further index is handed out, those under way finish, and
// the exception of the smallest index is rethrown: the same one whatever the number of threads.
void parallel_for(int threads, std::size_t count,
                  const std::function<void(std::size_t index, int thread)>& body);

}  // namespace sheer
