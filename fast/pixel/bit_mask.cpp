#include "fast/pixel/bit_mask.h"

#include <algorithm>
#include <bit>

namespace touchstone::fast::pixel {
namespace {

/// Bits 64w + from … 64w + from + 63 of a row of `words` words; 0 beyond its ends. 0 ≤ from < 64.
std::uint64_t bits_at(const std::uint64_t* row, int words, std::int64_t w, int from) {
  const std::uint64_t low = w >= 0 && w < words ? row[w] >> from : 0;
  const std::uint64_t high = from != 0 && w + 1 >= 0 && w + 1 < words ? row[w + 1] << (64 - from) : 0;
  return low | high;
}

/// The number of bits set in each of a word's eight bytes: compilers vectorise these sums where the processor has no
/// instruction that counts bits.
std::uint64_t byte_counts(std::uint64_t x) {
  x -= x >> 1 & 0x5555555555555555U;
  x = (x & 0x3333333333333333U) + (x >> 2 & 0x3333333333333333U);
  return (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fU;
}

/// The number of bits set in words begin to end. A byte holds 31 counts of up to 8.
template <class Word>
int count(int begin, int end, Word&& word) {
  int total = 0;
  for (int block = begin; block < end; block += 31) {
    const int block_end = std::min(end, block + 31);
    std::uint64_t bytes = 0;
    for (int w = block; w < block_end; ++w) bytes += byte_counts(word(w));
    bytes = (bytes & 0x00ff00ff00ff00ffU) + (bytes >> 8 & 0x00ff00ff00ff00ffU);
    total += static_cast<int>(bytes * 0x0001000100010001U >> 48);
  }
  return total;
}

}  // namespace

BitMask::BitMask(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      words_((columns - 1) / 64 + 1),
      bits_(static_cast<std::size_t>(words_) * static_cast<std::size_t>(rows)) {}

Mask BitMask::text() const {
  Mask rows;
  for (int j = 0; j < rows_; ++j) {
    std::string& row = rows.emplace_back(static_cast<std::size_t>(columns_), '0');
    for (int i = 0; i < columns_; ++i) {
      if (at(i, j)) row[static_cast<std::size_t>(i)] = '1';
    }
  }
  return rows;
}

MaskOverlap overlap(const BitMask& A, const BitMask& B, int shift_x, int shift_y) {
  MaskOverlap found;
  const std::int64_t first_row = std::max<std::int64_t>(0, shift_y);
  const std::int64_t end_row = std::min<std::int64_t>(A.rows(), std::int64_t{B.rows()} + shift_y);
  const std::int64_t start = -std::int64_t{shift_x};  // B's column below A's column 0
  const int from = static_cast<int>(start & 63);
  const std::int64_t offset = (start - from) / 64;
  const auto first_word = static_cast<int>(std::clamp<std::int64_t>(-offset - 1, 0, A.words()));
  const auto end_word = static_cast<int>(std::clamp<std::int64_t>(B.words() - offset, 0, A.words()));
  // Where both of B's words exist no test is needed: the innermost loop has no branch.
  const auto inner = static_cast<int>(std::clamp<std::int64_t>(-offset, first_word, end_word));
  const auto inner_end = static_cast<int>(std::clamp<std::int64_t>(B.words() - 1 - offset, inner, end_word));
  for (std::int64_t j = first_row; j < end_row; ++j) {
    const std::uint64_t* const a = A.row(static_cast<int>(j));
    const std::uint64_t* const b = B.row(static_cast<int>(j - shift_y));
    const auto common = [&](int w) { return a[w] & bits_at(b, B.words(), w + offset, from); };
    int in_row = 0;
    for (int w = first_word; w < inner; ++w) in_row += std::popcount(common(w));
    if (from == 0) {
      in_row += count(inner, inner_end, [&](int w) { return a[w] & b[w + offset]; });
    } else {
      in_row += count(inner, inner_end,
                      [&](int w) { return a[w] & (b[w + offset] >> from | b[w + offset + 1] << (64 - from)); });
    }
    for (int w = inner_end; w < end_word; ++w) in_row += std::popcount(common(w));
    if (in_row > 0 && !found.first) {
      int w = first_word;
      while (common(w) == 0) ++w;
      found.first = {64 * w + std::countr_zero(common(w)), static_cast<int>(j)};
    }
    found.count += in_row;
  }
  return found;
}

}  // namespace touchstone::fast::pixel
