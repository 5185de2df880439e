// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen's command line, an argument a line; one line alone is given to every parser of a value.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "generator/cli/comma_list.hpp"
#include "generator/cli/command_line.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/exact/rational.hpp"
#include "generator/support/number_between.hpp"

namespace {

template <class Parse>
void parse_value(Parse parse, const std::string& text) {
    try {
        parse(text);
    } catch (const std::invalid_argument& error) {
        if (std::string(error.what()).empty()) {
            std::abort();
        }
    }
}

void parse_values(const std::string& text) {
    using namespace nmbcgen;
    parse_value(parse_count, text);
    parse_value(parse_samples, text);
    parse_value(parse_family, text);
    parse_value(parse_format, text);
    parse_value(parse_closed_format, text);
    parse_value(parse_closed_order, text);
    parse_value(parse_folder, text);
    parse_value(parse_cfl, text);
    parse_value(parse_matching, text);
    parse_value([](const std::string& weights) { weights_at(parse_weights(weights), 3); }, text);
    parse_value(parse_recommended_order, text);
    parse_value(parse_recommended_cfl, text);
    parse_value(parse_fraction, text);
    parse_value(parse_counts, text);
    parse_value(parse_rationals, text);
    parse_value(parse_band, text);
    parse_value(parse_wide_band, text);
    parse_value(parse_rational, text);
    parse_value(items_of, text);
    std::string number = text;
    nmbcgen::number_between(1e-16, 1e16)(number);
}

/// For as long as it lives, nothing is printed: help and error messages are many.
class Silence {
  public:
    Silence() = default;
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;
    Silence(Silence&&) = delete;
    Silence& operator=(Silence&&) = delete;
    ~Silence() {
        std::cout.rdbuf(out_);
        std::cerr.rdbuf(err_);
    }

  private:
    std::ostringstream nowhere_;
    std::streambuf* out_ = std::cout.rdbuf(nowhere_.rdbuf());
    std::streambuf* err_ = std::cerr.rdbuf(nowhere_.rdbuf());
};

void parse_lines(const std::string& text) {
    std::vector<std::string> arguments{"nmbcgen"};
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::erase(line, '\0');  // which no argument can hold
        arguments.push_back(line);
    }
    std::vector<char*> pointers;
    pointers.reserve(arguments.size());
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    const Silence silence;
    nmbcgen::parse_command_line(int(pointers.size()), pointers.data());
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's own
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    if (text.find('\n') == std::string::npos) {
        parse_values(text);
    } else {
        parse_lines(text);
    }
    return 0;
}
