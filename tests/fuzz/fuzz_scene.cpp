// SPDX-License-Identifier: GPL-2.0-or-later
/// A scene, and the same with overrides. Lines that begin with --set end the scene: what comes
/// after each of them, up to the next, is a KEY=VALUE.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace {

constexpr const char* name = "scene.toml";

/// A text that is refused has to be so by a message that says where.
void read(const std::string& text, const std::vector<std::string>& settings) {
    try {
        nmbcrun::read_scene_text(text, name, nmbcrun::split_settings(settings));
    } catch (const nmbcrun::SceneError& error) {
        const std::string message = error.what();
        if (!message.starts_with(name) && !message.starts_with("--set ")) {
            std::cerr << "says not where: " << message << "\n";
            std::abort();
        }
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's own
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string all(data, data + size);
    const std::string mark = "\n--set ";
    std::size_t end = all.find(mark);
    const std::string text = all.substr(0, end);
    std::vector<std::string> settings;
    while (end != std::string::npos) {
        const std::size_t begin = end + mark.size();
        end = all.find(mark, begin);
        settings.push_back(all.substr(begin, end == std::string::npos ? end : end - begin));
    }
    read(text, {});
    if (!settings.empty()) {
        read(text, settings);
    }
    return 0;
}
