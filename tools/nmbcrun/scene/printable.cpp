// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/printable.hpp"

#include <fmt/format.h>

namespace nmbcrun {

std::string printable(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : '\0');
        if (byte < 0x20 || byte == 0x7f) {
            result += fmt::format("\\x{:02x}", byte);
        } else if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {  // U+0080 to U+009F
            result += fmt::format("\\u00{:02x}", next);
            ++i;
        } else {
            result += text[i];
        }
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

}  // namespace nmbcrun
