// SPDX-License-Identifier: MIT
/// Tells texts apart: a file that was cut short or garbled from a whole one, say.
#pragma once

#include <cstdint>
#include <string_view>

namespace nmbcgen {

inline constexpr std::uint64_t checksum_of_nothing = 0xcbf29ce484222325;

/// FNV-1a, 64 bits: of the bytes so far, followed by these.
constexpr std::uint64_t checksum(std::string_view bytes,
                                 std::uint64_t so_far = checksum_of_nothing) {
    for (const char byte : bytes) {
        so_far = (so_far ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    }
    return so_far;
}

}  // namespace nmbcgen
