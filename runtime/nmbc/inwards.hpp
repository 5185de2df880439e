// SPDX-License-Identifier: MIT
/// A field as one end of a chain sees it.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>

namespace nmbc {

enum class End { left, right };

/// Entries of a field counted inwards from an end: 0 is the outermost ghost node there. The same
/// code then does for both ends. It does not know the field's size: an object of two members is
/// passed in registers, and a larger one through memory, which takes longer than most ends.
template <class Value>
class Inwards {
  public:
    Inwards(std::span<Value> field, End end)
        : first_(field.data() + (end == End::left || field.empty() ? 0 : field.size() - 1)),
          step_(end == End::left ? 1 : -1) {}

    /// Of entries that may be written, those that may only be read.
    template <class Writable>
    requires(std::is_same_v<const Writable, Value> && !std::is_same_v<Writable, Value>)
        Inwards(const Inwards<Writable>& other)  // NOLINT(google-explicit-constructor): as in span
        : first_(&other[0]), step_(other.step_) {}

    Value& operator[](std::size_t j) const {
        return first_[step_ * static_cast<std::ptrdiff_t>(j)];
    }

  private:
    template <class Other>
    friend class Inwards;

    Value* first_;
    std::ptrdiff_t step_;
};

}  // namespace nmbc
