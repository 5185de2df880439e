// SPDX-License-Identifier: MIT
#include "generator/support/certificate_cache.hpp"

#include "generator/emit/certificate_json.hpp"
#include "generator/emit/emit.hpp"
#include "generator/names/names.hpp"
#include "generator/support/files.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

/// Everything the certificate depends on.
Json inputs(Table table) {
    table.certificate.reset();
    return {{"code", NMBC_CERTIFYING_CODE}, {"table", emit_json(table)}};
}

/// Cut where a name is longer than a file's may be: what is kept says of which table it is.
std::filesystem::path file_of(const std::filesystem::path& folder, const Table& table) {
    const std::string ending = ".json";
    return folder /
           (table_name(table.specification).substr(0, longest_name - ending.size()) + ending);
}

}  // namespace

void CertificateCache::look_up(Table& table) const {
    const auto text = read_file(file_of(folder_, table));
    if (!text) {
        return;
    }
    try {
        const Json kept = Json::parse(*text);
        if (kept.at("inputs") == inputs(table)) {
            table.certificate = read_certificate(kept);
        }
    } catch (const std::exception&) {
        // Cut short, damaged or of another time: as if it were not there.
    }
}

void CertificateCache::keep(const std::vector<Table>& tables) const {
    std::vector<TextFile> files;
    for (const Table& table : tables) {
        const bool damped = table.specification.damping > 0;
        const Json kept = {
            {"inputs", inputs(table)},
            {"windows", windows_object(*table.certificate, damped)},
            {"poles", poles_array(*table.certificate)},
            {"max_cfl", steps_array(table.certificate->max_cfl)},
            {"max_cfl_contractive", steps_array(table.certificate->max_cfl_contractive)},
            {"least_nodes", table.certificate->least_nodes},
            {"evidence", evidence_object(*table.certificate, damped)}};
        files.push_back({file_of(folder_, table), kept.dump(1) + "\n"});
    }
    write_files(files);
}

}  // namespace nmbcgen
