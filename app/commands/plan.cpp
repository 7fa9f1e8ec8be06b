#include "app/commands/plan.h"

#include "app/motion/given_scene.h"
#include "app/system/terminal.h"
#include "fast/plan.h"
#include "model/json.h"

namespace touchstone::app {
namespace {

/// A scene in motion is planned as a simulation, any other as a broad phase.
fast::Plan plan_of(const Scene& scene) {
  if (!scene.motion) return fast::plan(scene);
  fast::Plan plan;
  fast::plan_motion(scene, plan);
  return plan;
}

Json json_of(const std::vector<fast::Choice>& choices) {
  Json list = Json::array();
  for (const auto& [what, why] : choices) list.push_back({{"what", what}, {"why", why}});
  return list;
}

void show(const char* title, const std::vector<fast::Choice>& choices) {
  if (choices.empty()) return;
  print("{}\n", title);
  for (const auto& [what, why] : choices) print("  {}: {}\n", what, why);
}

}  // namespace

void plan(const std::string& name_or_file, bool as_json) {
  const Scene scene = given_scene(name_or_file).scene;
  const fast::Plan plan = plan_of(scene);
  if (as_json) {
    Json json = {{"scene", scene.name}};
    if (!plan.strategy.empty()) json["strategy"] = plan.strategy;
    json["used"] = json_of(plan.used);
    json["left_out"] = json_of(plan.left_out);
    print_lines(text_of(json));
    return;
  }
  show("used", plan.used);
  show("left out", plan.left_out);
}

}  // namespace touchstone::app
