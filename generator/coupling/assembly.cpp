// SPDX-License-Identifier: MIT
#include "generator/coupling/assembly.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

/// An entry of K.
struct Entry {
    std::size_t row;
    std::size_t column;
    Rational value;
};

/// Calls do_with(pair, other) for every element that points of this one reach.
template <class Do>
void for_each_partner(const Mesh& mesh, std::size_t element, const Do& do_with) {
    const Rational& delta = mesh.media[element].horizon;
    const Rational end = mesh.nodes[element + 1];
    std::size_t first = element;
    while (first > 0 && mesh.nodes[element] - mesh.nodes[first] < delta) {
        --first;
    }
    for (std::size_t other = first;
         other < mesh.media.size() && (other <= element || mesh.nodes[other] - end < delta);
         ++other) {
        do_with(ElementPair{mesh.length(element), mesh.nodes[other] - mesh.nodes[element],
                            mesh.length(other), delta},
                other);
    }
}

/// The nodes of a pair's matrix.
std::vector<std::size_t> nodes_of(std::size_t element, std::size_t other) {
    if (element == other) {
        return {element, element + 1};
    }
    return {element, element + 1, other, other + 1};
}

/// A spring on one node's row.
void add_spring(std::vector<Entry>& entries, std::size_t node, std::size_t other,
                const Rational& spring) {
    entries.push_back({node, node, spring});
    entries.push_back({node, other, -spring});
}

std::vector<Entry> local_entries(const Mesh& mesh, CouplingForm form, std::size_t element) {
    const Rational& k = mesh.media[element].stiffness;
    std::vector<Entry> entries;
    for (const auto& [node, other] : {std::pair(element, element + 1), {element + 1, element}}) {
        const Rational spring = k / mesh.length(element);
        if (form == CouplingForm::pairs || node == 0 || node == mesh.media.size()) {
            add_spring(entries, node, other, spring);
            continue;
        }
        const std::size_t beyond = node < other ? node - 1 : node + 1;
        add_spring(entries, node, other, spring / 2);
        add_spring(entries, node, beyond, k / mesh.length(std::min(node, beyond)) / 2);
    }
    return entries;
}

/// Calls of_pair(element, pair, nodes) for every pair of elements and of_entry(entry) for what
/// local ones add.
template <class OfPair, class OfEntry>
void for_each_part(const Mesh& mesh, CouplingForm form, const OfPair& of_pair,
                   const OfEntry& of_entry) {
    for (std::size_t element = 0; element < mesh.media.size(); ++element) {
        if (mesh.media[element].horizon > 0) {
            for_each_partner(mesh, element, [&](const ElementPair& pair, std::size_t other) {
                of_pair(element, pair, nodes_of(element, other));
            });
        } else {
            std::ranges::for_each(local_entries(mesh, form, element), of_entry);
        }
    }
}

/// pair_matrix(), exact or in doubles: uniform parts of a mesh have the same pairs again and again.
template <class Number>
class PairMatrices {
  public:
    explicit PairMatrices(CouplingForm form) : form_(form) {}

    const std::vector<Number>& of(const ElementPair& pair) {
        const auto [place, is_new] = known_.try_emplace(pair);
        if (is_new) {
            for (const LogNumber& exact : pair_matrix(pair, form_)) {
                if constexpr (std::is_same_v<Number, double>) {
                    place->second.push_back(nearest_double(exact));
                } else {
                    place->second.push_back(exact);
                }
            }
        }
        return place->second;
    }

  private:
    CouplingForm form_;
    std::map<ElementPair, std::vector<Number>> known_;
};

}  // namespace

SparseMatrix stiffness_of(const Mesh& mesh, CouplingForm form) {
    std::vector<Eigen::Triplet<double>> triplets;
    PairMatrices<double> matrices(form);
    for_each_part(
        mesh, form,
        [&](std::size_t element, const ElementPair& pair, const std::vector<std::size_t>& nodes) {
            const double k = nearest_double(mesh.media[element].stiffness);
            const std::vector<double>& matrix = matrices.of(pair);
            for (std::size_t i = 0; i < matrix.size(); ++i) {
                triplets.emplace_back(int(nodes[i / nodes.size()]), int(nodes[i % nodes.size()]),
                                      k * matrix[i]);
            }
        },
        [&](const Entry& entry) {
            triplets.emplace_back(int(entry.row), int(entry.column), nearest_double(entry.value));
        });
    const auto size = Eigen::Index(mesh.nodes.size());
    SparseMatrix matrix(size, size);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

std::vector<ExactRow> exact_rows(const Mesh& mesh, CouplingForm form, std::size_t first,
                                 std::size_t last) {
    std::vector<ExactRow> rows(last - first + 1);
    PairMatrices<LogNumber> matrices(form);
    const auto is_asked_for = [&](std::size_t node) { return node >= first && node <= last; };
    for_each_part(
        mesh, form,
        [&](std::size_t element, const ElementPair& pair, const std::vector<std::size_t>& nodes) {
            if (std::ranges::none_of(nodes, is_asked_for)) {
                return;
            }
            const std::vector<LogNumber>& matrix = matrices.of(pair);
            for (std::size_t i = 0; i < matrix.size(); ++i) {
                if (const std::size_t node = nodes[i / nodes.size()]; is_asked_for(node)) {
                    rows[node - first][nodes[i % nodes.size()]] +=
                        mesh.media[element].stiffness * matrix[i];
                }
            }
        },
        [&](const Entry& entry) {
            if (is_asked_for(entry.row)) {
                rows[entry.row - first][entry.column] += {entry.value, {}};
            }
        });
    for (ExactRow& row : rows) {
        std::erase_if(row, [](const auto& entry) { return entry.second == LogNumber{}; });
    }
    return rows;
}

Eigen::VectorXd masses_of(const Mesh& mesh) {
    Eigen::VectorXd masses = Eigen::VectorXd::Zero(Eigen::Index(mesh.nodes.size()));
    for (std::size_t element = 0; element < mesh.media.size(); ++element) {
        const double half = nearest_double(mesh.length(element)) / 2;
        masses[Eigen::Index(element)] += half;
        masses[Eigen::Index(element) + 1] += half;
    }
    return masses;
}

std::vector<LogNumber> uniform_stencil(const Rational& horizon) {
    if (horizon < 0 || horizon > largest_coupling_horizon) {
        throw std::invalid_argument("no such horizon of elements");
    }
    // The row reaches ceil(horizon) + 1 nodes, and depends on elements as far away.
    const auto elements = (floor(horizon) + 3).convert_to<std::size_t>();
    const Medium medium{1, horizon};
    std::vector<LogNumber> stencil;
    const Mesh mesh = mesh_of({1, 1, medium, medium}, elements, elements);
    const auto rows = exact_rows(mesh, CouplingForm::pairs, elements, elements);
    for (const auto& [node, entry] : rows.front()) {
        if (node >= elements) {
            stencil.push_back(entry);
        }
    }
    return stencil;
}

}  // namespace nmbcgen
