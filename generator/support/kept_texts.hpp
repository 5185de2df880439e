// SPDX-License-Identifier: MIT
/// Answers that took long, kept from one run to the next: nmbcgen --cache.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace nmbcgen {

/// A folder with one file an answer. A file counts only where the question and the source code that
/// answered it are what they are now; others are ignored, and written anew.
class KeptTexts {
  public:
    /// Without a folder nothing is kept.
    explicit KeptTexts(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {}

    /// The kept answer to a question, or what `make` answers, which is kept. Throws as that does,
    /// and FileError where the folder cannot be written to.
    std::string text(const std::string& question, const std::function<std::string()>& make) const;

  private:
    std::optional<std::filesystem::path> folder_;
};

}  // namespace nmbcgen
