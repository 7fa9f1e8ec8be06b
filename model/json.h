// Scenes and answers as JSON. Doubles survive writing and reading bit for bit (shortest round-trip form).
//
// The published schema is docs/scene.schema.json. Reading is strict: an unknown key, a wrong type, a number that is not
// finite, or text that ends early is an InputError that names the place ("bodies[3].shape.vertices[17][0]: …"). The
// pipe uses the same readers, so an engine's NaN (JSON null or a string) is an InputError there, never a number.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "model/answers.h"
#include "model/input_error.h"
#include "model/scene.h"

namespace touchstone {

/// Objects keep the order in which their keys were written.
using Json = nlohmann::ordered_json;

/// The JSON of a value, in the form that `read` reads (docs/scene.schema.json, docs/protocol.schema.json). An optional
/// member that is absent has no key. Infinite friction is written "sticking"; any other number that is not finite
/// becomes null when it is printed, which no reader accepts.
Json json_of(const Vec3& v);
Json json_of(const Pose& X);
Json json_of(const Velocity& velocity);
Json json_of(const Scene& scene);
Json json_of(const Masses& answer);
Json json_of(const Bounds& answer);
Json json_of(const PairSet& answer);
Json json_of(const PairHistory& answer);
Json json_of(const Distance& answer);
Json json_of(const Penetration& answer);
Json json_of(const Impulse& answer);
Json json_of(const Pixels& answer);
Json json_of(const Event& event);
Json json_of(const TimeOfImpact& answer);
Json json_of(const Trajectory& answer);

/// T is any type that json_of writes. `place` is the JSON path with which messages start. Throws InputError.
template <class T>
T read(const Json& json, const std::string& place);
template <>
Vec3 read<Vec3>(const Json& json, const std::string& place);
template <>
Scene read<Scene>(const Json& json, const std::string& place);
template <>
Masses read<Masses>(const Json& json, const std::string& place);
template <>
Bounds read<Bounds>(const Json& json, const std::string& place);
template <>
PairSet read<PairSet>(const Json& json, const std::string& place);
template <>
PairHistory read<PairHistory>(const Json& json, const std::string& place);
template <>
Distance read<Distance>(const Json& json, const std::string& place);
template <>
Penetration read<Penetration>(const Json& json, const std::string& place);
template <>
Impulse read<Impulse>(const Json& json, const std::string& place);
template <>
Pixels read<Pixels>(const Json& json, const std::string& place);
template <>
TimeOfImpact read<TimeOfImpact>(const Json& json, const std::string& place);
template <>
Trajectory read<Trajectory>(const Json& json, const std::string& place);

/// Parses text; an InputError names the line and column. `place` is the name of the file or of another source.
Json parse(std::string_view text, const std::string& place);

/// Formats JSON for people: a value that fits on one line is written on one line; the text ends with a newline.
/// (Programs use Json::dump.)
std::string text_of(const Json& json);

/// Parses, reads and validates (model/limits.h) a scene. Throws InputError.
Scene scene_from(std::string_view text, const std::string& place);

/// `read_text` returns a whole file, byte for byte, or standard input for "-"; `read_scene` is read_source
/// (model/source_text.h) and scene_from. Both throw InputError for a file that cannot be read or is too large.
std::string read_text(const std::string& path);
Scene read_scene(const std::string& path);

/// Writes a file beside `path` and renames it, so a reader sees the old file or the new one, never a part. Throws
/// InputError, or OutputError if the disk is full or fails; then the old file remains. (A device or a pipe is written
/// in place.)
void write_text(const std::string& path, std::string_view text);

}  // namespace touchstone
