// SPDX-License-Identifier: MIT
/// What can be wrong with a run, by the exit code it ends with.
#pragma once

#include <nmbc/coefficients.hpp>
#include <stdexcept>
#include <string>

#include "generator/support/posix_file.hpp"

namespace nmbcrun {

/// The scene, or what it asks for, is wrong (2); what() says where and how.
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A comparison did not hold: nothing meets a tolerance (1); what() has lines of its own.
struct NotMet : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The ends are not stable together, no time step is certified for them, or the run became
/// non-finite, grew without a cause or had no energy at all (4); what() says how, or at which step
/// and node.
struct Unstable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Of a comparison of runs in which no node moves.
inline Unstable nothing_to_compare_with() {
    return Unstable("nothing moved at any time, so there is nothing to compare with");
}

/// The user ended the run (130, as shells count Ctrl-C).
struct Interrupted : std::runtime_error {
    using std::runtime_error::runtime_error;
};

using nmbcgen::FileError;  // (5)

/// Calls job(). Why the scene refuses what it tries, in words; empty: it does not.
template <class Job>
std::string refusal_of(Job job) {
    try {
        job();
    } catch (const SceneError& error) {
        return error.what();
    } catch (const std::invalid_argument& error) {
        return error.what();
    } catch (const nmbc::CoefficientError& error) {
        return error.what();
    } catch (const Unstable& error) {
        return error.what();
    }
    return "";
}

}  // namespace nmbcrun
