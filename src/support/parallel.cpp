// parallel_for: one atomic counter hands out the indices. Pieces of work (tiles, chunks of
// triangles) are large enough that nothing cleverer pays.
#include "support/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace sheer {
namespace {

class Loop {
public:
    Loop(std::size_t count, const std::function<void(std::size_t, int)>& body)
        : count_(count), body_(body)
    {
    }

    void work(int thread)
    {
        while (!failed_.load(std::memory_order_relaxed)) {
            const std::size_t index = next_.fetch_add(1, std::memory_order_relaxed);
            if (index >= count_) return;
            try {
                body_(index, thread);
            } catch (...) {
                keep_first(index, std::current_exception());
            }
        }
    }

    // After all threads have ended.
    void rethrow() const
    {
        if (first_) std::rethrow_exception(first_);
    }

private:
    // Indices below a failed one were handed out before it, so the smallest failing index always
    // comes to run and the outcome does not depend on timing.
    void keep_first(std::size_t index, std::exception_ptr exception)
    {
        const std::lock_guard lock(mutex_);
        if (!first_ || index < first_index_) {
            first_ = std::move(exception);
            first_index_ = index;
        }
        failed_.store(true, std::memory_order_relaxed);
    }

    const std::size_t count_;
    const std::function<void(std::size_t, int)>& body_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> failed_{false};
    std::mutex mutex_;  // guards what follows
    std::exception_ptr first_;
    std::size_t first_index_ = 0;
};

}  // namespace

int hardware_threads()
{
    return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

void parallel_for(int threads, std::size_t count,
                  const std::function<void(std::size_t index, int thread)>& body)
{
    const std::size_t wanted = std::min(static_cast<std::size_t>(std::max(threads, 1)), count);
    Loop loop(count, body);
    {
        std::vector<std::jthread> others;
        others.reserve(wanted);
        try {
            for (std::size_t i = 1; i < wanted; ++i) {
                others.emplace_back([&loop, i] { loop.work(static_cast<int>(i)); });
            }
        } catch (const std::system_error&) {
            // The system gives no more threads; those there are do all the work.
        }
        loop.work(0);
    }
    loop.rethrow();
}

}  // namespace sheer
