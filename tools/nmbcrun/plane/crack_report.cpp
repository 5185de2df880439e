// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/crack_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "tools/nmbcrun/plane/plane_lattice.hpp"

namespace nmbcrun {
namespace {

struct Growth {
    std::optional<double> fastest{};  ///< none where the rows are too short
    bool has_met_another = false;
};

/// The largest mean rate at which the reach from an end grows within so much time, up to where it
/// grows faster than waves of this speed: there it has met another crack.
Growth growth_of(const std::vector<PlaneFiles::CrackRow>& rows, std::size_t end, double duration,
                 double speed, double horizon) {
    Growth growth;
    std::size_t first = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double step = rows[i].reach[end] - rows[i - 1].reach[end];
        constexpr double ragged = 4;  // horizons: bonds between two cracked places break last
        if (step > speed * (rows[i].time - rows[i - 1].time) + ragged * horizon) {
            growth.has_met_another = true;
            break;
        }
        while (rows[i].time - rows[first + 1].time >= duration) {
            ++first;
        }
        const double time = rows[i].time - rows[first].time;
        if (time >= duration) {
            const double rate = (rows[i].reach[end] - rows[first].reach[end]) / time;
            growth.fastest = std::max(growth.fastest.value_or(0), rate);
        }
    }
    return growth;
}

/// How fast, of c_R; empty where either is not known.
std::string speed_of_growth(const PlaneScene& scene, double horizon,
                            const std::vector<PlaneFiles::CrackRow>& rows, std::size_t end) {
    const nmbc::PlaneModel model = model_of(scene);
    const auto of_unit = rayleigh_speed(model.speed_P(), model.speed_S());
    if (!of_unit) {
        return "";
    }
    const double unit = rate_of(scene) * scene.spacing;
    const double rayleigh = unit * *of_unit;
    constexpr double horizons = 10;
    const auto [fastest, has_met_another] =
        growth_of(rows, end, horizons * horizon / rayleigh, unit * model.speed_P(), horizon);
    std::string text =
        fastest ? fmt::format(", fastest {:.4g}, {:.2f} of c_R", *fastest, *fastest / rayleigh)
                : "";
    return has_met_another ? text + ", met another crack" : text;
}

}  // namespace

std::string crack_report(const PlaneSimulation& simulation, const PlaneFiles& files) {
    const std::vector<PlaneFiles::CrackRow> rows = files.crack_rows();
    const PlaneBalance balance = simulation.balance();
    std::string text = fmt::format("bonds        {:.0f} broken, which had {:.4g}",
                                   rows.back().broken, balance.fracture);
    if (balance.work > 0) {
        text += fmt::format(", {:.3g} of the work done", balance.fracture / balance.work);
    }
    text += "\n";
    const std::vector<CrackGrowth> growth = files.growth(simulation);
    for (std::size_t end = 0; end < growth.size(); ++end) {
        const CrackGrowth& of_end = growth[end];
        const std::array<double, 2>& from = files.front().ends()[end];
        text += fmt::format("crack        from ({:.6g}, {:.6g}): ", from[0], from[1]);
        if (of_end.reach == 0) {
            text += "has not grown\n";
            continue;
        }
        text += fmt::format("{:.4g} long", of_end.reach);
        if (of_end.branches.empty()) {  // else one of several tips
            text += fmt::format(" towards {} degrees", degrees_from_x(from, of_end.tip));
        }
        text +=
            fmt::format(", tip at ({:.6g}, {:.6g}){}\n", of_end.tip[0], of_end.tip[1],
                        speed_of_growth(simulation.scene(), files.front().horizon(), rows, end));
        for (std::size_t k = 0; k < of_end.branches.size(); ++k) {
            const auto first = std::ranges::find_if(rows, [&](const PlaneFiles::CrackRow& row) {
                return row.branches[end] > double(k);
            });
            const CrackBranch& branch = of_end.branches[k];
            text += fmt::format(
                "             branches at ({:.6g}, {:.6g}), seen at t = {:.4g}, towards {} "
                "degrees\n",
                branch.X[0], branch.X[1],
                first == rows.end() ? simulation.plane().time() : first->time,
                fmt::join(branch.directions, ", "));
        }
    }
    return text;
}

}  // namespace nmbcrun
