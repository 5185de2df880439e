// SPDX-License-Identifier: GPL-2.0-or-later
/// The command line of nmbcgen.
#pragma once

#include <filesystem>
#include <variant>

#include "generator/commands/bonds.hpp"
#include "generator/commands/closure.hpp"
#include "generator/commands/coupling.hpp"
#include "generator/commands/dispersion.hpp"
#include "generator/commands/influence.hpp"
#include "generator/commands/oblique.hpp"
#include "generator/commands/optimise.hpp"
#include "generator/commands/passive.hpp"
#include "generator/commands/plane_dispersion.hpp"
#include "generator/commands/plane_series.hpp"
#include "generator/commands/plane_sides.hpp"
#include "generator/commands/prove.hpp"
#include "generator/commands/recommend.hpp"
#include "generator/emit/closed_forms.hpp"
#include "generator/emit/emit.hpp"
#include "generator/families/power_influence.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

enum class Action {
    one_table,
    all_tables,
    check,
    reflect,
    prove,
    recommend,
    passive,
    optimise,
    dispersion,
    closed_forms,
    bonds,
    closure,
    coupling,
    influence,
    taylor,
    oblique
};

struct Request {
    Action action = Action::one_table;
    Specification specification;
    std::optional<Rational> cfl;  ///< dt omega_max / 2, which is to give the time step
    const Format* format = &formats().front();
    bool to_stdout = false;
    bool certified = true;          ///< with certificates of stability
    bool require_stable = false;    ///< nothing is written unless the certificate covers G
    unsigned samples = 200;         ///< wave numbers of Action::reflect
    ProofTask proof;                ///< of Action::prove
    Question question;              ///< of Action::recommend
    std::optional<ChainModel> end;  ///< of Action::passive
    bool as_header = false;         ///< the end, in place of JSON
    std::optional<SideTask> side;   ///< of Action::passive; instead of the question of a chain
    std::vector<AbsorbedWave> absorbed{};  ///< of Action::recommend, with a side
    bool as_csv = false;                   ///< their reflection, in place of the advice
    Aim aim;        ///< of Action::optimise, its condition but for the stride apart
    Curves curves;  ///< of Action::dispersion
    std::optional<PlaneCurves> plane_curves;  ///< instead, of the plane family that `curves` names
    const ClosedFormat* closed_format = &closed_formats().front();  ///< of Action::closed_forms
    BondsTask bonds;                                                ///< of Action::bonds
    ClosureTask closure;                                            ///< of Action::closure
    CouplingTask coupling;                                          ///< of Action::coupling
    PowerInfluence influence;                                       ///< of Action::influence
    ClassInfluence class_influence;              ///< instead, of a plane or space
    PlaneSeriesTask series;                      ///< of Action::taylor
    ObliqueTask oblique;                         ///< of Action::oblique
    bool as_json = false;                        ///< what these print, in place of text
    std::optional<std::filesystem::path> cache;  ///< folder of kept certificates
    std::filesystem::path folder = "generated/nmbc/tables";
};

/// A request, or the exit code where help was printed (0) or the arguments are wrong (2); the
/// message is on stderr by then.
std::variant<Request, int> parse_command_line(int argc, char** argv);

}  // namespace nmbcgen
