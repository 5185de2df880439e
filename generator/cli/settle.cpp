// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/settle.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "generator/cli/settle_plane.hpp"
#include "generator/families/family.hpp"

namespace nmbcgen {
namespace {

/// The subcommand, or nmbcgen itself.
const CLI::App& used_app(const CLI::App& app) {
    const auto subcommands = app.get_subcommands();
    return subcommands.empty() ? app : *subcommands.front();
}

bool is_given(const CLI::App& app, const std::string& name) {
    const CLI::Option* const option = app.get_option_no_throw(name);
    return option != nullptr && option->count() > 0;
}

/// nmbcgen's own options before a subcommand would say nothing.
void require_options_behind(const CLI::App& app) {
    const CLI::App& used = used_app(app);
    if (&used == &app) {
        return;
    }
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = option->get_name();
        if (option->count() > 0 && name != "--cache") {  // which the environment may have given
            throw CLI::ValidationError(name, "options go behind the subcommand: nmbcgen " +
                                                 used.get_name() + " " + name + " ..");
        }
    }
}

/// The option or the command that asks for a G; empty where none is needed.
std::string needs_G(const Request& request, const CLI::App& used) {
    const Action action = request.action;
    if (action == Action::recommend || action == Action::passive || action == Action::reflect ||
        action == Action::optimise || action == Action::dispersion) {
        return used.get_name();
    }
    for (const char* option : {"--match", "--cfl", "--require-stable"}) {
        if (is_given(used, option)) {
            return option;
        }
    }
    return "";
}

/// Of those given the one that is not 0, if there is one.
Rational largest_G(const Request& request) {
    if (request.action == Action::dispersion) {
        const std::vector<Rational>& all = request.curves.G;
        return all.empty() ? Rational(0) : *std::ranges::max_element(all);
    }
    return request.action == Action::recommend || request.action == Action::passive
               ? request.question.G
               : request.specification.stabilisation.value_or(0);
}

void settle_G(Request& request, const CLI::App& used) {
    const std::string needed_by = needs_G(request, used);
    const bool given = is_given(used, "--G");
    if (is_stabilised(family_of(request))) {
        if (!given && !needed_by.empty()) {
            throw CLI::RequiresError(needed_by, "--G");
        }
        return;
    }
    if (largest_G(request) != 0) {
        throw CLI::ValidationError("--G", "the family " + family_of(request) +
                                              " has no stabilisation: leave it out, or give 0");
    }
    if (request.action == Action::dispersion) {
        request.curves.G = {0};
    } else if (request.action == Action::prove ||
               (!needed_by.empty() && needed_by != "--require-stable")) {
        request.specification.stabilisation = 0;
    }
}

void require_limit_of(const Curves& curves) {
    const bool constant = std::ranges::all_of(curves.weights, &std::vector<Rational>::empty);
    if (!constant) {
        throw CLI::ValidationError("--limit", "it is stated for constant influence only");
    }
    try {
        require_limit(find_family(curves.family));
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("--limit", error.what());
    }
}

std::vector<Rational> settled_weights(const WeightChoice& choice, unsigned horizon) {
    try {
        return weights_at(choice, horizon);
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("--weights", error.what());
    }
}

void settle_weights(Request& request, const WeightChoice& weights) {
    const std::string& family = family_of(request);
    if (!find_family(family).has_signed_weights &&
        std::ranges::any_of(weights.values, [](const Rational& weight) { return weight < 0; })) {
        throw CLI::ValidationError("--weights", family + " needs weights above 0");
    }
    if (request.action == Action::dispersion) {
        for (const unsigned horizon : request.curves.horizons) {
            request.curves.weights.push_back(settled_weights(weights, horizon));
        }
    } else if (request.action == Action::recommend) {
        request.question.weights = settled_weights(weights, request.question.horizon);
    } else {
        request.specification.weights = settled_weights(weights, request.specification.horizon);
    }
}

/// The default folder is the project's own: elsewhere it would come as a surprise.
void require_folder_to_write_to(const Request& request, const CLI::App& app) {
    const bool writes = request.action == Action::all_tables ||
                        (request.action == Action::one_table && !request.to_stdout);
    const std::filesystem::path project = request.folder.parent_path();
    if (writes && !is_given(app, "--out") && !std::filesystem::is_directory(project)) {
        throw CLI::ValidationError("--out", "a folder is needed: there is no " + project.string() +
                                                " here, as there is in the project");
    }
}

}  // namespace

void settle(Request& request, Pending pending, const CLI::App& app) {
    require_options_behind(app);
    if (pending.matching) {
        request.specification.order = pending.matching->order;
        request.specification.points = pending.matching->points;
    }
    if (request.action != Action::all_tables && request.action != Action::check &&
        request.action != Action::closed_forms && request.action != Action::bonds &&
        request.action != Action::closure && request.action != Action::influence) {
        settle_plane(request, pending, used_app(app));
        settle_G(request, used_app(app));
    }
    if (pending.weights) {
        settle_weights(request, *pending.weights);
    }
    if (request.curves.limit) {
        require_limit_of(request.curves);
    }
    require_folder_to_write_to(request, app);
}

}  // namespace nmbcgen
