// SPDX-License-Identifier: GPL-2.0-or-later
/// Every text that differs from a given one in one number.
#pragma once

#include <set>
#include <string>

#include "generator/table/exact.hpp"

namespace nmbcgen::test {

/// For each number in the text: one more, one less, the other sign, and each of its digits in
/// turn made one more (9 becomes 0). "12 -7" has the mutants "13 -7", "11 -7", "-12 -7", "22 -7",
/// "12 -8", "12 -6", "12 7".
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
            put(Integer(value - 1).str());
            const bool negative = begin > 0 && text[begin - 1] == '-';
            mutants.insert(negative ? text.substr(0, begin - 1) + text.substr(begin)
                                    : text.substr(0, begin) + "-" + text.substr(begin));
        }
        for (std::size_t i = 0; i < number.size(); ++i) {
            std::string other = number;
            other[i] = other[i] == '9' ? '0' : char(other[i] + 1);
            put(other);
        }
        begin = text.find_first_of(digits, end);
    }
    mutants.erase(text);
    return mutants;
}

}  // namespace nmbcgen::test
