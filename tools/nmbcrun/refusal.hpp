// SPDX-License-Identifier: MIT
/// What a scene refuses, of several that are tried on it.
#pragma once

#include <nmbc/coefficients.hpp>
#include <stdexcept>
#include <string>

#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {

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
