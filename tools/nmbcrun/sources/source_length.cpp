// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/source_length.hpp"

#include "tools/nmbcrun/sources/force_in_time.hpp"

namespace nmbcrun {
namespace {

/// AnyScene: const or not, as the history is then.
template <class AnyScene>
auto& history_of_source(AnyScene& scene, const std::string& source) {
    return source == "boundary.left.value"    ? *scene.left.value
           : source == "boundary.right.value" ? *scene.right.value
                                              : *scene.force;
}

}  // namespace

SourceLength length_of_source(Scene& scene, const std::string& source) {
    if (source == "drive") {
        return {"drive.duration", &scene.drive->duration, false};
    }
    if (source == "incoming") {
        return {"incoming.width", &scene.incoming->pulse.width, false};
    }
    if (source == "initial") {
        return {"initial.width",
                scene.initial->kind == InitialKind::file ? nullptr : &scene.initial->pulse.width,
                false};
    }
    ForceHistory& force = history_of_source(scene, source);
    const bool is_sine = force.history == History::sine;
    return {source + (is_sine ? ".frequency" : ".duration"),
            is_sine                          ? &force.frequency
            : force.history == History::file ? nullptr
                                             : &force.duration,
            is_sine, &force.time};
}

double end_of_source(const Scene& scene, const std::string& source) {
    if (source == "initial") {
        return 0;
    }
    if (source == "drive") {
        return scene.drive->duration;
    }
    if (source == "incoming") {
        constexpr double widths = 4;
        const Incoming& incoming = *scene.incoming;
        return incoming.arrival + widths * incoming.pulse.width / wave_speed(scene);
    }
    return ForceInTime(history_of_source(scene, source)).end();
}

Scene with_source_alone(Scene scene, const std::string& source) {
    const auto drop_unless = [&](const char* name, auto& other) {
        if (source != name) {
            other.reset();
        }
    };
    drop_unless("drive", scene.drive);
    drop_unless("initial", scene.initial);
    drop_unless("force", scene.force);
    drop_unless("incoming", scene.incoming);
    drop_unless("boundary.left.value", scene.left.value);
    drop_unless("boundary.right.value", scene.right.value);
    return scene;
}

}  // namespace nmbcrun
