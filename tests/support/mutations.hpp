// SPDX-License-Identifier: GPL-2.0-or-later
/// Every text that differs from a given one in one number.
#pragma once

#include <set>
#include <string>

#include "generator/table/exact.hpp"

namespace nmbcgen::test {

/// For each number in the text: one more, the other sign, and its first digit made one more
/// (9 becomes 0). "12 -7" has the mutants "13 -7", "-12 -7", "22 -7", "12 -8", "12 7".
inline std::set<std::string> mutations(const std::string& text) {
    constexpr const char* digits = "0123456789";
    std::set<std::string> mutants;
    for (std::size_t begin = text.find_first_of(digits); begin < text.size();) {
        const std::size_t end = std::min(text.find_first_not_of(digits, begin), text.size());
        const std::string number = text.substr(begin, end - begin);
        const auto put = [&](const std::string& other) {
            mutants.insert(text.substr(0, begin) + other + text.substr(end));
        };
        const Integer value(
            number.substr(std::min(number.find_first_not_of('0'), end - begin - 1)));
        put(Integer(value + 1).str());
        if (value > 0) {
            const bool negative = begin > 0 && text[begin - 1] == '-';
            mutants.insert(negative ? text.substr(0, begin - 1) + text.substr(begin)
                                    : text.substr(0, begin) + "-" + text.substr(begin));
        }
        std::string other = number;
        other[0] = other[0] == '9' ? '0' : char(other[0] + 1);
        put(other);
        begin = text.find_first_of(digits, end);
    }
    mutants.erase(text);
    return mutants;
}

}  // namespace nmbcgen::test
