// A bitmap, 64 pixels to a word, and the overlap of two of them.
#pragma once

#include <cstdint>
#include <vector>

#include "model/answers.h"

namespace touchstone::fast::pixel {

/// Rows of whole words; column i is bit i mod 64 of word i / 64. Bits beyond the last column are 0.
class BitMask {
 public:
  BitMask(int columns, int rows);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int words() const { return words_; }  ///< per row

  bool at(int column, int row) const { return (word(column, row) >> (column % 64) & 1U) != 0; }
  void set(int column, int row) { word(column, row) |= std::uint64_t{1} << (column % 64); }

  const std::uint64_t* row(int row) const { return bits_.data() + static_cast<std::size_t>(row) * stride(); }
  Mask text() const;

 private:
  std::size_t stride() const { return static_cast<std::size_t>(words_); }
  const std::uint64_t& word(int column, int row) const {
    return bits_[static_cast<std::size_t>(row) * stride() + static_cast<std::size_t>(column / 64)];
  }
  std::uint64_t& word(int column, int row) {
    return bits_[static_cast<std::size_t>(row) * stride() + static_cast<std::size_t>(column / 64)];
  }

  int columns_;
  int rows_;
  int words_;
  std::vector<std::uint64_t> bits_;
};

/// The number of pixels (i, j) with A(i, j) and B(i − shift_x, j − shift_y), and the first by row, then column. Any
/// shift is allowed. Processes a word at a time: a row of B is read as two neighbouring words shifted together.
///
/// Cost: the common rows' words, each read once.
MaskOverlap overlap(const BitMask& A, const BitMask& B, int shift_x, int shift_y);

}  // namespace touchstone::fast::pixel
