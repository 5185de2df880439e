// SPDX-License-Identifier: MIT
/// What is wrong with a command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace nmbcgen {

/// "run, verify, .."
inline std::string subcommands_of(const CLI::App& command) {
    std::string names;
    for (const CLI::App* subcommand : command.get_subcommands({})) {
        names += (names.empty() ? "" : ", ") + subcommand->get_name();
    }
    return names;
}

/// What a command takes in the place of this argument: "--order, --G", or "the subcommands run,
/// verify" where it has some and this is no option.
inline std::string taken_by(const CLI::App& command, const std::string& stray) {
    if (!stray.starts_with('-') && !command.get_subcommands({}).empty()) {
        return "the subcommands " + subcommands_of(command);
    }
    std::string names;
    for (const CLI::Option* option : command.get_options()) {
        names += (names.empty() ? "" : ", ") + option->get_name();
    }
    return names;
}

/// Of a command and its subcommands the first that has arguments which it does not take; nullptr:
/// none has.
inline const CLI::App* command_with_strays(const CLI::App& command) {
    if (!command.remaining().empty()) {
        return &command;
    }
    for (const CLI::App* subcommand : command.get_subcommands()) {
        if (const CLI::App* found = command_with_strays(*subcommand)) {
            return found;
        }
    }
    return nullptr;
}

/// What CLI11 found, in one line and with what is allowed. A stray argument comes before all that
/// is missing, since it may be that, misspelt, and what follows it may be its value; but after a
/// wrong value, as in "--G 0, 1".
inline std::string problem_of(const CLI::ParseError& error, const CLI::App& program) {
    const bool is_of_a_value = dynamic_cast<const CLI::ValidationError*>(&error) != nullptr ||
                               dynamic_cast<const CLI::ConversionError*>(&error) != nullptr;
    if (const CLI::App* command = is_of_a_value ? nullptr : command_with_strays(program)) {
        const std::string stray = command->remaining().front();
        return "'" + stray.substr(0, 60) + "' is not expected: " + command->get_name() + " takes " +
               taken_by(*command, stray);
    }
    std::string problem = error.what();
    if (problem == "A subcommand is required") {
        const CLI::App* command = &program;
        while (!command->get_subcommands().empty()) {
            command = command->get_subcommands().front();
        }
        return command->get_name() + " needs one of the subcommands " + subcommands_of(*command);
    }
    constexpr std::string_view of_exclusion = " excludes ";
    if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) {
        return problem.replace(problem.find(of_exclusion), of_exclusion.size(), " and ") +
               " exclude each other: give one of them";
    }
    constexpr std::string_view of_repetition = ": At Most 1 required but received ";
    if (const std::size_t at = problem.find(of_repetition); at != std::string::npos) {
        return problem.replace(at, of_repetition.size(), " is given ") +
               " times, where once is allowed";
    }
    // "--G: 1 required RATIONAL missing", with the type where it is shown.
    constexpr std::string_view of_value = ": 1 required ";
    if (const std::size_t at = problem.find(of_value);
        at != std::string::npos && problem.ends_with(" missing")) {
        return problem.substr(0, at) + " needs a value";
    }
    constexpr std::string_view of_flag = " was given a disallowed flag override";
    if (problem.ends_with(of_flag)) {
        const std::string name = problem.substr(0, problem.size() - of_flag.size());
        return "--" + name + " takes no value: give it alone, or leave it out";
    }
    return problem;
}

}  // namespace nmbcgen
