// SPDX-License-Identifier: GPL-2.0-or-later
// What becomes of a run that cannot go on, or whose files cannot be published.
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/stoppable_run.hpp"

namespace {

namespace fs = std::filesystem;

class OneFile : public nmbcrun::RunFiles {
  public:
    explicit OneFile(const fs::path& folder)
        : RunFiles({.folder = folder,
                    .name = "shaky",
                    .energies_header = "time,total",
                    .others = {},
                    .inputs = {}},
                   "", {}) {
        begin();
    }
    void publish() { RunFiles::publish(copies()); }
};

struct Faults {
    bool publish = false;
    bool store = false;
    bool grows = false;
};

nmbcrun::AnyScene shaky_scene() {
    nmbcrun::AnyScene scene;
    scene.name = "shaky";
    return scene;
}

/// Of 20 steps.
class ShakyRun : public nmbcrun::StoppableRun {
  public:
    ShakyRun(const fs::path& folder, const Faults& faults, bool resume = false)
        : StoppableRun(shaky_scene(), {.folder = folder, .quiet = true, .resume = resume}),
          faults_(faults) {
        claim({{"scene", "shaky"}}, {.time_step = 1, .steps = 20, .cfl = 1});
        files_.emplace(folder);
    }

  private:
    std::size_t steps() const override { return steps_; }
    double time() const override { return double(steps_); }
    void advance(std::size_t steps) override { steps_ += steps; }
    std::vector<std::vector<double>> state() const override {
        if (faults_.store) {
            throw nmbcrun::FileError("no room for a checkpoint");
        }
        return {{1, 2, 3}};
    }
    void begin() override {}
    void look(bool /*is_row*/) override {
        if (faults_.grows) {
            throw nmbcrun::Unstable("it grows");
        }
    }
    void take_snapshot() override {}
    nmbcrun::RunFiles& files() override { return *files_; }
    void publish(bool /*at_end*/) override {
        if (faults_.publish) {
            throw nmbcrun::FileError("cannot write shaky.csv: no room");
        }
        files_->publish();
    }

    Faults faults_;
    std::size_t steps_ = 0;
    std::optional<OneFile> files_{};
};

class FolderOfRun {
  public:
    FolderOfRun() { fs::create_directories(path_); }
    ~FolderOfRun() { fs::remove_all(path_); }
    FolderOfRun(const FolderOfRun&) = delete;
    FolderOfRun& operator=(const FolderOfRun&) = delete;

    const fs::path& path() const { return path_; }
    bool has(const char* name) const { return fs::exists(path_ / name); }

  private:
    fs::path path_ =
        fs::temp_directory_path() / ("exam_stoppable_run_" + std::to_string(::getpid()));
};

/// What to_the_end() throws says this.
template <class Error>
void check_ends(const FolderOfRun& folder, const Faults& faults, const std::string& words) {
    ShakyRun run(folder.path(), faults);
    CHECK_THROWS_WITH_AS(run.to_the_end(), words.c_str(), Error);
}

TEST_CASE("a run without a fault leaves its energies, and no checkpoint") {
    const FolderOfRun folder;
    ShakyRun(folder.path(), {}).to_the_end();
    CHECK(folder.has("shaky.csv"));
    CHECK_FALSE(folder.has("shaky.checkpoint"));
}

TEST_CASE("where its files cannot be published a checkpoint is in their place, if it can be") {
    const FolderOfRun folder;
    check_ends<nmbcrun::FileError>(folder, {.publish = true, .store = true},
                                   "cannot write shaky.csv: no room. No checkpoint was stored, "
                                   "nothing is kept of this run");
    CHECK_FALSE(folder.has("shaky.checkpoint"));
    check_ends<nmbcrun::FileError>(folder, {.publish = true},
                                   "cannot write shaky.csv: no room. --resume goes on from " +
                                       (folder.path() / "shaky.checkpoint").string());
    CHECK(folder.has("shaky.checkpoint"));
    CHECK_FALSE(folder.has("shaky.csv"));
}

TEST_CASE("an unstable run says so, whether its energies can be written or not") {
    const FolderOfRun folder;
    check_ends<nmbcrun::Unstable>(folder, {.grows = true}, "it grows");
    CHECK(folder.has("shaky.csv"));
    fs::remove(folder.path() / "shaky.csv");
    check_ends<nmbcrun::Unstable>(
        folder, {.publish = true, .grows = true},
        "it grows. The energies up to there are lost: cannot write shaky.csv: no room");
    CHECK_FALSE(folder.has("shaky.csv"));
    CHECK_FALSE(folder.has("shaky.checkpoint"));
}

TEST_CASE("a checkpoint that is none of a run is refused") {
    const FolderOfRun folder;
    for (const auto& state :
         {std::vector<std::vector<double>>{}, std::vector<std::vector<double>>{{1, 2}}}) {
        nmbcrun::save_checkpoint(folder.path() / "shaky.checkpoint",
                                 {.scene = {{"scene", "shaky"}}, .steps = 3, .state = state});
        CHECK_THROWS_WITH_AS(ShakyRun(folder.path(), {}, true),
                             doctest::Contains("shaky.checkpoint is no checkpoint of a run"),
                             nmbcrun::FileError);
    }
}

}  // namespace
