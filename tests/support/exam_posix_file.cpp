// SPDX-License-Identifier: GPL-2.0-or-later
// Files that several threads or processes make and remove.
#include <doctest/doctest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>

#include "generator/support/posix_file.hpp"

namespace {

TEST_CASE("a file is made although its folder is removed at the same time") {
    const auto folder =
        std::filesystem::temp_directory_path() / ("exam_posix_file_" + std::to_string(::getpid()));
    std::atomic<bool> is_done = false;
    std::thread other([&] {
        while (!is_done) {
            const nmbcgen::FolderOf made(folder / "other");
        }
    });
    for (int i = 0; i < 3000; ++i) {
        CHECK_NOTHROW(nmbcgen::NewFile(nmbcgen::PosixFile::create_beside(folder / "file").path(),
                                       folder / "file"));
        std::error_code ignored;  // the folder has to be the other's, at times
        std::filesystem::remove(folder, ignored);
    }
    is_done = true;
    other.join();
    std::filesystem::remove_all(folder);
}

}  // namespace
