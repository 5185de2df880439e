// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/crack_pieces.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

namespace nmbcrun {
namespace {

constexpr int shortest_branch = 5;  // horizons
constexpr std::size_t none = SIZE_MAX;

}  // namespace

CrackPieces::CrackPieces(const std::vector<CrackedNode>& nodes, double horizon)
    : nodes_(&nodes), horizon_(horizon), neighbours_(nodes.size()), piece_of_(nodes.size(), none) {
    find_neighbours();
    find_pieces();
    join_pieces();
}

std::size_t CrackPieces::band_of(std::size_t node) const {
    return std::size_t((*nodes_)[node].distance / horizon_);
}

void CrackPieces::find_neighbours() {
    std::map<std::array<long, 2>, std::size_t> number;
    for (std::size_t i = 0; i < nodes_->size(); ++i) {
        number[(*nodes_)[i].place] = i;
    }
    for (std::size_t i = 0; i < nodes_->size(); ++i) {
        const auto& [x, y] = (*nodes_)[i].place;
        for (long dy = -gap; dy <= gap; ++dy) {
            for (long dx = -gap; dx <= gap; ++dx) {
                const auto found = number.find({x + dx, y + dy});
                if (found != number.end()) {
                    neighbours_[i].push_back(found->second);
                }
            }
        }
    }
}

void CrackPieces::find_pieces() {
    std::vector<std::size_t> outwards(nodes_->size());
    for (std::size_t i = 0; i < outwards.size(); ++i) {
        outwards[i] = i;
    }
    std::ranges::stable_sort(outwards, {}, [this](std::size_t node) { return band_of(node); });
    for (const std::size_t start : outwards) {
        if (piece_of_[start] != none) {
            continue;
        }
        Piece piece{.nodes = {start}, .band = band_of(start)};
        piece_of_[start] = pieces_.size();
        for (std::size_t next = 0; next < piece.nodes.size(); ++next) {
            for (const std::size_t other : neighbours_[piece.nodes[next]]) {
                if (piece_of_[other] == none && band_of(other) == piece.band) {
                    piece_of_[other] = pieces_.size();
                    piece.nodes.push_back(other);
                }
            }
        }
        pieces_.push_back(std::move(piece));
    }
}

void CrackPieces::join_pieces() {
    for (Piece& piece : pieces_) {
        for (const std::size_t i : piece.nodes) {
            const CrackedNode& node = (*nodes_)[i];
            if (node.distance < piece.from) {
                piece.from = node.distance;
                piece.nearest = node.X;
            }
            piece.deepest = std::max(piece.deepest, node.distance);
            for (const std::size_t other : neighbours_[i]) {
                const std::size_t beside = piece_of_[other];
                if (pieces_[beside].band == piece.band + 1 &&
                    std::ranges::find(piece.further, beside) == piece.further.end()) {
                    piece.further.push_back(beside);
                }
            }
        }
    }
    for (std::size_t p = pieces_.size(); p-- > 0;) {
        Piece& piece = pieces_[p];
        for (const std::size_t further : piece.further) {
            piece.deepest = std::max(piece.deepest, pieces_[further].deepest);
        }
    }
}

std::array<double, 2> CrackPieces::far_along(std::size_t way) const {
    std::vector<std::size_t> front{way};
    for (int band = 0; band < shortest_branch; ++band) {
        std::vector<std::size_t> next;
        for (const std::size_t piece : front) {
            for (const std::size_t further : pieces_[piece].further) {
                if (std::ranges::find(next, further) == next.end()) {
                    next.push_back(further);
                }
            }
        }
        if (!next.empty()) {  // five horizons may be a band less, by roundings
            front = next;
        }
    }
    std::array<double, 2> sum{};
    double count = 0;
    for (const std::size_t piece : front) {
        for (const std::size_t node : pieces_[piece].nodes) {
            sum[0] += (*nodes_)[node].X[0];
            sum[1] += (*nodes_)[node].X[1];
            count += 1;
        }
    }
    return {sum[0] / count, sum[1] / count};
}

std::vector<CrackBranch> CrackPieces::branches() const {
    std::vector<CrackBranch> branches;
    for (const Piece& piece : pieces_) {
        std::vector<std::size_t> ways;
        CrackBranch branch;
        for (const std::size_t further : piece.further) {
            const Piece& way = pieces_[further];
            if (way.deepest - way.from >= shortest_branch * horizon_) {
                ways.push_back(further);
                branch.X[0] += way.nearest[0];
                branch.X[1] += way.nearest[1];
            }
        }
        if (ways.size() < 2) {
            continue;
        }
        for (double& one : branch.X) {
            one /= double(ways.size());
        }
        for (const std::size_t way : ways) {
            branch.directions.push_back(degrees_from_x(pieces_[way].nearest, far_along(way)));
        }
        std::ranges::sort(branch.directions);
        branches.push_back(branch);
    }
    return branches;
}

long degrees_from_x(const std::array<double, 2>& from, const std::array<double, 2>& to) {
    const long angle =
        std::lround(std::atan2(to[1] - from[1], to[0] - from[0]) * 180 / std::numbers::pi);
    return angle == -180 ? 180 : angle;
}

}  // namespace nmbcrun
