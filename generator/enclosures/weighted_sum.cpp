// SPDX-License-Identifier: MIT
#include "generator/enclosures/weighted_sum.hpp"

#include <algorithm>
#include <stdexcept>

namespace nmbcgen {
namespace {

void add(EnclosedPolynomial& sum, const Interval& factor, const EnclosedPolynomial& more) {
    sum.resize(std::max(sum.size(), more.size()), Interval(0));
    for (std::size_t i = 0; i < more.size(); ++i) {
        sum[i] += factor * more[i];
    }
}

}  // namespace

WeightedSum::WeightedSum(const std::vector<Term>& terms) {
    about_middle_.offset = terms.front().polynomial.offset;
    for (const auto& [polynomial, factor] : terms) {
        if (!equal(polynomial.offset, about_middle_.offset)) {
            throw std::invalid_argument("WeightedSum: polynomials of different parameters");
        }
        const double middle = median(factor);
        add(about_middle_.value, middle, polynomial.value);
        add(about_middle_.slope, factor, polynomial.slope);
        add(about_middle_.rest, factor, polynomial.rest);
        if (width(factor) > 0) {
            deviations_.push_back({polynomial.value, factor - middle});
        }
    }
    enclosed_ = about_middle_.enclosed();
    for (const auto& [polynomial, by] : deviations_) {
        add(enclosed_, by, polynomial);
    }
}

ComplexInterval WeightedSum::at(const ComplexInterval& z) const {
    ComplexInterval sum = about_middle_.at(z);
    for (const auto& [polynomial, by] : deviations_) {
        sum = sum + by * value_at(polynomial, z);
    }
    return sum;
}

}  // namespace nmbcgen
