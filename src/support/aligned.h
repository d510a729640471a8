// Arrays that start on a cache line and whose elements start as zeros, if not asked for unwritten.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace sheer {

// Asks for elements that are to be written before they are read: large arrays then cost no more
// than what of them is used.
struct Unwritten {};

template <class T>
class AlignedArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    AlignedArray() = default;
    AlignedArray(AlignedArray&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0))
    {
    }
    AlignedArray& operator=(AlignedArray other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        return *this;
    }
    ~AlignedArray() { ::operator delete(data_, kAlignment); }
    explicit AlignedArray(int size) : AlignedArray(static_cast<std::size_t>(size)) {}
    explicit AlignedArray(std::size_t size) : AlignedArray(size, Unwritten{})
    {
        std::uninitialized_value_construct_n(data_, size);
    }
    AlignedArray(std::size_t size, Unwritten)
        : data_(static_cast<T*>(::operator new(size * sizeof(T), kAlignment))), size_(size)
    {
    }

    T* data() { return data_; }
    const T* data() const { return data_; }
    std::size_t size() const { return size_; }
    template <class Index>
    T& operator[](Index i)
    {
        return data_[i];
    }
    template <class Index>
    const T& operator[](Index i) const
    {
        return data_[i];
    }

private:
    static constexpr std::align_val_t kAlignment{64};
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace sheer
