// Texts that people write, read whole, so that a complaint about a place in them names the file, the line and the
// column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "model/json.h"

namespace touchstone {

/// A larger file is refused unread: 2 million triangles of binary STL, or 500,000 vertices of a scene.
inline constexpr std::size_t largest_text_bytes = 100'000'000;

struct SourceText {
  std::string name;  ///< of the file; "<stdin>" for standard input
  std::string text;  ///< without the byte order mark of UTF-8
};

/// Reads a plain file, or standard input if `path` is "-". Throws InputError: not there, a folder, a device, a pipe or
/// a socket (so that no reading waits for ever), above largest_text_bytes, UTF-16.
SourceText read_source(const std::string& path);

/// Takes the byte order mark of UTF-8 away. Throws InputError for that of UTF-16.
std::string without_byte_order_mark(std::string text);

/// "LINE:COLUMN" of an offset, both from 1. A character of UTF-8 is one column.
std::string line_and_column(std::string_view text, std::size_t offset);

/// `error` with "FILE:LINE:COLUMN: " before it, as far as known: its message starts with a JSON path
/// ("bodies[3].shape.radius"), as those of all our readers do, or it is about the whole text. A path that leads nowhere
/// counts as far as it leads.
InputError located(const InputError& error, std::string_view json, const std::string& file);

/// `parse` (model/json.h) for what people write; refuses documents that would take much memory, too.
Json parse_document(std::string_view text, const std::string& file);

/// What `read` makes of the document. Its complaints about JSON paths are located.
template <class Read>
auto read_document(std::string_view text, const std::string& file, Read read) {
  const Json json = parse_document(text, file);
  try {
    return read(json);
  } catch (const InputError& error) {
    throw located(error, text, file);
  }
}

}  // namespace touchstone
