#include "app/motion/replay_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <variant>

#include "app/motion/replay_parts.h"
#include "app/report/xml.h"
#include "model/input_error.h"
#include "model/json.h"

namespace touchstone::app {
namespace {

/// Where Debian's package libjs-three installs them.
constexpr const char* library = "/usr/share/javascript/three/three.min.js";
constexpr const char* orbit_controls = "/usr/share/javascript/three/examples/js/controls/OrbitControls.js";

constexpr std::size_t most_frames = 600;
constexpr std::size_t most_states = 60'000;  // for a page of a few megabytes

Json numbers(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json json_of(const Sphere& sphere) { return {{"radius", sphere.radius}}; }

Json json_of(const Box& box) { return {{"half", numbers(box.half_extents)}}; }

/// Splits the faces, which are plane and convex, into fans of triangles.
Json json_of(const Polytope& polytope) {
  Json vertices = Json::array(), faces = Json::array();
  for (const Vec3& v : polytope.vertices) vertices.push_back(numbers(v));
  for (const std::vector<int>& face : polytope.faces) faces.push_back(face);
  return {{"vertices", std::move(vertices)}, {"faces", std::move(faces)}};
}

Json placed(Json shape, const Pose& pose) {
  const auto& [w, x, y, z] = pose.q_WB;
  shape["p"] = numbers(pose.p_WB);
  shape["q"] = {x, y, z, w};
  return shape;
}

Json parts_of(const Shape& shape) {
  Json parts = Json::array();
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    for (const Part& part : compound->parts) {
      parts.push_back(placed(std::visit([](const auto& s) { return json_of(s); }, part.shape), part.X_BP));
    }
    return parts;
  }
  std::visit(
      [&](const auto& convex) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(convex)>, Compound>) {
          parts.push_back(placed(json_of(convex), Pose{}));
        }
      },
      shape);
  return parts;
}

Json bodies_of(const Scene& scene) {
  Json bodies = Json::array();
  for (const Body& body : scene.bodies) {
    bodies.push_back(
        {{"name", body.name}, {"fixed", std::holds_alternative<Fixed>(body.mass)}, {"parts", parts_of(body.shape)}});
  }
  return bodies;
}

/// Seven numbers per body, rounded, since they are only displayed.
void add_frame(std::string& frames, double time, const std::vector<Pose>& poses) {
  frames += fmt::format("{}[{:.9g}", frames.empty() ? "" : ",\n", time);
  for (const Pose& pose : poses) {
    const auto& [w, x, y, z] = pose.q_WB;
    frames += fmt::format(",{:.7g},{:.7g},{:.7g},{:.5g},{:.5g},{:.5g},{:.5g}", pose.p_WB.x(), pose.p_WB.y(),
                          pose.p_WB.z(), x, y, z, w);
  }
  frames += "]";
}

std::string frames_of(const Scene& scene, const std::vector<double>& times, const Trajectory& trajectory) {
  std::string frames;
  std::vector<Pose> poses;
  for (const Body& body : scene.bodies) poses.push_back(body.X_WB);
  if (scene.motion->start_times.empty()) add_frame(frames, 0, poses);
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::ranges::transform(trajectory.states[k], poses.begin(), [](const State& state) { return state.X_WB; });
    add_frame(frames, times[k], poses);
  }
  return frames;
}

Json events_of(const Trajectory& trajectory) {
  Json events = Json::array();
  for (const Event& event : trajectory.events.value_or(std::vector<Event>{})) {
    events.push_back({event.time, static_cast<int>(event.kind), event.a, event.b});
  }
  return events;
}

/// Escapes a text so that it cannot end the script that contains it.
std::string in_script(std::string text) {
  for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos; at += 3) text.replace(at, 2, "<\\/");
  return text;
}

std::string data_of(const Scene& scene, const std::vector<ReplayRun>& runs, std::size_t middle) {
  std::string all;
  for (const auto& [engine, run] : runs) {
    all += fmt::format("{}{{engine: {}, events: {}, frames: [\n{}\n]}}", all.empty() ? "" : ",\n", Json(engine).dump(),
                       events_of(run->trajectory).dump(), frames_of(scene, run->times, run->trajectory));
  }
  return fmt::format("const data = {{name: {}, bodies: {}, middle: {}, runs: [{}]}};\n", Json(scene.name).dump(),
                     bodies_of(scene).dump(), middle, all);
}

void replace(std::string& text, const std::string& mark, const std::string& by) {
  text.replace(text.find(mark), mark.size(), by);
}

}  // namespace

std::vector<double> with_frames(const Scene& scene, std::size_t runs) {
  std::vector<double> times = scene.motion->sample_times;
  const std::size_t frames =
      std::clamp(most_states / std::max<std::size_t>(scene.bodies.size() * runs, 1), std::size_t{1}, most_frames);
  const double end = times.back();
  const double begin = scene.motion->start_times.empty() ? 0 : std::ranges::max(scene.motion->start_times);
  for (std::size_t k = 1; k < frames; ++k) {
    const double time = begin + (end - begin) * static_cast<double>(k) / static_cast<double>(frames);
    if (time > begin && time < end) times.push_back(time);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

void require_replay_library() {
  for (const char* file : {library, orbit_controls}) {
    if (!std::filesystem::exists(file)) {
      throw InputError("--replay", std::string("needs three.js, and there is no ") + file +
                                       "; on Debian: apt-get install libjs-three");
    }
  }
}

std::string replay_page(const Scene& scene, const std::vector<ReplayRun>& runs, std::size_t middle) {
  require_replay_library();
  std::string page = replay_html;
  // From the last to the first, so that inserted text is not searched again.
  replace(page, "{{script}}", replay_script);
  replace(page, "{{data}}", in_script(data_of(scene, runs, middle)));
  replace(page, "{{controls}}", in_script(read_text(orbit_controls)));
  replace(page, "{{library}}", in_script(read_text(library)));
  replace(page, "{{title}}", escaped(scene.name.empty() ? "a scene" : scene.name));
  return page;
}

}  // namespace touchstone::app
