// Reads texts that people write as a whole, so that a message about a place in them names the file, the line and the
// column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "model/json.h"

namespace touchstone {

/// A larger file is refused unread. The limit is 2 million triangles of binary STL, or 500,000 vertices of a scene.
inline constexpr std::size_t largest_text_bytes = 100'000'000;

/// A text, and where it came from.
struct SourceText {
  std::string name;  ///< name of the file; `<stdin>` for standard input
  std::string text;  ///< without the byte order mark of UTF-8
};

/// Reads a plain file, or standard input if `path` is "-". Throws InputError if the file does not exist, is a folder, a
/// device, a pipe or a socket (reading one might wait for ever), is larger than largest_text_bytes, or is UTF-16.
SourceText read_source(const std::string& path);

/// Removes the byte order mark of UTF-8. Throws InputError for that of UTF-16.
std::string without_byte_order_mark(std::string text);

/// "LINE:COLUMN" of an offset, both counted from 1. Each UTF-8 character is one column.
std::string line_and_column(std::string_view text, std::size_t offset);

/// Prepends "FILE:LINE:COLUMN: " to `error`, as far as the place is known. The message either starts with a JSON path
/// ("bodies[3].shape.radius"), as those of all readers here do, or is about the whole text. If a path does not exist in
/// the text, the part of it that exists is used.
InputError located(const InputError& error, std::string_view json, const std::string& file);

/// Does what `parse` (model/json.h) does, for text that people write: also refuses documents that would take much
/// memory.
Json parse_document(std::string_view text, const std::string& file);

/// Applies `read` to the document. Errors that start with a JSON path get the place in the text.
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
