// SPDX-License-Identifier: MIT
/// Which bonds of a plane lattice hold, and which of them may break: a bit each at both of their
/// ends.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nmbc/bond_model.hpp>
#include <nmbc/plane_block.hpp>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nmbc {

using PlanePoint = std::array<double, 2>;  ///< [dX]

namespace detail {

/// The bonds (+-x, +-y), whose bits follow each other in one word of a node.
struct BondGroup {
    double weight = 0;
    std::array<PlaneOffset, 4> members{};  ///< the opposite of member m is number size - 1 - m
    unsigned size = 0;                     ///< 4, or 2 where x or y is 0
    std::size_t word = 0;
    unsigned first_bit = 0;

    PlaneOffset first() const { return members[0]; }  ///< x and y, not below 0
};

/// Shortest bonds first.
inline std::vector<BondGroup> bond_groups(const BondModel& model) {
    std::vector<BondGroup> groups;
    for (const auto& [bond, weight] : model.bonds()) {
        const auto [x, y] = bond;
        if (x > 0 && y > 0) {
            groups.push_back({weight, {{{x, y}, {x, -y}, {-x, y}, {-x, -y}}}, 4});
        } else if (x >= 0 && y >= 0) {
            groups.push_back({weight, {{{x, y}, {-x, -y}}}, 2});
        }
    }
    std::ranges::stable_sort(groups, {}, [](const BondGroup& group) {
        return group.first().x * group.first().x + group.first().y * group.first().y;
    });
    constexpr unsigned bits = 32;
    std::size_t word = 0;
    unsigned next = 0;
    for (BondGroup& group : groups) {
        if (next + group.size > bits) {
            ++word;
            next = 0;
        }
        group.word = word;
        group.first_bit = next;
        next += group.size;
    }
    return groups;
}

/// Whether the line from one point to another meets the bond from node to node: an end of either on
/// the other counts, a bond along the line does not.
inline bool meets(const std::array<PlanePoint, 2>& line, const std::array<PlanePoint, 2>& bond) {
    constexpr double roundings = 1e-9;  // [dX]
    const auto side_of = [](const std::array<PlanePoint, 2>& of, const PlanePoint& point) {
        const double x = of[1][0] - of[0][0];
        const double y = of[1][1] - of[0][1];
        const double distance =
            (x * (point[1] - of[0][1]) - y * (point[0] - of[0][0])) / std::hypot(x, y);
        return distance > roundings ? 1 : distance < -roundings ? -1 : 0;
    };
    const std::array<int, 2> of_bond{side_of(line, bond[0]), side_of(line, bond[1])};
    const std::array<int, 2> of_line{side_of(bond, line[0]), side_of(bond, line[1])};
    const bool is_along = of_bond[0] == 0 && of_bond[1] == 0;
    return !is_along && of_bond[0] * of_bond[1] <= 0 && of_line[0] * of_line[1] <= 0;
}

/// Word: of 32 bits at least, as wide as what its sweeps read beside it.
template <class Word>
class BondStates {
  public:
    /// All hold that the sides leave, and none may break.
    BondStates(const BondModel& model, std::array<PlaneAxis, 2> axes)
        : groups_(bond_groups(model)),
          axes_(std::move(axes)),
          nodes_{axes_[0].nodes(), axes_[1].nodes()} {
        const auto count = static_cast<std::size_t>(nodes_[0] * nodes_[1]);
        for (const BondGroup& group : groups_) {
            family_ += static_cast<int>(group.size);
        }
        held_.assign(groups_.back().word + 1, std::vector<Word>(count, 0));
        breakable_ = held_;
        for_each([this](std::ptrdiff_t x, std::ptrdiff_t y, const BondGroup& group, unsigned m) {
            if (is_whole(x, y, group.members[m])) {
                held_[group.word][index(x, y)] |= bit(group, m);
            }
        });
    }

    const std::array<PlaneAxis, 2>& axes() const { return axes_; }
    const std::vector<BondGroup>& groups() const { return groups_; }
    static Word bit(const BondGroup& group, unsigned member) {
        return Word{1} << (group.first_bit + member);
    }

