// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/table_reader.hpp"

#include <fmt/format.h>

#include <limits>
#include <span>
#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/names/names.hpp"
#include "tools/nmbcrun/scene/exact_json.hpp"

namespace nmbcrun {
namespace {

constexpr double highest = std::numeric_limits<double>::max();

class TableReader {
  public:
    TableReader(const JsonValue& json, OwnLattice lattice, TableStorage& storage);

    OwnTable read();

  private:
    std::span<const nmbc::RationalFunction> functions(const char* key, std::size_t size);
    std::span<const nmbc::Window> windows(const char* key);
    std::span<const nmbc::StableStep> steps(const char* key);

    const JsonValue& json_;
    const nmbc::LatticeTable& lattice_;
    nmbcgen::Specification what_;
    TableStorage& storage_;
};

TableReader::TableReader(const JsonValue& json, OwnLattice lattice, TableStorage& storage)
    : json_(json), lattice_(*lattice.table), what_(std::move(lattice.what)), storage_(storage) {
    what_.order = unsigned(json.at("order").whole_number(1, nmbcgen::highest_count));
    what_.stride = unsigned(json.at("stride").whole_number(1, nmbcgen::highest_count));
    what_.time_step = parameter_of(json.at("time_step"));
    if (!json.at("G").is_null()) {
        what_.stabilisation = parameter_of(json.at("G"));
    }
}

std::span<const nmbc::RationalFunction> TableReader::functions(const char* key, std::size_t size) {
    const JsonValue json = json_.at(key);
    const std::vector<JsonValue> elements = json.elements();
    if (elements.size() != size) {
        json.must_be(fmt::format("a list of {}", size));
    }
    auto& list = storage_.functions.emplace_back();
    for (const JsonValue& element : elements) {
        list.push_back(storage_.keep(what_.stabilisation ? fraction_of(element)
                                                         : rational_function_of(element)));
    }
    return list;
}

std::span<const nmbc::Window> TableReader::windows(const char* key) {
    auto& list = storage_.windows.emplace_back();
    const JsonValue all = json_.at("windows");
    if (all.is_null() || all.at(key).is_null()) {  // not sought
        return list;
    }
    for (const JsonValue& window : all.at(key).elements()) {
        const std::vector<JsonValue> edges = window.elements();
        if (edges.size() != 2) {
            window.must_be("a list of 2");
        }
        const double low = edges[0].at("value").number(0, highest);
        list.push_back({low, edges[1].is_null() ? nmbc::unbounded
                                                : edges[1].at("value").number(low, highest)});
    }
    return list;
}

std::span<const nmbc::StableStep> TableReader::steps(const char* key) {
    auto& list = storage_.steps.emplace_back();
    const JsonValue all = json_.at(key);
    if (all.is_null()) {  // not sought
        return list;
    }
    for (const JsonValue& piece : all.elements()) {
        const double low = piece.at("low").number(0, highest);
        const double high =
            piece.at("high").is_null() ? nmbc::unbounded : piece.at("high").number(low, highest);
        const double cfl = piece.at("cfl").number(0, 1);
        list.push_back({{low, high}, cfl, piece.at("from").number(0, cfl)});
    }
    return list;
}

OwnTable TableReader::read() {
    const JsonValue least_nodes = json_.at("least_nodes");
    const std::string matched =
        json_.has("match") ? ", matched at " + json_.at("match").text() : "";
    const auto& G = what_.stabilisation;
    OwnTable own{.table = {.name = storage_.keep(table_name(what_) + matched),
                           .lattice = &lattice_,
                           .order = int(what_.order),
                           .stride = int(what_.stride),
                           .fixed_G = storage_.keep(G ? nmbcgen::to_string(*G) : ""),
                           .time_step = storage_.keep(nmbcgen::to_string(what_.time_step)),
                           .source = storage_.keep(json_.at("source").text()),
                           .proved = storage_.keep(json_.at("proved").text()),
                           .taylor = functions("taylor", 2 * what_.order + 1),
                           .c = functions("c", what_.order + 1),
                           .b = functions("b", what_.order + 1),
                           .reflection = windows("reflection"),
                           .modal = windows("modal"),
                           .contractive = windows("contractive"),
                           .max_cfl = steps("max_cfl"),
                           .max_cfl_contractive = steps("max_cfl_contractive"),
                           .least_nodes =
                               least_nodes.is_null()
                                   ? 0
                                   : least_nodes.whole_number(0, std::numeric_limits<int>::max())},
                 .is_certified = !json_.at("certificate").is_null()};
    const nmbc::MatchingTable& table = own.table;
    if (table.c[0] != nmbc::RationalFunction{"1", "1"}) {
        json_.at("c").must_be("a list that begins with 1");
    }
    if (own.is_certified) {
        json_.at("certificate").text();
    } else if (!table.reflection.empty() || !table.modal.empty() || !table.contractive.empty() ||
               !table.max_cfl.empty() || !table.max_cfl_contractive.empty()) {
        json_.at("certificate").must_be("a string where there are windows and steps");
    }
    return own;
}

}  // namespace

OwnTable read_table(const JsonValue& json, OwnLattice lattice, TableStorage& storage) {
    return TableReader(json, std::move(lattice), storage).read();
}

}  // namespace nmbcrun
