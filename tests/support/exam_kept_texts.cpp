// SPDX-License-Identifier: GPL-2.0-or-later
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "generator/support/kept_texts.hpp"

namespace {

TEST_CASE("an answer is kept by its question, and anew where the file is damaged") {
    const auto folder =
        std::filesystem::temp_directory_path() / ("exam_kept_texts_" + std::to_string(::getpid()));
    int asked = 0;
    const auto answer = [&] {
        ++asked;
        return "the answer\nin two lines, the " + std::to_string(asked) + ".";
    };
    const nmbcgen::KeptTexts kept(folder);
    const std::string first = kept.text("a question", answer);
    CHECK(kept.text("a question", answer) == first);
    CHECK(asked == 1);
    CHECK(kept.text("another", answer) != first);
    CHECK(asked == 2);
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        std::ofstream(file.path()) << R"({"inputs": 1, "text": )";
    }
    CHECK(kept.text("a question", answer) != first);
    CHECK(asked == 3);
    CHECK_THROWS_AS(kept.text("none", []() -> std::string { throw std::domain_error("none"); }),
                    std::domain_error);
    CHECK(kept.text("none", answer).ends_with("the 4."));
    std::filesystem::remove_all(folder);
    CHECK(nmbcgen::KeptTexts(std::nullopt).text("a question", answer).ends_with("the 5."));
    CHECK(!std::filesystem::exists(folder));
}

}  // namespace
