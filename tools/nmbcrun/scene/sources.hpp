// SPDX-License-Identifier: MIT
/// What a scene can start and be driven by. Keys, units and defaults: docs/reference/scene.md.
#pragma once

#include <filesystem>
#include <nmbc/node_line.hpp>

namespace nmbcrun {

/// (57): the nodes with |X - centre| <= half_width * horizon * spacing follow
/// u = amplitude/2 (1 - cos(pi t / duration)) for 0 <= t <= duration, then are let go.
struct Drive {
    double amplitude = 0;   ///< largest displacement [length]
    double duration = 0;    ///< [time]
    double centre = 0;      ///< [length]; the nodes are at X = dX, 2 dX, ..
    double half_width = 2;  ///< in horizons
};

/// Functions of s = x / width, 1 at x = 0.
enum class Shape {
    gaussian,  ///< exp(-s^2)
    ricker,    ///< (1 - 2 s^2) exp(-s^2)
    packet,    ///< exp(-s^2) cos(wave_number x / dX)
};

struct Pulse {
    Shape shape = Shape::gaussian;
    double amplitude = 0;    ///< [length], or [length/time] of a velocity
    double width = 0;        ///< [length]
    double wave_number = 0;  ///< of a packet [1/dX]
};

enum class InitialKind {
    displacement,  ///< u is the pulse, v = 0
    velocity,      ///< v is the pulse, u = 0
    to_the_right,  ///< u is the pulse, with the v of a wave that goes right
    to_the_left,
    file,  ///< u and v of a file
};

/// The state at t = 0.
struct Initial {
    InitialKind kind = InitialKind::displacement;
    Pulse pulse;
    double centre = 0;           ///< [length]
    std::filesystem::path file;  ///< columns node, u, v
};

/// Of a file of numbers.
enum class FileFormat { csv, hdf5 };

enum class History {
    gaussian,  ///< exp(-((t - time) / duration)^2)
    ricker,    ///< (1 - 2 s^2) exp(-s^2), s = (t - time) / duration
    sine,      ///< sin(2 pi frequency (t - time)) from `time` on, for so many cycles
    file,      ///< linear between the rows of a file, which begins at `time`
};

/// A force in time.
struct ForceHistory {
    History history = History::gaussian;
    double amplitude = 1;        ///< [force/volume]; of a file: what its forces are multiplied by
    double time = 0;             ///< middle of a gaussian or ricker, start of the others [time]
    double duration = 0;         ///< [time]
    double frequency = 0;        ///< of a sine [1/time]
    double cycles = 1;           ///< of a sine
    std::filesystem::path file;  ///< columns or datasets time, force
    FileFormat format = FileFormat::csv;

    friend bool operator==(const ForceHistory&, const ForceHistory&) = default;
};

/// A body force of the nodes with |X - centre| <= half_width, rho u_tt = .. + f.
struct Force : ForceHistory {
    double centre = 0;      ///< [length]
    double half_width = 0;  ///< [length]
};

/// A wave that comes in through an end.
struct Incoming {
    nmbc::End end = nmbc::End::left;
    Pulse pulse;
    double arrival = 0;  ///< when its middle is at the outermost interior node there [time]
};

/// A homogeneous deformation that the ends hold.
struct Preload {
    double strain = 0;
};

}  // namespace nmbcrun
