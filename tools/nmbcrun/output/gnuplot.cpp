// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/gnuplot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "generator/names/printable.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"

namespace nmbcrun {
namespace {

namespace fs = std::filesystem;

/// In the build tree as where it is installed.
fs::path script_path(const std::string& script) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    fs::path path = program.parent_path().parent_path() / "share/nmbc/plots" / script;
    if (error || !fs::exists(path, error)) {
        throw FileError(fmt::format(
            "there is no {} to draw with: nmbcrun has to stay in the bin beside its share/nmbc",
            path.string()));
    }
    return path;
}

/// As a shell wants it.
std::string quoted(const std::string& text) {
    const bool is_plain = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::isalnum(c) != 0 || std::strchr("_./=+-,:", c) != nullptr;
    });
    if (is_plain) {
        return text;
    }
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
    }
    return result + "'";
}

std::string as_command(const std::vector<std::string>& words) {
    std::string command;
    for (const std::string& word : words) {
        command += (command.empty() ? "" : " ") + quoted(word);
    }
    return command;
}

/// Whether it has done its work; a complaint on stderr, with its own, where it is installed, and
/// has not. gnuplot counts the frames of a film there, too.
bool run_program(std::vector<std::string> words) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> complaints(std::tmpfile(), std::fclose);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    if (complaints) {
        ::posix_spawn_file_actions_adddup2(&actions, ::fileno(complaints.get()), STDERR_FILENO);
    }
    pid_t process = 0;
    const int error =
        ::posix_spawnp(&process, arguments.front(), &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error == ENOENT) {
        return false;
    }
    int status = 0;
    pid_t ended = 0;
    while (error == 0 && (ended = ::waitpid(process, &status, 0)) < 0 && errno == EINTR) {
    }
    const bool is_done = error == 0 && ended == process && status == 0;
    if (interrupted()) {
        throw Interrupted("stopped while it was drawn; the numbers are written");
    }
    if (!is_done) {
        if (complaints) {
            std::rewind(complaints.get());
            for (int c = 0; (c = std::fgetc(complaints.get())) != EOF;) {
                std::fputc(c, stderr);
            }
        }
        fmt::print(stderr, "nmbcrun: warning: gnuplot failed\n");
    }
    return is_done;
}

}  // namespace

void require_drawable(const std::string& script, const fs::path& folder) {
    script_path(script);
    if (folder.string().find('\'') != std::string::npos) {  // the scripts quote names so
        throw SceneError(fmt::format(
            "pictures are drawn in no folder with an apostrophe in its name, as --out {} has",
            folder.string()));
    }
}

void draw(const std::string& script, const std::vector<std::string>& arguments,
          const std::vector<fs::path>& made) {
    std::vector<std::string> words{"gnuplot", "-c", script_path(script).string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::fflush(stdout);
    const auto remove_made = [&made] {  // what an earlier run has left, and what is half drawn
        for (const fs::path& picture : made) {
            std::error_code ignored;
            fs::remove(picture, ignored);
        }
    };
    remove_made();
    if (run_program(words)) {
        for (const fs::path& picture : made) {
            fmt::print("picture      {}\n", nmbcgen::printable(picture.string()));
        }
    } else {
        remove_made();
        fmt::print("to draw it   {}\n", nmbcgen::printable(as_command(words)));
    }
}

void draw_run(const Scene& scene, const fs::path& folder) {
    const auto file = [&](const std::string& ending) {
        return (folder / (scene.name + ending)).string();
    };
    const std::string title = scene.title.empty() ? scene.name : scene.title;
    draw("energy.gp", {file("_energy"), file(".csv"), title},
         {file("_energy.svg"), file("_energy.png")});
    if (scene.field) {
        draw("spectrum.gp", {file("_spectrum"), file("_field.csv"), title},
             {file("_spectrum.svg"), file("_spectrum.png")});
    }
    if (scene.snapshots > 0) {
        draw("spacetime.gp", {"u", file("_spacetime"), file(".h5"), title},
             {file("_spacetime.png")});
    }
}

}  // namespace nmbcrun
