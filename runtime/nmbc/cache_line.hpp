// SPDX-License-Identifier: MIT
/// Memory that begins at a cache line.
#pragma once

#include <cstddef>
#include <new>

namespace nmbc::detail {

/// Bytes. The length of the widest vectors, too, whose loads take twice as long across two lines.
inline constexpr std::size_t cache_line = 64;

/// Of a std::vector.
template <class Value>
struct CacheLineAllocator {
    using value_type = Value;  // NOLINT(readability-identifier-naming): the standard's name

    CacheLineAllocator() = default;
    template <class Other>
    explicit(false) CacheLineAllocator(const CacheLineAllocator<Other>& /*other*/) {}

    static Value* allocate(std::size_t count) {
        return static_cast<Value*>(
            ::operator new (count * sizeof(Value), std::align_val_t{cache_line}));
    }
    static void deallocate(Value* values, std::size_t /*count*/) {
        ::operator delete (values, std::align_val_t{cache_line});
    }
    friend bool operator==(const CacheLineAllocator& /*one*/, const CacheLineAllocator& /*other*/) {
        return true;
    }
};

}  // namespace nmbc::detail