    /// Of a node of the body, which is (0, 0) in the corner of its layers.
    std::size_t index(std::ptrdiff_t x, std::ptrdiff_t y) const {
        return static_cast<std::size_t>(y * nodes_[0] + x);
    }
    std::vector<Word>& held(std::size_t word) { return held_[word]; }
    const std::vector<Word>& held(std::size_t word) const { return held_[word]; }
    const std::vector<Word>& breakable(std::size_t word) const { return breakable_[word]; }

    /// The node itself or, of an image, the node of the body that it is one of.
    std::array<std::ptrdiff_t, 2> original(std::ptrdiff_t x, std::ptrdiff_t y) const {
        return {axes_[0].original(x), axes_[1].original(y)};
    }
    bool is_in_body(const std::array<std::ptrdiff_t, 2>& node) const {
        return node[0] >= 0 && node[0] < nodes_[0] && node[1] >= 0 && node[1] < nodes_[1];
    }

    /// Of this body or, beyond a halo, of another block.
    bool is_material(const std::array<std::ptrdiff_t, 2>& node) const {
        return axes_[0].is_material(node[0]) && axes_[1].is_material(node[1]);
    }

    /// Of a node of the body.
    bool holds(std::ptrdiff_t x, std::ptrdiff_t y, const BondGroup& group, unsigned member) const {
        return (held_[group.word][index(x, y)] & bit(group, member)) != 0;
    }

    /// The part of a node's bonds that no longer hold.
    double damage(std::ptrdiff_t x, std::ptrdiff_t y) const {
        int held = 0;
        for (const std::vector<Word>& word : held_) {
            held += std::popcount(word[index(x, y)]);
        }
        if (held == family_) {
            return 0;
        }
        int whole = 0;
        for (const BondGroup& group : groups_) {
            for (unsigned m = 0; m < group.size; ++m) {
                whole += is_whole(x, y, group.members[m]) ? 1 : 0;
            }
        }
        return whole == 0 ? 0 : 1 - static_cast<double>(held) / whole;
    }

    /// Breaks the bonds that meet the line, whose points are those of the body's nodes, or one of
    /// its images beyond the sides.
    void cut(const PlanePoint& from, const PlanePoint& to) {
        for (const auto& [sign_y, shift_y] : images(axes_[1])) {
            for (const auto& [sign_x, shift_x] : images(axes_[0])) {
                cut_once({PlanePoint{sign_x * from[0] + shift_x, sign_y * from[1] + shift_y},
                          PlanePoint{sign_x * to[0] + shift_x, sign_y * to[1] + shift_y}});
            }
        }
    }

    /// From here on all bonds that hold may break, but for those of nodes for which keep(x, y).
    template <class Keep>
    void let_break(const Keep& keep) {
        std::vector<bool> kept(held_[0].size());
        for (std::ptrdiff_t y = 0; y < nodes_[1]; ++y) {
            for (std::ptrdiff_t x = 0; x < nodes_[0]; ++x) {
                kept[index(x, y)] = keep(x, y);
            }
        }
        for_each([&](std::ptrdiff_t x, std::ptrdiff_t y, const BondGroup& group, unsigned m) {
            const auto other = original(x + group.members[m].x, y + group.members[m].y);
            const bool is_kept =
                kept[index(x, y)] ||
                (is_in_body(other) ? kept[index(other[0], other[1])] : keep(other[0], other[1]));
            const Word one = bit(group, m);
            Word& breakable = breakable_[group.word][index(x, y)];
            breakable = static_cast<Word>(is_kept ? breakable & ~one : breakable | one);
        });
    }

