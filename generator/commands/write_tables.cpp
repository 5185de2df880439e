// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/write_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "generator/emit/emit.hpp"
#include "generator/names/names.hpp"
#include "generator/pipeline.hpp"
#include "generator/support/certificate_cache.hpp"
#include "generator/support/progress_line.hpp"

namespace nmbcgen {

std::vector<Table> derived(const std::vector<Specification>& specifications) {
    ProgressLine line("nmbcgen: deriving");  // minutes beyond order 20
    std::vector<Table> tables;
    tables.reserve(specifications.size());
    for (const Specification& specification : specifications) {
        line(tables.size(), specifications.size());
        tables.push_back(derive(specification));
    }
    return tables;
}

std::vector<Table> certified(const std::vector<Specification>& specifications,
                             const std::optional<std::filesystem::path>& cache_folder) {
    std::vector<Table> tables = derived(specifications);
    if (cache_folder) {
        for (Table& table : tables) {
            CertificateCache(*cache_folder).look_up(table);
        }
    }
    const bool all_known = std::ranges::all_of(
        tables, [](const Table& table) { return table.certificate.has_value(); });
    ProgressLine line(tables.size() > 1 ? "nmbcgen: certifying"
                                        : "nmbcgen: certifying (--uncertified leaves it out)");
    certify_all(tables, std::ref(line));
    if (cache_folder && !all_known) {
        CertificateCache(*cache_folder).keep(tables);
    }
    return tables;
}

TextFile lattice_file(const std::filesystem::path& folder, const Table& table) {
    return {folder / (lattice_name(table.specification) + ".hpp"), emit_lattice_header(table)};
}

std::vector<TextFile> committed_files(const std::filesystem::path& folder,
                                      const std::optional<std::filesystem::path>& cache_folder) {
    const std::vector<Table> tables = certified(committed_set(), cache_folder);
    std::vector<TextFile> files;
    for (const Table& table : one_of_each_lattice(tables)) {
        files.push_back(lattice_file(folder, table));
    }
    for (const Table& table : tables) {
        files.push_back({folder / (table_name(table.specification) + ".hpp"), emit_header(table)});
    }
    files.push_back({folder / "tables.hpp", emit_registry(tables)});
    files.push_back({folder / "tables.json", emit_json(tables)});
    return files;
}

void write_and_name(const std::vector<TextFile>& files) {
    write_files(files);
    std::string names;
    for (const TextFile& file : files) {
        names += file.path.string() + "\n";
    }
    print(names);
}

void require_short_name(const std::string& name) {
    if (name.size() > longest_name) {
        throw FileError(fmt::format(
            "the name of the table has {} characters, of {} that a file may have: print it with "
            "--stdout",
            name.size(), longest_name));
    }
}

}  // namespace nmbcgen
