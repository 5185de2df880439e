// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
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

using Json = nlohmann::ordered_json;

constexpr double farthest = 8;  ///< from the low end of a range that has no high one

/// G of one line of a certificate, and the steps that are to be proved there.
struct CertifiedRange {
    Grade grade;
    nmbc::Window window;  ///< what is looked at
    bool has_end = true;
    double from = 0;  ///< cfl; 0: continuous time
    double cfl = 0;
};

constexpr const char* name_of(Grade grade) {
    return grade == Grade::paired ? "paired" : "contractive";
}

double length(const nmbc::Window& window) {
    return window.high - window.low;
}

double length(const std::vector<nmbc::Window>& parts) {
    return std::accumulate(parts.begin(), parts.end(), 0.0,
                           [](double sum, const nmbc::Window& part) { return sum + length(part); });
}

/// What is sampled of a table whose G is open, to be proved.
class OpenRanges {
  public:
    /// Throws NotProvable.
    OpenRanges(const Table& table, const ProofTask& task)
        : prover_(prover_of(table)), own_step_(own_step(table.specification)), task_(task) {
        if (task.steps || own_step_ > 0) {
            const Certificate certificate = certify(table);
            if (own_step_ > 0) {
                add(Grade::paired, certificate.modal);
                add(Grade::contractive, certificate.contractive);
            } else {
                add(Grade::paired, certificate.max_cfl);
                add(Grade::contractive, certificate.max_cfl_contractive);
            }
        } else {
            const ModalWindows windows = modal_windows(table);  // steps would take as long again
            add(Grade::paired, windows.modal);
            add(Grade::contractive, windows.contractive);
        }
    }

    /// Calls visit(range, parts that are proved) for one after the other, when all are examined.
    template <class Visit>
    void prove_all(const Progress& progress, Visit visit) const {
        constexpr int in_one = 1000;
        std::vector<std::vector<nmbc::Window>> parts(all_.size());
        std::atomic<int> done = 0;
        on_all_cores(all_.size(), [&](std::size_t i) {
            const nmbc::Window& window = all_[i].window;
            int mine = 0;
            const auto told = [&](double G) {
                const double part = length(window) > 0 ? (G - window.low) / length(window) : 1;
                const int more = int(in_one * part) - mine;
                mine += more;
                progress(std::size_t(done += more), in_one * all_.size());
            };
            parts[i] = proved_parts(all_[i], told);
            told(window.high);
        });
        for (std::size_t i = 0; i < all_.size(); ++i) {
            visit(all_[i], parts[i]);
        }
    }

  private:
    std::vector<nmbc::Window> proved_parts(const CertifiedRange& range,
                                           const std::function<void(double)>& told) const {
        const auto holds = [&](const nmbc::Window& piece) {
            return own_step_ > 0 ? prover_.holds_in_step(piece, own_step_, range.grade)
                                 : prover_.holds(piece, range.cfl, range.grade, range.from);
        };
        const double finest = task_.finest.value_or(std::min(1e-4, length(range.window) / 1000));
        return parts_where(holds, range.window, finest, told);
    }

    void add(Grade grade, const std::vector<StabilityWindow>& windows) {
        for (const StabilityWindow& window : windows) {
            const double low = window.low.inner;
            all_.push_back({.grade = grade,
                            .window = {low, window.high ? window.high->inner : low + farthest},
                            .has_end = window.high.has_value(),
                            .cfl = task_.cfl});
        }
    }

    void add(Grade grade, const std::vector<StableStep>& steps) {
        for (const auto& [window, cfl, from] : steps) {
            const bool has_end = window.high != nmbc::unbounded;
            all_.push_back({.grade = grade,
                            .window = {window.low, has_end ? window.high : window.low + farthest},
                            .has_end = has_end,
                            .from = from,
                            .cfl = cfl});
        }
    }

    Prover prover_;
    double own_step_;
    ProofTask task_;
    std::vector<CertifiedRange> all_;
};

OpenRanges ranges_of(const Table& table, const ProofTask& task) {
    if (!has_stabilisation(table.model)) {
        throw NotProvable("no G in this model: prove it at --G 0");
    }
    return {table, task};
}

/// In which steps; with ProofTask::steps they differ by range.
std::string in_steps(const Specification& what, const ProofTask& task) {
    return own_step(what) > 0 ? in_own_step(what)
           : task.steps       ? "in every certified step"
           : task.cfl > 0     ? fmt::format("in every step up to cfl {:g}", task.cfl)
                              : "in continuous time";
}

std::string high_of(const CertifiedRange& range) {
    return range.has_end ? fmt::format("{:.6f}", range.window.high)
                         : fmt::format("(looked at up to {:g})", range.window.high);
}

