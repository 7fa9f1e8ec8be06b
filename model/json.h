// Scenes and answers as JSON; doubles survive write and read bit for bit (shortest round-trip form).
//
// The published schema is docs/scene.schema.json. Reading is strict: an unknown key, a wrong type, a number that is not
// finite, or text that ends early is an InputError that names the place ("bodies[3].shape.vertices[17][0]: …").
// The same readers serve the pipe, so an engine's NaN (JSON null or a string) is an InputError there, never a number.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "model/answers.h"
#include "model/input_error.h"
#include "model/scene.h"

namespace touchstone {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v);
Json json_of(const Scene& scene);
Json json_of(const Masses& answer);
Json json_of(const Bounds& answer);
Json json_of(const PairSet& answer);
Json json_of(const Distance& answer);
Json json_of(const Penetration& answer);

/// T is any type that json_of writes. `place` is the JSON path that messages start with. Throws InputError.
template <class T>
T read(const Json& json, const std::string& place);

/// Parses text; an InputError says the line and column. `place` is the file's name or the like.
Json parse(std::string_view text, const std::string& place);

/// Reads a file whole; parses, reads and validates (model/limits.h) a scene. Throws InputError.
std::string read_text(const std::string& path);
Scene read_scene(const std::string& path);

/// Writes beside `path` and renames: a reader sees the old file or the whole new one, never a part.
void write_text(const std::string& path, std::string_view text);

}  // namespace touchstone
