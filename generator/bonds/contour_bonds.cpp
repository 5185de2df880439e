// SPDX-License-Identifier: MIT
#include "generator/bonds/contour_bonds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <stdexcept>

#include "generator/exact/echelon.hpp"

namespace nmbcgen {
namespace {

/// Along one line of the contour, over k = 0 .. pi: omega^2 of a wave, or of the sum of both, as
/// the sum over classes a of w_a times the sum over m of cosines[a][m] cos(m k), and the solid's as
/// constant pi^2 + square k^2.
struct Branch {
    bool is_diagonal = false;  ///< k_x = k_y = k, else one of both is k
    Rows<Rational> cosines{};
    Rational constant = 0;
    Rational square = 0;

    Branch& operator+=(const Branch& other) {
        for (std::size_t a = 0; a < cosines.size(); ++a) {
            for (std::size_t m = 0; m < cosines[a].size(); ++m) {
                cosines[a][m] += other.cosines[a][m];
            }
        }
        constant += other.constant;
        square += other.square;
        return *this;
    }
};

enum class Line { om, my, yo };

/// What a bond adds: the share (1 - sign cos(m k)).
struct Addition {
    Rational share;
    int sign;
    int m;
};

/// The waves' directions are (1, 0) and (0, 1) on OM and MY, (1, 1) and (1, -1) on YO.
Addition addition(Line line, std::size_t wave, int i, int j) {
    if (line == Line::yo) {
        const int along = wave == 0 ? i + j : i - j;
        return {Rational(along * along, 2), 1, std::abs(i + j)};
    }
    const int along = wave == 0 ? i : j;
    return {Rational(along * along), line == Line::my && i % 2 != 0 ? -1 : 1,
            std::abs(line == Line::om ? i : j)};
}

Branch branch_of(Line line, std::size_t wave, const std::vector<BondClass>& classes) {
    const Rational& speed = squared_speeds[wave];
    Branch branch{.is_diagonal = line == Line::yo,
                  .constant = line == Line::my ? speed : Rational(0),
                  .square = line == Line::yo ? Rational(2 * speed) : speed};
    int highest = 0;
    for (const auto& [i, j] : classes) {
        highest = std::max(highest, i + j);
    }
    for (const BondClass& bonds : classes) {
        std::vector<Rational> cosines(std::size_t(highest) + 1);
        for (const auto& [i, j] : members(bonds)) {
            const Addition added = addition(line, wave, i, j);
            cosines[0] += added.share;
            cosines[std::size_t(added.m)] -= added.sign * added.share;
        }
        branch.cosines.push_back(cosines);
    }
    return branch;
}

/// OM, MY, YO: of both waves, one after the other, or of their sum.
std::vector<Branch> branches_of(const std::vector<BondClass>& classes, bool are_apart) {
    std::vector<Branch> branches;
    for (const Line line : {Line::om, Line::my, Line::yo}) {
        branches.push_back(branch_of(line, 0, classes));
        const Branch transverse = branch_of(line, 1, classes);
        if (are_apart) {
            branches.push_back(transverse);
        } else {
            branches.back() += transverse;
        }
    }
    return branches;
}

/// The integral along the contour, over pi, of class a's part of R times what class b adds.
Quadratic product(const std::vector<Branch>& branches, std::size_t a, std::size_t b) {
    Quadratic sum = 0;
    for (const Branch& branch : branches) {
        Rational mean = branch.cosines[a][0] * branch.cosines[b][0];
        for (std::size_t m = 1; m < branch.cosines[a].size(); ++m) {
            mean += branch.cosines[a][m] * branch.cosines[b][m] / 2;
        }
        sum += Quadratic(mean) * (branch.is_diagonal ? square_root(2) : Quadratic(1));
    }
    return sum;
}

/// The same of the solid's omega^2 and class a: factors of 1 and pi^2.
std::array<Quadratic, 2> wanted(const std::vector<Branch>& branches, std::size_t a) {
    std::array<Quadratic, 2> sum{};
    for (const Branch& branch : branches) {
        std::array<Rational, 2> mean{0, branch.constant * branch.cosines[a][0]};
        for (std::size_t m = 0; m < branch.cosines[a].size(); ++m) {
            const std::array<Rational, 2> of_square = mean_of_square_times_cosine(int(m));
            for (const std::size_t power : {0U, 1U}) {
                mean[power] += branch.square * branch.cosines[a][m] * of_square[power];
            }
        }
        for (const std::size_t power : {0U, 1U}) {
            sum[power] +=
                Quadratic(mean[power]) * (branch.is_diagonal ? square_root(2) : Quadratic(1));
        }
    }
    return sum;
}

/// Adds the rows of (39).
template <class T>
void add_speeds(Rows<T>& rows, const std::vector<BondClass>& classes, std::size_t columns,
                std::size_t unknowns) {
    for (const std::size_t speed : {0U, 1U}) {
        std::vector<T> row(columns);
        for (std::size_t a = 0; a < classes.size(); ++a) {
            row[a] = T(speeds_of_unit_weight(classes[a])[speed]);
        }
        row[unknowns] = T(squared_speeds[speed]);
        rows.push_back(row);
    }
}

template <class T, class Better>
void solve(Rows<T>& rows, std::size_t unknowns, unsigned horizon, const Better& better) {
    if (reduce(rows, unknowns, better).size() < unknowns) {
        throw NoSuchBonds(
            fmt::format("the equations of this method are singular at N = {}", horizon));
    }
}

/// Galerkin and least squares, in Q[sqrt(2)] and the factors of 1 and pi^2.
SquareBonds projected(BondMethod method, unsigned horizon, const std::vector<BondClass>& classes) {
    const bool is_least = method == BondMethod::least_squares;
    const std::vector<Branch> branches = branches_of(classes, is_least);
    const std::size_t count = classes.size();
    const std::size_t unknowns = is_least ? count + 2 : count;  // with the multipliers of (39)
    Rows<Quadratic> rows;
    for (std::size_t a = 0; a < (is_least ? count : count - 2); ++a) {
        std::vector<Quadratic> row;
        for (std::size_t b = 0; b < count; ++b) {
            row.push_back(product(branches, a, b));
        }
        if (is_least) {
            for (const Rational& speed : speeds_of_unit_weight(classes[a])) {
                row.emplace_back(speed);
            }
        }
        const std::array<Quadratic, 2> right = wanted(branches, a);
        row.insert(row.end(), right.begin(), right.end());
        rows.push_back(row);
    }
    add_speeds(rows, classes, unknowns + 2, unknowns);
    solve(rows, unknowns, horizon, nonzero);
    SquareBonds bonds{classes, {}, {}};
    for (std::size_t a = 0; a < count; ++a) {
        const std::array<Quadratic, 2> factors{rows[a][unknowns], rows[a][unknowns + 1]};
        bonds.alpha.push_back(coefficient_of_weight(horizon, classes[a], factors));
        bonds.weights.push_back(double(weight_of(factors)));
    }
    return bonds;
}

/// Where R is taken: its value, or its integral from O to here, of each class and of the solid.
class Contour {
  public:
    explicit Contour(std::vector<Branch> branches) : branches_(std::move(branches)) {}

