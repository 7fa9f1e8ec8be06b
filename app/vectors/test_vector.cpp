#include "app/vectors/test_vector.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <set>

#include "app/vectors/exact_vector.h"
#include "model/input_error.h"
#include "model/source_text.h"
#include "oracle/judge/judge.h"
#include "oracle/tolerance/tolerance.h"
#include "properties/clause.h"
#include "properties/scenes/domain.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

constexpr const char* vectors_format = "vectors/1";

/// FNV-1a of 32 bits (Fowler, Noll, Vo): an id that stays as vectors are added and as their order changes.
std::string id_of(const std::string& query, const std::string& scene) {
  std::uint32_t hash = 2166136261U;
  for (const char c : scene) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return fmt::format("{}-{:08x}", query, hash);
}

Json clauses_of(const std::string& query) {
  Json all = Json::array();
  for (const properties::Clause& clause : properties::clauses()) {
    if (clause.query == query) all.push_back({{"id", clause.id}, {"title", clause.title}, {"says", clause.says}});
  }
  return all;
}

bool has_margin(const std::string& query) { return query == "distance" || query == "penetration"; }

Scene one_plain_body() {
  Scene scene;
  scene.bodies.emplace_back();
  return scene;
}

/// Without what is the default, so that a scene fits into a few lines. A -0 is kept: it is no default.
Json short_json(const Scene& scene) {
  static const Json unset = touchstone::json_of(one_plain_body());
  Json json = touchstone::json_of(scene);
  if (json["gravity"].dump() == unset["gravity"].dump()) json.erase("gravity");
  for (Json& body : json["bodies"]) {
    for (const char* key : {"velocity", "material", "mass"}) {
      if (body[key].dump() == unset["bodies"][0][key].dump()) body.erase(key);
    }
  }
  return json;
}

}  // namespace

bool is_extreme(const TestVector& vector) {
  const Json& source = vector.source;
  const Json& drawn = source.contains("smaller_than") ? source["smaller_than"] : source;
  return drawn.value("family", "").starts_with("extreme.");
}

std::string vectors_file(const std::string& folder, const std::string& query) {
  return (std::filesystem::path(folder) / (query + ".json")).string();
}

std::vector<TestVector> read_vectors(const std::string& file) {
  if (!std::filesystem::exists(file)) return {};
  return read_document(read_text(file), file, [](const Json& json) {
    if (!json.is_object() || json.value("touchstone", "") != vectors_format) {
      throw InputError("touchstone", fmt::format("\"{}\" is expected", vectors_format));
    }
    const auto tests = json.find("tests");
    if (tests == json.end() || !tests->is_array()) throw InputError("tests", "an array is expected");
    std::vector<TestVector> vectors;
    for (const Json& test : *tests) {
      const std::string place = fmt::format("tests[{}]", vectors.size());
      if (!test.is_object() || !test.contains("scene") || !test.contains("source")) {
        throw InputError(place, "an object with scene and source is expected");
      }
      vectors.push_back({reference::completed(read<Scene>(test["scene"], place + ".scene")), test["source"]});
    }
    return vectors;
  });
}

std::vector<TestVector> distinct(std::vector<TestVector> vectors) {
  std::set<std::string> known;
  std::erase_if(vectors, [&](const TestVector& vector) {
    return !known.insert(touchstone::json_of(vector.scene).dump()).second;
  });
  return vectors;
}

Json vector_json(const std::string& query, const TestVector& vector) {
  const Scene& scene = vector.scene;
  const std::string id = id_of(query, touchstone::json_of(scene).dump());
  Json json = {{"id", id}, {"classes", properties::classes_of(scene, query)}, {"source", vector.source}};
  json["scale"] = oracle::tolerance::scale(scene);
  if (has_margin(query)) {
    const Interval margin = oracle::judge::margin(scene);
    json["margin"] = {margin.lo, margin.hi};
  }
  if (Json allowed = allowance(query, scene); !allowed.is_null() && !is_extreme(vector)) {
    json["allowed"] = std::move(allowed);
  }
  json["scene"] = short_json(scene);
  json["answer"] = exact_vector(query, scene);
  return json;
}

std::string text_of_vectors(const std::string& query, const std::vector<TestVector>& vectors) {
  std::string lines;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    try {
      lines += fmt::format("{}\n    {}", i == 0 ? "" : ",", vector_json(query, vectors[i]).dump());
    } catch (const InputError& error) {
      throw InputError(fmt::format("tests[{}]", i), error.what());
    }
  }
  return fmt::format(
      "{{\n  \"touchstone\": \"{}\",\n  \"query\": \"{}\",\n  \"clauses\": {},\n  \"tests\": [{}\n  ]\n}}\n",
      vectors_format, query, clauses_of(query).dump(), lines);
}

}  // namespace touchstone::app
