// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

#include "generator/commands/prove.hpp"
#include "generator/families/family.hpp"
#include "generator/names/names.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/certify.hpp"
#include "generator/stability/modal_windows.hpp"
#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

constexpr double farthest = 8;  ///< from the low end of a window that has no high one

/// Whether a grade is proved at all G of an interval.
using Holds = std::function<bool(const nmbc::Window&)>;

nmbc::Window looked_at(const StabilityWindow& window) {
    const double low = window.low.inner;
    return {low, window.high ? window.high->inner : low + farthest};
}

double length(const nmbc::Window& window) {
    return window.high - window.low;
}

std::vector<nmbc::Window> proved_parts(const nmbc::Window& window, const Holds& holds,
                                       const ProofTask& task, const Progress& progress) {
    const double finest = task.finest.value_or(std::min(1e-4, length(window) / 1000));
    const auto told = [&](double G) {
        constexpr double in_all = 1000;
        progress(std::size_t(in_all * (G - window.low) / std::max(length(window), finest)),
                 std::size_t(in_all));
    };
    return parts_where(holds, window, finest, told);
}

std::string text_of(const StabilityWindow& window, const char* grade_name, const Holds& holds,
                    const ProofTask& task, const Progress& progress) {
    const nmbc::Window whole = looked_at(window);
    double open = length(whole);
    std::string text = fmt::format("{:<12} {:.6f} .. {}\n", grade_name, whole.low,
                                   window.high ? fmt::format("{:.6f}", whole.high)
                                               : fmt::format("(looked at up to {:g})", whole.high));
    for (const nmbc::Window& part : proved_parts(whole, holds, task, progress)) {
        open -= length(part);
        text += fmt::format("  proved     {:.6f} .. {:.6f}\n", std::ceil(part.low * 1e6) / 1e6,
                            std::floor(part.high * 1e6) / 1e6);  // not more than is proved
    }
    return text + fmt::format("  undecided  {:.6f} in all\n", open);
}

/// The grades that are sought, each with its name and its windows.
std::vector<std::tuple<const char*, Grade, std::vector<StabilityWindow>>> windows_of(
    const Table& table) {
    std::vector<StabilityWindow> paired;
    std::vector<StabilityWindow> contractive;
    if (own_step(table.specification) > 0) {
        Certificate certificate = certify(table);
        paired = std::move(certificate.modal);
        contractive = std::move(certificate.contractive);
    } else {
        ModalWindows windows = modal_windows(table);  // without steps, which take as long again
        paired = std::move(windows.modal);
        contractive = std::move(windows.contractive);
    }
    return {{"paired", Grade::paired, std::move(paired)},
            {"contractive", Grade::contractive, std::move(contractive)}};
}

/// Lengths of windows.
struct Share {
    double proved = 0;
    double all = 0;

    void operator+=(const Share& other) {
        proved += other.proved;
        all += other.all;
    }
};

std::string text_of(const Share& share) {
    return share.all > 0 ? fmt::format("{:>9.3f} of {:>7.3f} {:>4.0f} %", share.proved, share.all,
                                       std::floor(100 * (share.proved / share.all)))
                         : fmt::format("{:>26}", "-");
}

/// Of each grade, in continuous time.
std::vector<Share> shares_of(const Specification& what, const ProofTask& task) {
    const Table table = derive(what);
    const Prover prover(table);
    std::vector<Share> shares;
    for (const auto& [name, grade, windows] : windows_of(table)) {
        Share share;
        for (const StabilityWindow& window : windows) {
            const nmbc::Window whole = looked_at(window);
            share.all += length(whole);
            const auto holds = [&, least = grade](const nmbc::Window& piece) {
                return prover.holds(piece, 0, least);
            };
            for (const nmbc::Window& part :
                 proved_parts(whole, holds, task, [](std::size_t, std::size_t) {})) {
                share.proved += length(part);
            }
        }
        shares.push_back(share);
    }
    return shares;
}

}  // namespace

std::string proof_of_windows(const Specification& what, const ProofTask& task,
                             const Progress& progress) {
    const Table table = with_open_G(what);
    const Prover prover = prover_of(table);
    if (!has_stabilisation(table.model)) {
        throw NotProvable("no G in this model: prove it at --G 0");
    }
    const double step = own_step(what);
    std::string text = proof_heading(what, table);
    text += step > 0       ? in_own_step(what)
            : task.cfl > 0 ? fmt::format("in every step up to cfl {:g}", task.cfl)
                           : "in continuous time";
    text += "\n";
    for (const auto& [name, grade, windows] : windows_of(table)) {
        const auto holds = [&, least = grade](const nmbc::Window& piece) {
            return step > 0 ? prover.holds_in_step(piece, step, least)
                            : prover.holds(piece, task.cfl, least);
        };
        for (const StabilityWindow& window : windows) {
            text += text_of(window, name, holds, task, progress);
        }
    }
    return text;
}

std::string proof_of_set(const ProofTask& task, const Progress& progress) {
    std::vector<Specification> set = committed_set();
    std::erase_if(set, [](const Specification& what) {
        return what.stabilisation || what.time_step != 0 || !is_stabilised(what.family);
    });
    std::vector<std::vector<Share>> shares(set.size());
    std::atomic<std::size_t> done = 0;
    on_all_cores(set.size(), [&](std::size_t i) {
        shares[i] = shares_of(set[i], task);
        progress(++done, set.size());
    });
    std::string text =
        fmt::format("{:<28}{:>26}{:>26}\n", "lengths of windows of G", "paired", "contractive");
    const auto line = [](const std::string& name, const std::vector<Share>& of_grades) {
        return fmt::format("{:<28}{}{}\n", name, text_of(of_grades[0]), text_of(of_grades[1]));
    };
    std::vector<Share> sum(2);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (shares[i][0].all == 0) {
            continue;
        }
        text += line(table_name(set[i]), shares[i]);
        for (std::size_t grade = 0; grade < sum.size(); ++grade) {
            sum[grade] += shares[i][grade];
        }
    }
    return text + line("all", sum);
}

}  // namespace nmbcgen
