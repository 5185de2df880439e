// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen: exact mathematics to text. The stages are in pipeline.hpp.
#include <fmt/format.h>

#include <csignal>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>

#include "generator/bonds/square_lattice.hpp"
#include "generator/cli/command_line.hpp"
#include "generator/commands/bonds.hpp"
#include "generator/commands/check.hpp"
#include "generator/commands/closed_forms.hpp"
#include "generator/commands/closure.hpp"
#include "generator/commands/coupling.hpp"
#include "generator/commands/dispersion.hpp"
#include "generator/commands/influence.hpp"
#include "generator/commands/plane_sides.hpp"
#include "generator/commands/prove.hpp"
#include "generator/commands/reflect.hpp"
#include "generator/commands/require_stable.hpp"
#include "generator/commands/time_step.hpp"
#include "generator/commands/write_tables.hpp"
#include "generator/emit/emit.hpp"
#include "generator/lattice/projection.hpp"
#include "generator/names/names.hpp"
#include "generator/names/printable.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/least_nodes.hpp"
#include "generator/support/exit_code.hpp"
#include "generator/support/files.hpp"
#include "generator/support/kept_texts.hpp"
#include "generator/support/progress_line.hpp"

namespace nmbcgen {
namespace {

int write_one(const Request& request) {
    const std::string name =
        table_name(request.specification) + std::string(request.format->ending);
    if (!request.to_stdout) {
        require_short_name(name);
        require_writable(request.folder / name);  // before what may take minutes
    }
    Table table = request.certified ? certified({request.specification}, request.cache).front()
                                    : derived({request.specification}).front();
    if (request.require_stable) {
        table.in_plane = require_stable(table);
    }
    if (request.to_stdout) {
        print(request.format->emit(table));
    } else if (request.format->name == "header") {
        write_and_name(
            {lattice_file(request.folder, table), {request.folder / name, emit_header(table)}});
    } else {
        write_and_name({{request.folder / name, request.format->emit(table)}});
    }
    if (table.certificate && table.specification.stabilisation &&
        table.certificate->modal.empty()) {
        std::cerr
            << "nmbcgen: warning: " << why_uncertified(table)
            << ". Programs refuse it. --require-stable says where it is stable, nmbcgen recommend "
               "what to take in its place\n";
    }
    return done;
}

int check(const Request& request) {
    const std::filesystem::path& folder = request.folder;
    require_folder(folder);  // the fresh set takes a minute
    const std::vector<TextFile> fresh = committed_files(request.folder, request.cache);
    if (const std::string others = other_files(folder, fresh); !others.empty()) {
        std::cerr << "not of the committed set, and not compared: " << printable(others) << "\n";
    }
    const std::string report = staleness(folder, fresh);
    if (report.empty()) {
        std::cerr << "up to date: " << printable(folder.string()) << "\n";
        return done;
    }
    const std::string name = printable(folder.string());
    std::cerr << report << "The tables in " << name
              << " are stale. To write them anew: nmbcgen --all --out " << name << "\n";
    return does_not_hold;
}

/// Prints a command's text, with its progress on a terminal.
template <class Command>
void print_with_progress(const Command& command) {
    std::string text;
    {
        ProgressLine line("nmbcgen: examining");
        text = command(std::ref(line));
    }
    print(text);
}

/// Curve by curve: all of them may be more than fits into memory.
void print_curves(const Curves& curves) {
    require_models(curves);  // before anything is printed
    print(std::string(dispersion_columns));
    for (std::size_t which = 0; which < curves.horizons.size(); ++which) {
        for (const Rational& G : curves.G) {
            print(dispersion_rows(curves, which, G));
        }
    }
}

void print_curves(std::string_view family, const PlaneCurves& curves,
                  const std::vector<Rational>& values) {
    print(std::string(plane_dispersion_columns));
    for (const Rational& g : values) {
        print(plane_dispersion_rows(family, curves, g));
    }
}

/// What is asked for, as JSON or as text.
template <class Task>
void print_as(bool as_json, std::string (*json)(const Task&), std::string (*text)(const Task&),
              const Task& task) {
    print((as_json ? json : text)(task));
}

std::string advice(const Request& request, const Progress& progress) {
    if (!request.side) {
        return recommendation(request.question, progress);
    }
    std::string question = "recommend " + words_of(*request.side);
    for (const AbsorbedWave& wave : request.absorbed) {
        question +=
            fmt::format(" {}:{}", wave.polarisation == Polarisation::P ? "P" : "S", wave.degrees);
    }
    return KeptTexts(request.cache).text(question + (request.as_csv ? " csv" : ""), [&] {
        return (request.as_csv ? side_reflection_csv : side_recommendation)(
            *request.side, request.absorbed, progress);
    });
}

std::string passive_text(const Request& request, const Progress& progress) {
    if (request.end) {
        return request.as_header ? passive_header(*request.end) : passive_json(*request.end);
    }
    return KeptTexts(request.cache)
        .text("passive " + words_of(*request.side) + (request.as_header ? " header" : ""), [&] {
            return request.as_header ? passive_header(*request.side, progress)
                                     : passive_json(*request.side, progress);
        });
}

/// Puts a time step in the place of cfl.
Request settled(Request request) {
    if (request.cfl) {
        request.specification.time_step = time_step_at(*request.cfl, request.specification);
    }
    require_leapfrog(request.specification);
    request.aim.what = request.specification;
    return request;
}

int run(const Request& request) {
    switch (request.action) {
        case Action::one_table:
            return write_one(request);
        case Action::check:
            return check(request);
        case Action::all_tables:
            require_writable(request.folder / "tables.hpp");  // before what takes minutes
            write_and_name(committed_files(request.folder, request.cache));
            return done;
        case Action::recommend:
            print_with_progress(std::bind_front(advice, request));
            return done;
        case Action::passive:
            print_with_progress(std::bind_front(passive_text, request));
            return done;
        case Action::optimise:
            print_with_progress(std::bind_front(optimisation, request.aim));
            return done;
        case Action::dispersion:
            if (request.plane_curves) {
                print_curves(request.curves.family, *request.plane_curves, request.curves.G);
            } else {
                print_curves(request.curves);
            }
            return done;
        case Action::reflect:
            print(reflection_csv(derived({request.specification}).front(), request.samples));
            return done;
        case Action::prove:
            if (request.proof.all) {
                print_with_progress(std::bind_front(proof_of_set, request.proof));
            } else if (!request.specification.stabilisation) {
                print_with_progress(
                    std::bind_front(request.as_json ? proof_of_windows_json : proof_of_windows,
                                    request.specification, request.proof));
            } else {
                print_with_progress(std::bind_front(request.as_json ? proof_at_G_json : proof_at_G,
                                                    request.specification));
            }
            return done;
        case Action::bonds:
            print_as(request.as_json, bonds_json, bonds_text, request.bonds);
            return done;
        case Action::closure:
            print_as(request.as_json, closure_json, closure_text, request.closure);
            return done;
        case Action::coupling:
            print_with_progress([&request](const Progress&) {
                return (request.as_json ? coupling_json : coupling_text)(request.coupling);
            });
            return done;
        case Action::influence:
            if (request.class_influence.radius_squared > 0) {
                print_as(request.as_json, class_influence_json, class_influence_text,
                         request.class_influence);
            } else {
                print_as(request.as_json, power_influence_json, power_influence_text,
                         request.influence);
            }
            return done;
        case Action::taylor:
            print_as(request.as_json, plane_series_json, plane_series_text, request.series);
            return done;
        case Action::oblique:
            print_as(request.as_json, oblique_json, oblique_text, request.oblique);
            return done;
        case Action::closed_forms:
            print(request.closed_format->emit(closed_forms(
                find_family(request.specification.family), request.specification.order)));
            return done;
    }
    return done;
}

/// What is wrong, in a line, and the exit code of that.
int report(const std::string& what, ExitCode code) {
    std::cerr << "nmbcgen: " << printable_lines(what) << "\n";
    return code;
}

/// Of the exception that is being handled.
int report_failure() {
    try {
        throw;
    } catch (const NoSuchBoundary& reason) {
        return report(reason.what(), no_such_boundary);
    } catch (const NoSuchBonds& reason) {
        return report(reason.what(), no_such_boundary);
    } catch (const NoProjection& reason) {
        return report(reason.what(), no_such_boundary);
    } catch (const NoSuchModel& reason) {
        return report(reason.what(), bad_input);
    } catch (const NoClosedForms& reason) {
        return report(reason.what(), bad_input);
    } catch (const NotProvable& reason) {
        return report(reason.what(), bad_input);
    } catch (const NotStable& reason) {
        return report(reason.what(), unstable);
    } catch (const NotCertifiable& reason) {
        return report(reason.what(), unstable);
    } catch (const FileError& error) {
        return report(error.what(), file_failed);
    } catch (const std::overflow_error& error) {
        return report(fmt::format("a coefficient has no double at this G ({}); --format json keeps "
                                  "it exact",
                                  error.what()),
                      bad_input);
    } catch (const std::bad_alloc&) {
        return report("not enough memory for this order and horizon", bad_input);
    } catch (const std::logic_error& error) {
        return report(fmt::format("a defect of nmbcgen, nothing was written: {}", error.what()),
                      does_not_hold);
    }
}

}  // namespace
}  // namespace nmbcgen

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is told of as on a full disk
    try {
        const auto parsed = nmbcgen::parse_command_line(argc, argv);
        if (const int* exit_code = std::get_if<int>(&parsed)) {
            return *exit_code;
        }
        return nmbcgen::run(nmbcgen::settled(std::get<nmbcgen::Request>(parsed)));
    } catch (...) {
        return nmbcgen::report_failure();
    }
}
