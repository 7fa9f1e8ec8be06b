#include "oracle/process/received_scene.h"

#include <utility>
#include <variant>

#include "model/input_error.h"
#include "model/limits.h"
#include "oracle/process/given_faces.h"
#include "oracle/process/hull_faces.h"
#include "oracle/query.h"

namespace touchstone::oracle {
namespace {

std::string item(const std::string& place, const char* list, std::size_t index) {
  return place + '.' + list + '[' + std::to_string(index) + ']';
}

template <class AnyShape>
void complete(AnyShape& shape, const std::string& place) {
  auto* polytope = std::get_if<Polytope>(&shape);
  if (polytope == nullptr) return;
  try {
    if (polytope->faces.empty()) {
      polytope->faces = hull_faces(polytope->vertices);
    } else {
      require_convex_faces(*polytope);
    }
  } catch (const InputError& error) {
    throw InputError("", place + '.' + error.what());
  }
}

void complete(Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::string place = "bodies[" + std::to_string(b) + "].shape";
    Shape& shape = scene.bodies[b].shape;
    complete(shape, place);
    if (auto* compound = std::get_if<Compound>(&shape)) {
      for (std::size_t p = 0; p < compound->parts.size(); ++p) {
        complete(compound->parts[p].shape, item(place, "parts", p) + ".shape");
      }
    }
  }
}

void require_subject_matter(const Scene& scene, const Query& query) {
  if (query.about_two_bodies && scene.bodies.size() < 2) {
    throw InputError("bodies", "the query " + query.name + " is about bodies 0 and 1: two are needed");
  }
  const auto require = [&](ScenePart part, bool there, const char* key) {
    if (query.needs == part && !there) throw InputError(key, "missing; the query " + query.name + " is about it");
  };
  require(ScenePart::contact, scene.contact.has_value(), "contact");
  require(ScenePart::raster, scene.raster.has_value(), "raster");
  require(ScenePart::motion, scene.motion.has_value(), "motion");
}

}  // namespace

Scene received(Scene scene, const std::string& query) try {
  validate(scene);
  complete(scene);
  if (const Query* known = find_query(query)) require_subject_matter(scene, *known);
  return scene;
} catch (const InputError& error) {
  throw InputError("", std::string("scene.") + error.what());
}

}  // namespace touchstone::oracle