    /// For a checkpoint: word by word.
    std::vector<std::uint32_t> state() const {
        std::vector<std::uint32_t> all;
        for (const std::vector<Word>& word : held_) {
            for (const Word bits : word) {
                all.push_back(static_cast<std::uint32_t>(bits));
            }
        }
        return all;
    }
    std::size_t state_size() const { return held_.size() * held_[0].size(); }
    /// Throws std::invalid_argument where a bond holds that the body does not have.
    void resume(std::span<const std::uint32_t> state) {
        for_each([&](std::ptrdiff_t x, std::ptrdiff_t y, const BondGroup& group, unsigned m) {
            if (!is_whole(x, y, group.members[m]) &&
                (state[group.word * held_[0].size() + index(x, y)] & bit(group, m)) != 0) {
                throw std::invalid_argument("the state of a plane with other sides");
            }
        });
        for (std::vector<Word>& word : held_) {
            std::ranges::copy(state.first(word.size()), word.begin());
            state = state.subspan(word.size());
        }
    }

  private:
    /// Where the images of a place p of the body are, itself included: sign * p + shift.
    struct Image {
        double sign;
        double shift;
    };
    static std::vector<Image> images(const PlaneAxis& axis) {
        const auto nodes = static_cast<double>(axis.nodes());
        if (axis.is_periodic()) {
            return {{1, -nodes}, {1, 0}, {1, nodes}};
        }
        std::vector<Image> all{{1, 0}};
        if (axis.has_images(0)) {
            all.push_back({-1, -1});
        }
        if (axis.has_images(1)) {
            all.push_back({-1, 2 * nodes - 1});
        }
        return all;
    }

    /// Calls work(x, y, group, member) for the bonds of the body's nodes between two of them, both
    /// included.
    template <class Work>
    void for_each_between(const std::array<std::ptrdiff_t, 2>& low,
                          const std::array<std::ptrdiff_t, 2>& high, const Work& work) const {
        for (std::ptrdiff_t y = std::max<std::ptrdiff_t>(low[1], 0);
             y <= std::min(high[1], nodes_[1] - 1); ++y) {
            for (std::ptrdiff_t x = std::max<std::ptrdiff_t>(low[0], 0);
                 x <= std::min(high[0], nodes_[0] - 1); ++x) {
                for (const BondGroup& group : groups_) {
                    for (unsigned m = 0; m < group.size; ++m) {
                        work(x, y, group, m);
                    }
                }
            }
        }
    }

    template <class Work>
    void for_each(const Work& work) const {
        for_each_between({0, 0}, nodes_, work);
    }

    void cut_once(const std::array<PlanePoint, 2>& line) {
        std::array<std::ptrdiff_t, 2> low{};
        std::array<std::ptrdiff_t, 2> high{};
        for (const std::size_t axis : {0U, 1U}) {
            const auto ends = std::minmax(line[0][axis], line[1][axis]);
            const auto far = static_cast<double>(nodes_[axis]);
            const auto reach =
                static_cast<double>(groups_.back().first().x + groups_.back().first().y);
            low[axis] = static_cast<std::ptrdiff_t>(std::clamp(ends.first - reach - 1, 0.0, far));
            high[axis] = static_cast<std::ptrdiff_t>(std::clamp(ends.second + reach + 1, 0.0, far));
        }
        for_each_between(
            low, high, [&](std::ptrdiff_t x, std::ptrdiff_t y, const BondGroup& group, unsigned m) {
                const PlanePoint here{static_cast<double>(x), static_cast<double>(y)};
                if (meets(line,
                          {here, {here[0] + group.members[m].x, here[1] + group.members[m].y}})) {
                    held_[group.word][index(x, y)] &= static_cast<Word>(~bit(group, m));
                }
            });
    }

    /// Whether the node has a neighbour there before anything breaks.
    bool is_whole(std::ptrdiff_t x, std::ptrdiff_t y, const PlaneOffset& bond) const {
        const auto fits = [](const PlaneAxis& axis, std::ptrdiff_t node, int step) {
            return std::abs(step) <= axis.neighbours(step > 0, node);
        };
        return fits(axes_[0], x, bond.x) && fits(axes_[1], y, bond.y);
    }

    std::vector<BondGroup> groups_;
    int family_ = 0;  // bonds of a node that lacks none
    std::array<PlaneAxis, 2> axes_;
    std::array<std::ptrdiff_t, 2> nodes_;
    std::vector<std::vector<Word>> held_;
    std::vector<std::vector<Word>> breakable_;
};

}  // namespace detail

}  // namespace nmbc
