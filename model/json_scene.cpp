// Scenes as JSON; implements docs/scene.schema.json.
#include <array>
#include <cmath>

#include "model/infinity.h"
#include "model/json_node.h"
#include "model/limits.h"
#include "model/source_text.h"

namespace touchstone {
namespace {

using touchstone::json_of;

constexpr const char* scene_format = "scene/1";
constexpr const char* sticking = "sticking";
constexpr std::array<std::pair<Law, const char*>, 3> law_words = {
    {{Law::poisson, "poisson"}, {Law::stronge, "stronge"}, {Law::newton, "newton"}}};

Json json_of(const Quaternion& q) { return {{"w", q.w}, {"x", q.x}, {"y", q.y}, {"z", q.z}}; }
Json json_of(const Sphere& sphere) { return {{"type", "sphere"}, {"radius", sphere.radius}}; }

Json json_of(const Box& box) { return {{"type", "box"}, {"half_extents", json_of(box.half_extents)}}; }

Json json_of(const Polytope& polytope) {
  Json vertices = Json::array();
  for (const Vec3& vertex : polytope.vertices) vertices.push_back(json_of(vertex));
  Json json = {{"type", "polytope"}, {"vertices", std::move(vertices)}};
  if (!polytope.faces.empty()) json["faces"] = polytope.faces;
  return json;
}

Json json_of(const Compound& compound) {
  Json parts = Json::array();
  for (const Part& part : compound.parts) {
    parts.push_back({{"X_BP", json_of(part.X_BP)},
                     {"shape", std::visit([](const auto& kind) { return json_of(kind); }, part.shape)}});
  }
  return {{"type", "compound"}, {"parts", std::move(parts)}};
}

Json json_of(const Density& density) { return {{"type", "density"}, {"density", density.value}}; }
Json json_of(const Fixed&) { return {{"type", "fixed"}}; }

Json json_of(const MassProperties& given) {
  Json json = {{"type", "given"}};
  json.update(json_of(Masses{given})[0]);
  return json;
}

Json json_of(const Body& body) {
  Json json = Json::object();
  if (!body.name.empty()) json["name"] = body.name;
  json["shape"] = std::visit([](const auto& kind) { return json_of(kind); }, body.shape);
  json["X_WB"] = json_of(body.X_WB);
  json["velocity"] = json_of(body.velocity);
  json["material"] = {{"restitution", body.material.restitution}, {"friction", body.material.friction}};
  json["mass"] = std::visit([](const auto& kind) { return json_of(kind); }, body.mass);
  return json;
}

Json json_of(const Placement& placement) {
  return {{"body", placement.body}, {"X_WB", placement.X_WB ? json_of(*placement.X_WB) : Json()}};
}

const char* word_of(Law law) { return law_words[static_cast<std::size_t>(law)].second; }

Json json_of(const Contact& contact) {
  return {{"p_WC", json_of(contact.p_WC)},
          {"nhat_BA_W", json_of(contact.nhat_BA_W)},
          {"law", word_of(contact.law)},
          {"restitution", contact.restitution},
          {"friction", std::isinf(contact.friction) ? Json(sticking) : Json(contact.friction)}};
}

Json json_of(const Raster& raster) {
  return {{"x", raster.x},         {"y", raster.y},
          {"pixel", raster.pixel}, {"columns", raster.columns},
          {"rows", raster.rows},   {"shift", {raster.shift_x, raster.shift_y}}};
}

Json json_of(const AppliedForce& force) {
  return {{"time", force.time}, {"body", force.body}, {"force_W", json_of(force.force_W)}};
}

Json json_of(const Motion& motion) {
  Json json = {{"sample_times", motion.sample_times}};
  if (!motion.start_times.empty()) json["start_times"] = motion.start_times;
  if (motion.envelope) json["envelope"] = *motion.envelope;
  json["law"] = word_of(motion.law);
  if (motion.force_bound != 0) json["force_bound"] = motion.force_bound;
  for (const AppliedForce& force : motion.forces) json["forces"].push_back(json_of(force));
  return json;
}

Quaternion read_quaternion(const Node& node) {
  node.expect_object({"w", "x", "y", "z"});
  return {node.at("w").number(), node.at("x").number(), node.at("y").number(), node.at("z").number()};
}

Sphere read_sphere(const Node& node) {
  node.expect_object({"type", "radius"});
  return {node.at("radius").number()};
}

Box read_box(const Node& node) {
  node.expect_object({"type", "half_extents"});
  return {read_vec3(node.at("half_extents"))};
}

std::vector<int> read_face(const Node& node) {
  std::vector<int> face;
  for (int i = 0; i < node.size(); ++i) face.push_back(node[i].index());
  return face;
}

Polytope read_polytope(const Node& node) {
  node.expect_object({"type", "vertices", "faces"});
  Polytope polytope;
  const Node vertices = node.at("vertices");
  for (int i = 0; i < vertices.size(); ++i) polytope.vertices.push_back(read_vec3(vertices[i]));
  if (const auto faces = node.find("faces")) {
    for (int i = 0; i < faces->size(); ++i) polytope.faces.push_back(read_face((*faces)[i]));
  }
  return polytope;
}

ConvexShape read_convex_shape(const Node& node) {
  const std::string type = node.at("type").text();
  if (type == "sphere") return read_sphere(node);
  if (type == "box") return read_box(node);
  if (type == "polytope") return read_polytope(node);
  node.at("type").refuse("expected \"sphere\", \"box\" or \"polytope\", found " + Json(type).dump());
}

Part read_part(const Node& node) {
  node.expect_object({"X_BP", "shape"});
  return {read_pose(node.at("X_BP")), read_convex_shape(node.at("shape"))};
}

Compound read_compound(const Node& node) {
  node.expect_object({"type", "parts"});
  Compound compound;
  const Node parts = node.at("parts");
  for (int i = 0; i < parts.size(); ++i) compound.parts.push_back(read_part(parts[i]));
  return compound;
}

Shape read_shape(const Node& node) {
  const std::string type = node.at("type").text();
  if (type == "sphere") return read_sphere(node);
  if (type == "box") return read_box(node);
  if (type == "polytope") return read_polytope(node);
  if (type == "compound") return read_compound(node);
  node.at("type").refuse("expected \"sphere\", \"box\", \"polytope\" or \"compound\", found " + Json(type).dump());
}

Material read_material(const Node& node) {
  node.expect_object({"restitution", "friction"});
  return {node.at("restitution").number(), node.at("friction").number()};
}

Mass read_mass(const Node& node) {
  const std::string type = node.at("type").text();
  if (type == "density") {
    node.expect_object({"type", "density"});
    return Density{node.at("density").number()};
  }
  if (type == "given") {
    node.expect_object({"type", "mass", "p_BBcm", "I_BBcm_B"});
    return read_mass_properties(node);
  }
  if (type == "fixed") {
    node.expect_object({"type"});
    return Fixed{};
  }
  node.at("type").refuse("expected \"density\", \"given\" or \"fixed\", found " + Json(type).dump());
}

Body read_body(const Node& node) {
  node.expect_object({"name", "shape", "X_WB", "velocity", "material", "mass"});
  Body body;
  if (const auto name = node.find("name")) body.name = name->text();
  body.shape = read_shape(node.at("shape"));
  body.X_WB = read_pose(node.at("X_WB"));
  if (const auto velocity = node.find("velocity")) body.velocity = read_velocity(*velocity);
  if (const auto material = node.find("material")) body.material = read_material(*material);
  if (const auto mass = node.find("mass")) body.mass = read_mass(*mass);
  return body;
}

Placement read_placement(const Node& node) {
  node.expect_object({"body", "X_WB"});
  Placement placement{node.at("body").index(), {}};
  const Node pose = node.at("X_WB");
  if (!pose.is_null()) placement.X_WB = read_pose(pose);
  return placement;
}

SequenceFrame read_frame(const Node& node) {
  SequenceFrame frame;
  for (int i = 0; i < node.size(); ++i) frame.push_back(read_placement(node[i]));
  return frame;
}

Law read_law(const Node& node) {
  const std::string word = node.text();
  for (const auto& [law, name] : law_words) {
    if (word == name) return law;
  }
  node.refuse("expected \"poisson\", \"stronge\" or \"newton\", found " + Json(word).dump());
}

double read_friction(const Node& node) {
  if (!node.is_text()) return node.number();
  if (node.text() != sticking) node.refuse("expected a number or \"sticking\", found " + Json(node.text()).dump());
  return infinity;
}

Contact read_contact(const Node& node) {
  node.expect_object({"p_WC", "nhat_BA_W", "law", "restitution", "friction"});
  Contact contact;
  contact.p_WC = read_vec3(node.at("p_WC"));
  contact.nhat_BA_W = read_vec3(node.at("nhat_BA_W"));
  if (const auto law = node.find("law")) contact.law = read_law(*law);
  contact.restitution = node.at("restitution").number();
  contact.friction = read_friction(node.at("friction"));
  return contact;
}

int read_whole(const Node& node) {
  const double number = node.number();
  if (number != std::trunc(number) || std::abs(number) > 1e9)
    node.refuse("expected an integer of at most 1e9, found " + Json(number).dump());
  return static_cast<int>(number);
}

Raster read_raster(const Node& node) {
  node.expect_object({"x", "y", "pixel", "columns", "rows", "shift"});
  Raster raster;
  raster.x = node.at("x").number();
  raster.y = node.at("y").number();
  raster.pixel = node.at("pixel").number();
  raster.columns = node.at("columns").index();
  raster.rows = node.at("rows").index();
  if (const auto shift = node.find("shift")) {
    shift->expect_size(2);
    raster.shift_x = read_whole((*shift)[0]);
    raster.shift_y = read_whole((*shift)[1]);
  }
  return raster;
}

std::vector<double> read_numbers(const Node& node) {
  std::vector<double> numbers;
  for (int i = 0; i < node.size(); ++i) numbers.push_back(node[i].number());
  return numbers;
}

AppliedForce read_force(const Node& node) {
  node.expect_object({"time", "body", "force_W"});
  return {node.at("time").number(), node.at("body").index(), read_vec3(node.at("force_W"))};
}

Motion read_motion(const Node& node) {
  node.expect_object({"sample_times", "start_times", "envelope", "law", "force_bound", "forces"});
  Motion motion;
  motion.sample_times = read_numbers(node.at("sample_times"));
  if (const auto since = node.find("start_times")) motion.start_times = read_numbers(*since);
  if (const auto envelope = node.find("envelope")) motion.envelope = envelope->number();
  if (const auto law = node.find("law")) motion.law = read_law(*law);
  if (const auto bound = node.find("force_bound")) motion.force_bound = bound->number();
  if (const auto pushes = node.find("forces")) {
    for (int i = 0; i < pushes->size(); ++i) motion.forces.push_back(read_force((*pushes)[i]));
  }
  return motion;
}

}  // namespace

Json json_of(const Pose& X) { return {{"p", json_of(X.p_WB)}, {"q", json_of(X.q_WB)}}; }

Pose read_pose(const Node& node) {
  node.expect_object({"p", "q"});
  return {read_vec3(node.at("p")), read_quaternion(node.at("q"))};
}

Json json_of(const Scene& scene) {
  Json json = {{"touchstone", scene_format}};
  if (!scene.name.empty()) json["name"] = scene.name;
  json["gravity"] = json_of(scene.gravity);
  json["bodies"] = Json::array();
  for (const Body& body : scene.bodies) json["bodies"].push_back(json_of(body));
  for (const SequenceFrame& frame : scene.frames) {
    Json placements = Json::array();
    for (const Placement& placement : frame) placements.push_back(json_of(placement));
    json["frames"].push_back(std::move(placements));
  }
  if (scene.contact) json["contact"] = json_of(*scene.contact);
  if (scene.raster) json["raster"] = json_of(*scene.raster);
  if (scene.motion) json["motion"] = json_of(*scene.motion);
  return json;
}

template <>
Scene read<Scene>(const Json& json, const std::string& place) {
  const Node node(json, place);
  const std::string format = node.at("touchstone").text();
  if (format != scene_format) {
    node.at("touchstone").refuse("expected \"" + std::string(scene_format) + "\", found " + Json(format).dump());
  }
  node.expect_object({"touchstone", "name", "gravity", "bodies", "frames", "contact", "raster", "motion"});
  Scene scene;
  if (const auto name = node.find("name")) scene.name = name->text();
  if (const auto gravity = node.find("gravity")) scene.gravity = read_vec3(*gravity);
  const Node bodies = node.at("bodies");
  for (int i = 0; i < bodies.size(); ++i) scene.bodies.push_back(read_body(bodies[i]));
  if (const auto frames = node.find("frames")) {
    for (int i = 0; i < frames->size(); ++i) scene.frames.push_back(read_frame((*frames)[i]));
  }
  if (const auto contact = node.find("contact")) scene.contact = read_contact(*contact);
  if (const auto raster = node.find("raster")) scene.raster = read_raster(*raster);
  if (const auto motion = node.find("motion")) scene.motion = read_motion(*motion);
  return scene;
}

Scene scene_from(std::string_view text, const std::string& place) {
  return read_document(text, place, [](const Json& json) {
    Scene scene = read<Scene>(json, "");
    validate(scene);
    return scene;
  });
}

}  // namespace touchstone
