// SPDX-License-Identifier: GPL-2.0-or-later
/// Options of a command line whose values are read by a function.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>

namespace nmbcgen {

/// Adds an option, to be given once, that stores what `parse` makes of the text. A
/// std::invalid_argument of it becomes a command-line error that names the option.
template <class Target, class Parse>
CLI::Option* add_parsed(CLI::App& app, const std::string& name, Target& target, Parse parse,
                        const std::string& description) {
    const auto store = [&target, parse, name](const CLI::results_t& texts) {
        try {
            target = parse(texts.back());
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError(name, error.what());
        }
        return true;
    };
    return app.add_option(name, store, description)
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw)
        ->expected(1);
}

}  // namespace nmbcgen
