// SPDX-License-Identifier: MIT
/// Natural numbers of any size: just enough to evaluate a table's coefficients exactly.
///
/// Near a pole, numerator and denominator of a coefficient lose all their digits in any fixed
/// precision (double-double included, one unit in the last place from the pole). They are
/// evaluated once per simulation, so exact integers cost nothing that matters, need no special
/// rounding mode and stay right under -ffast-math.
#pragma once

#include <algorithm>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nmbc::detail {

class Natural {
  public:
    Natural() = default;

    explicit Natural(std::uint64_t value) {
        for (; value != 0; value >>= limb_bits) {
            limbs_.push_back(static_cast<std::uint32_t>(value));
        }
    }

    bool is_zero() const { return limbs_.empty(); }

    /// Number of binary digits; 0 for zero.
    std::size_t bit_length() const {
        return limbs_.empty() ? 0
                              : limbs_.size() * limb_bits -
                                    static_cast<std::size_t>(std::countl_zero(limbs_.back()));
    }

    /// *this = *this * factor + summand
    void multiply_add(std::uint32_t factor, std::uint32_t summand) {
        std::uint64_t carry = summand;
        for (std::uint32_t& limb : limbs_) {
            carry += std::uint64_t{limb} * factor;
            limb = static_cast<std::uint32_t>(carry);
            carry >>= limb_bits;
        }
        if (carry != 0) {
            limbs_.push_back(static_cast<std::uint32_t>(carry));
        }
        trim();
    }

    Natural& operator+=(const Natural& other) {
        limbs_.resize(std::max(limbs_.size(), other.limbs_.size()) + 1, 0);
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < limbs_.size(); ++i) {
            carry += std::uint64_t{limbs_[i]} + (i < other.limbs_.size() ? other.limbs_[i] : 0);
            limbs_[i] = static_cast<std::uint32_t>(carry);
            carry >>= limb_bits;
        }
        trim();
        return *this;
    }

    /// other must not be greater than *this.
    Natural& operator-=(const Natural& other) {
        std::int64_t borrow = 0;
        for (std::size_t i = 0; i < limbs_.size(); ++i) {
            borrow += std::int64_t{limbs_[i]} - (i < other.limbs_.size() ? other.limbs_[i] : 0);
            limbs_[i] = static_cast<std::uint32_t>(borrow);
            borrow >>= limb_bits;  // 0 or -1
        }
        trim();
        return *this;
    }

    Natural& operator<<=(std::size_t bits) {
        if (limbs_.empty()) {
            return *this;
        }
        const std::size_t whole = bits / limb_bits;
        multiply_add(std::uint32_t{1} << (bits % limb_bits), 0);
        limbs_.insert(limbs_.begin(), whole, 0);
        return *this;
    }

    friend Natural operator*(const Natural& left, const Natural& right) {
        Natural product;
        for (std::size_t i = right.limbs_.size(); i-- > 0;) {
            product <<= limb_bits;
            Natural partial = left;
            partial.multiply_add(right.limbs_[i], 0);
            product += partial;
        }
        return product;
    }

    friend std::strong_ordering operator<=>(const Natural& left, const Natural& right) {
        if (const auto by_size = left.limbs_.size() <=> right.limbs_.size(); by_size != 0) {
            return by_size;
        }
        return std::lexicographical_compare_three_way(left.limbs_.rbegin(), left.limbs_.rend(),
                                                      right.limbs_.rbegin(), right.limbs_.rend());
    }
    friend bool operator==(const Natural&, const Natural&) = default;

  private:
    static constexpr std::size_t limb_bits = 32;

    void trim() {
        while (!limbs_.empty() && limbs_.back() == 0) {
            limbs_.pop_back();
        }
    }

    std::vector<std::uint32_t> limbs_;  // least significant first, no leading zero
};

}  // namespace nmbc::detail