    static Real length() { return pi() * (2 + sqrt(Real(2))); }

    std::vector<Real> value(const Real& along) const {
        const auto [line, k] = place(along);
        const Branch& branch = branches_[line];
        std::vector<Real> row;
        for (const std::vector<Rational>& cosines : branch.cosines) {
            Real sum = 0;
            for (std::size_t m = 0; m < cosines.size(); ++m) {
                sum += Real(cosines[m]) * cos(int(m) * k);
            }
            row.push_back(sum);
        }
        row.push_back(Real(branch.constant) * pi() * pi() + Real(branch.square) * k * k);
        return row;
    }

    std::vector<Real> integral(const Real& along) const {
        const auto [last, k] = place(along);
        std::vector<Real> sum(branches_[0].cosines.size() + 1);
        for (std::size_t line = 0; line <= last; ++line) {
            // YO is run through from pi down to 0.
            const bool is_down = branches_[line].is_diagonal;
            const Real end = line < last ? pi() : k;
            const std::vector<Real> to_end = primitive(branches_[line], end);
            const std::vector<Real> to_pi = primitive(branches_[line], pi());
            for (std::size_t a = 0; a < sum.size(); ++a) {
                sum[a] += is_down ? sqrt(Real(2)) * (to_pi[a] - to_end[a]) : to_end[a];
            }
        }
        return sum;
    }

  private:
    struct Place {
        std::size_t line;
        Real k;
    };
    static Place place(const Real& along) {
        if (along <= pi()) {
            return {0, along};
        }
        if (along <= 2 * pi()) {
            return {1, along - pi()};
        }
        return {2, pi() - (along - 2 * pi()) / sqrt(Real(2))};
    }
    /// The integrals from 0 to k.
    static std::vector<Real> primitive(const Branch& branch, const Real& k) {
        std::vector<Real> row;
        for (const std::vector<Rational>& cosines : branch.cosines) {
            Real sum = Real(cosines[0]) * k;
            for (std::size_t m = 1; m < cosines.size(); ++m) {
                sum += Real(cosines[m]) * sin(int(m) * k) / int(m);
            }
            row.push_back(sum);
        }
        row.push_back(Real(branch.constant) * pi() * pi() * k +
                      Real(branch.square) * k * k * k / 3);
        return row;
    }

    std::vector<Branch> branches_;
};

/// Points and parts: classes less two of them.
SquareBonds collocated(BondMethod method, unsigned horizon, const std::vector<BondClass>& classes) {
    const Contour contour(branches_of(classes, false));
    const std::size_t count = classes.size();
    Rows<Real> rows;
    for (std::size_t m = 1; m + 1 < count; ++m) {
        if (method == BondMethod::point) {
            rows.push_back(contour.value(Contour::length() * int(m) / int(count - 1)));
            continue;
        }
        std::vector<Real> part = contour.integral(Contour::length() * int(m) / int(count - 2));
        const std::vector<Real> before =
            contour.integral(Contour::length() * int(m - 1) / int(count - 2));
        std::ranges::transform(part, before, part.begin(), std::minus<>());
        rows.push_back(part);
    }
    add_speeds(rows, classes, count + 1, count);
    solve(rows, count, horizon, [](const Real& candidate, const Real& best) {
        const Real zero("1e-90");  // 30 digits above the roundings
        return abs(candidate) > abs(best) && abs(candidate) > zero;
    });
    SquareBonds bonds{classes, {}, {}};
    for (std::size_t a = 0; a < count; ++a) {
        const Real& weight = rows[a].back();
        bonds.alpha.push_back({double(weight * alpha_of_unit_weight(horizon, classes[a])), {}});
        bonds.weights.push_back(double(weight));
    }
    return bonds;
}

}  // namespace

SquareBonds contour_bonds(BondMethod method, unsigned horizon) {
    const std::vector<BondClass> classes = square_bond_classes(horizon);
    switch (method) {
        case BondMethod::point:
        case BondMethod::subdomain:
            return collocated(method, horizon, classes);
        case BondMethod::galerkin:
        case BondMethod::least_squares:
            return projected(method, horizon, classes);
        case BondMethod::taylor:
        case BondMethod::bz_ls:
            break;
    }
    throw std::invalid_argument("not a method on the contour");
}

}  // namespace nmbcgen
