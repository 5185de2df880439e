// SPDX-License-Identifier: MIT
#include "generator/names/printable.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace nmbcgen {

namespace {

/// Bytes of the letter that the text begins with; 0 where that is no UTF-8, or of a surrogate.
std::size_t size_of_letter(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const unsigned first = byte(0);
    const std::size_t size = first < 0x80                    ? 1
                             : first >= 0xc2 && first < 0xe0 ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) {
            return 0;
        }
    }
    const bool is_short_or_beyond =
        (first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) >= 0xa0) ||
        (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) >= 0x90);
    return is_short_or_beyond ? 0 : size;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const auto byte = static_cast<unsigned char>(text[0]);
        const std::size_t size = size_of_letter(text);
        if (size == 0 || byte < 0x20 || byte == 0x7f) {
            result += fmt::format("\\x{:02x}", byte);
        } else if (size == 2 && byte == 0xc2 && static_cast<unsigned char>(text[1]) < 0xa0) {
            result += fmt::format("\\u00{:02x}", static_cast<unsigned char>(text[1]));
        } else {
            result += text.substr(0, size);
        }
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return result;
}

std::string printable_lines(std::string_view text) {
    std::string result;
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
        result += printable(text.substr(0, end)) + "\n";
        text.remove_prefix(end + 1);
    }
    return result + printable(text);
}

std::string beginning_of(const std::string& text) {
    constexpr std::size_t longest = 60;
    if (text.size() <= longest) {
        return text;
    }
    std::size_t size = longest;  // of whole letters: no byte 10xxxxxx is the next one
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0U) == 0x80U) {
        --size;
    }
    return text.substr(0, size) + "..";
}

}  // namespace nmbcgen
