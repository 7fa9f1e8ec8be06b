// A mesh in text, word by word and line by line.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "model/frame.h"

namespace touchstone::reference {

/// Why a text is no mesh, and, of text, where.
struct MeshError : std::runtime_error {
  explicit MeshError(const std::string& why, std::optional<std::size_t> at = {})
      : std::runtime_error(why), offset(at) {}
  std::optional<std::size_t> offset;
};

class MeshWords {
 public:
  /// What follows `comment` on a line is left out.
  explicit MeshWords(std::string_view text, char comment = '\n') : text_(text), comment_(comment) {}

  /// Refuses a NUL byte: text has none.
  void expect_text() const;

  bool is_at_end() const { return at_ == text_.size(); }

  /// The next word of the line; empty if it has no more.
  std::string_view word_of_line();
  /// The next word of the text; empty if it has no more.
  std::string_view word();
  void skip_line();
  /// Goes on to the next line with a word, unless this one has more. False if there is none.
  bool skip_to_word();
  /// The next bytes; false if there are not so many.
  bool copy_bytes(char* to, std::size_t count);

  /// A word as a number; of the double nearest to it, neither infinite nor 0 where the word is not. Throws MeshError.
  double number(std::string_view word) const;
  std::size_t count(std::string_view word) const;
  Vec3 point_of_line();

  /// About the last word.
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  void skip_space(const char* space);
  std::string_view take_word();

  std::string_view text_;
  char comment_;
  std::size_t at_ = 0;
  std::size_t last_word_ = 0;
};

}  // namespace touchstone::reference
