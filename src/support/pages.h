// Memory by whole pages of the system, to which it returns when it is freed. An allocator may keep
// what is freed, so that a limit of memory is not kept by freeing. Pages cost nothing before they
// are used.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <vector>

namespace sheer {

// Of small pieces, those of operator new. For any number of threads; lives as long as the program.
std::pmr::memory_resource& page_memory();

// For whoever may take so many bytes: pages, or if there is no bound (the largest number) what
// operator new gives.
std::pmr::memory_resource* memory_within(std::size_t most_bytes);

// Frees what the vector has, in the memory that it was made with.
template <class T>
void give_back(std::pmr::vector<T>& values)
{
    std::pmr::vector<T>(values.get_allocator()).swap(values);
}

}  // namespace sheer
