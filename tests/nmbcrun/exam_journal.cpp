// SPDX-License-Identifier: GPL-2.0-or-later
// The files that grow while a run lasts, on a disk that is full for a while.
#include <doctest/doctest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/energies_file.hpp"
#include "tools/nmbcrun/output/journal.hpp"

namespace {

/// A folder of its own, which goes with it.
class Folder {
  public:
    Folder()
        : path_(std::filesystem::temp_directory_path() /
                ("exam_journal_" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path operator/(const char* name) const { return path_ / name; }
    std::ptrdiff_t files() const {
        return std::distance(std::filesystem::directory_iterator(path_), {});
    }

  private:
    std::filesystem::path path_;
};

/// As long as it is there, no file gets longer than so many bytes.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        set({bytes, before_.rlim_max});
    }
    ~FullDisk() {
        set(before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    static void set(const rlimit& limit) { ::setrlimit(RLIMIT_FSIZE, &limit); }

    void (*handler_)(int);
    rlimit before_{};
};

std::string text_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void publish(nmbcgen::NewFile file) {
    nmbcgen::publish({&file, 1});
}

}  // namespace

TEST_CASE("a journal that could be written in part only is whole when there is space again") {
    const Folder folder;
    const std::string text(100'000, 'x');
    nmbcrun::Journal journal(folder / "run.csv");
    journal.append("time\n");
    {
        const FullDisk disk(1000);
        CHECK_THROWS_AS(journal.append(text), nmbcrun::FileError);
        CHECK_THROWS_AS(journal.sync(), nmbcrun::FileError);
    }
    publish(journal.copy());
    CHECK(text_of(folder / "run.csv") == "time\n" + text);
}

TEST_CASE("a copy that cannot be written leaves what was published, and nothing of its own") {
    const Folder folder;
    nmbcrun::Journal journal(folder / "run.csv");
    journal.append("time\n");
    publish(journal.copy());
    journal.append("1\n");
    journal.source();
    {
        const FullDisk disk(6);
        CHECK_THROWS_AS(journal.copy(), nmbcrun::FileError);
    }
    CHECK(folder.files() == 2);  // it and the journal
    CHECK(text_of(folder / "run.csv") == "time\n");
    journal.copy();  // not published
    CHECK(folder.files() == 2);
    publish(journal.copy());
    CHECK(text_of(folder / "run.csv") == "time\n1\n");
}

TEST_CASE("a row of energies has all of its columns, or is none") {
    const Folder folder;
    const auto samples_of = [&](const std::string& row) {
        std::ofstream(folder / "run.csv")
            << nmbcrun::energies_head("", nmbcrun::energies_header) << row;
        std::vector<nmbcrun::Sample> samples;
        nmbcrun::read_energies(
            folder / "run.csv", nmbcrun::energies_header, [](std::size_t /*row*/) { return true; },
            [&](const std::vector<double>& numbers) {
                samples.push_back(nmbcrun::sample_of(numbers));
            });
        return samples;
    };
    const nmbcrun::Sample sample{.time = 0.5, .energies = {}, .balance = {.drift = 7}};
    const std::string row = nmbcrun::energies_row(sample);
    REQUIRE(samples_of(row).size() == 1);
    CHECK(samples_of(row).front().balance.drift == 7);
    for (const std::string& bad : {row.substr(0, row.size() - 3), row.substr(0, 3), "0," + row,
                                   row.substr(0, row.size() - 2) + "x", std::string("\n")}) {
        CHECK_THROWS_AS(samples_of(bad), nmbcrun::FileError);
    }
}

TEST_CASE("folders are made, however many, and a name without one is in the working folder") {
    const Folder folder;
    publish(nmbcrun::Journal(folder / "a/b/../c/run.csv").copy());
    CHECK(text_of(folder / "a/c/run.csv").empty());
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder / "a");
    CHECK_NOTHROW(publish(nmbcrun::Journal("run.csv").copy()));
    std::filesystem::current_path(before);
    CHECK(std::filesystem::exists(folder / "a/run.csv"));
    CHECK_THROWS_AS(nmbcrun::Journal(folder / "a/run.csv/b/run.csv"), nmbcrun::FileError);
}

TEST_CASE("a folder is in the way of a file, of a file nothing is") {
    const Folder folder;
    CHECK_NOTHROW(nmbcgen::require_replaceable(folder / "run.csv"));
    std::filesystem::create_directory(folder / "run.csv");
    CHECK_THROWS_AS(nmbcgen::require_replaceable(folder / "run.csv"), nmbcrun::FileError);
    CHECK_THROWS_AS(nmbcrun::Journal(folder / "run.csv"), nmbcrun::FileError);
    CHECK(folder.files() == 1);
    std::filesystem::remove(folder / "run.csv");
    publish(nmbcrun::Journal(folder / "run.csv").copy());
    CHECK_NOTHROW(nmbcgen::require_replaceable(folder / "run.csv"));
    CHECK(folder.files() == 1);
}