std::string window_text(const CertifiedRange& range, const std::vector<nmbc::Window>& proved) {
    std::string text = fmt::format("{:<12} {:.6f} .. {}\n", name_of(range.grade), range.window.low,
                                   high_of(range));
    for (const nmbc::Window& part : proved) {
        text += fmt::format("  proved     {:.6f} .. {:.6f}\n", std::ceil(part.low * 1e6) / 1e6,
                            std::floor(part.high * 1e6) / 1e6);  // not more than is proved
    }
    if (length(range.window) == 0) {
        return text + (proved.empty() ? "  undecided\n" : "");
    }
    return text +
           fmt::format("  undecided  {:.6f} in all\n", length(range.window) - length(proved));
}

double percent(double part, double all) {
    return std::floor(100 * (part / all));
}

/// A line, as there are many of them.
std::string steps_text(const CertifiedRange& range, const std::vector<nmbc::Window>& proved) {
    const std::string steps = range.from > 0 ? fmt::format("{:g} to {:g}", range.from, range.cfl)
                                             : fmt::format("up to {:g}", range.cfl);
    const double all = length(range.window);
    const double share = all > 0 ? percent(length(proved), all) : proved.empty() ? 0 : 100;
    return fmt::format("{:<12} {:.6f} .. {:<12} cfl {:<14} {:>3.0f} % proved\n",
                       name_of(range.grade), range.window.low, high_of(range), steps, share);
}

/// Lengths of ranges.
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
                                       percent(share.proved, share.all))
                         : fmt::format("{:>26}", "-");
}

struct Shares {
    Share paired;
    Share contractive;

    void operator+=(const Shares& other) {
        paired += other.paired;
        contractive += other.contractive;
    }
};

std::string line_of(const std::string& name, const Shares& of) {
    return fmt::format("{:<38}{}{}\n", name, text_of(of.paired), text_of(of.contractive));
}

Shares shares_of(const Specification& what, const ProofTask& task) {
    Shares shares;
    const auto quiet = [](std::size_t, std::size_t) {};
    ranges_of(with_open_G(what), task)
        .prove_all(quiet,
                   [&](const CertifiedRange& range, const std::vector<nmbc::Window>& proved) {
                       (range.grade == Grade::paired ? shares.paired : shares.contractive) +=
                           {length(proved), length(range.window)};
                   });
    return shares;
}

}  // namespace

std::string proof_of_windows(const Specification& what, const ProofTask& task,
                             const Progress& progress) {
    const Table table = with_open_G(what);
    const OpenRanges ranges = ranges_of(table, task);
    std::string text = proof_heading(what, table) + in_steps(what, task) + "\n";
    ranges.prove_all(
        progress, [&](const CertifiedRange& range, const std::vector<nmbc::Window>& proved) {
            text += task.steps ? steps_text(range, proved) : window_text(range, proved);
        });
    return text;
}

std::string proof_of_windows_json(const Specification& what, const ProofTask& task,
                                  const Progress& progress) {
    const bool in_own_step = own_step(what) > 0;
    Json found = Json::array();
    const auto add = [&](const CertifiedRange& range, const std::vector<nmbc::Window>& parts) {
        Json proved = Json::array();
        for (const nmbc::Window& part : parts) {
            proved.push_back({part.low, part.high});
        }
        found.push_back({{"grade", name_of(range.grade)},
                         {"G", {range.window.low, range.window.high}},
                         {"has_end", range.has_end},
                         {"from", in_own_step ? Json() : Json(range.from)},
                         {"cfl", in_own_step ? Json() : Json(range.cfl)},
                         {"proved", std::move(proved)}});
    };
    ranges_of(with_open_G(what), task).prove_all(progress, add);
    const Json object = {{"order", what.order},
                         {"horizon", what.horizon},
                         {"stride", what.stride},
                         {"time_step", to_string(what.time_step)},
                         {"ranges", std::move(found)}};
    return object.dump(2) + "\n";
}

std::string proof_of_set(const ProofTask& task, const Progress& progress) {
    std::vector<Specification> set = committed_set();
    std::erase_if(set, [&](const Specification& what) {
        return what.stabilisation || !is_stabilised(what.family) ||
               (task.steps && own_step(what) > 0);
    });
    std::vector<Shares> shares(set.size());
    std::atomic<std::size_t> done = 0;
    on_all_cores(set.size(), [&](std::size_t i) {
        shares[i] = shares_of(set[i], task);
        progress(++done, set.size());
    });
    std::string text =
        fmt::format("{:<38}{:>26}{:>26}\n", "lengths of ranges of G", "paired", "contractive");
    Shares of_all;
    Shares in_own_steps;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (shares[i].paired.all > 0) {
            text += line_of(table_name(set[i]), shares[i]);
            (own_step(set[i]) > 0 ? in_own_steps : of_all) += shares[i];
        }
    }
    if (in_own_steps.paired.all > 0) {
        text += line_of("all, each in its own step", in_own_steps);
    }
    return text + line_of(std::string("all ") +
                              (task.steps ? "in every certified step" : "in continuous time"),
                          of_all);
}

}  // namespace nmbcgen
