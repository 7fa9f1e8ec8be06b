// The digits of a number to the base 2^64, the lowest first.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace touchstone::fast::exact {

/// Few limbs are kept in place: most numbers have at most six, and an allocation costs as much as a product of two.
class Limbs {
 public:
  Limbs() = default;
  Limbs(const Limbs& other) : size_(other.size_), many_(other.many_) { copy_few(other); }
  Limbs(Limbs&& other) noexcept : size_(other.size_), many_(std::move(other.many_)) { copy_few(other); }
  Limbs& operator=(const Limbs& other) {
    size_ = other.size_;
    many_ = other.many_;
    copy_few(other);
    return *this;
  }
  Limbs& operator=(Limbs&& other) noexcept {
    size_ = other.size_;
    many_ = std::move(other.many_);
    copy_few(other);
    return *this;
  }
  ~Limbs() = default;

  /// Of limbs without a value.
  void reset(std::size_t size) {
    size_ = size;
    if (size > few) many_.resize(size);
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const std::uint64_t* data() const { return size_ > few ? many_.data() : few_.data(); }
  std::uint64_t* data() { return size_ > few ? many_.data() : few_.data(); }

  /// Leaves `size` limbs from `first` on.
  void cut(std::size_t first, std::size_t size) {
    if (first == 0 && size == size_) return;
    const std::uint64_t* from = data() + first;
    if (size > few) {
      std::copy_n(from, size, many_.data());
      many_.resize(size);
    } else {
      std::copy_n(from, size, few_.data());
    }
    size_ = size;
  }

 private:
  static constexpr std::size_t few = 6;

  void copy_few(const Limbs& other) {
    for (std::size_t i = 0; size_ <= few && i < size_; ++i) few_[i] = other.few_[i];
  }

  std::size_t size_ = 0;
  std::array<std::uint64_t, few> few_;  // only the first `size_` have a value
  std::vector<std::uint64_t> many_;     // the limbs, if they are more
};

}  // namespace touchstone::fast::exact
