#include "app/profile/left_out.h"

#include <optional>
#include <vector>

#include "fast/plan.h"
#include "model/input_error.h"

namespace touchstone::app {
namespace {

std::optional<fast::Plan> plan_for(const Scene& scene, const std::string& query) try {
  if (query == "broad_phase") return fast::plan(scene);
  if ((query != "simulation" && query != "time_of_impact") || !scene.motion) return std::nullopt;
  fast::Plan plan;
  fast::plan_motion(scene, plan);
  return plan;
} catch (const InputError&) {
  return std::nullopt;
}

double seconds_of(const Scene& sequence, const fast::Plan& plan) {
  const double before = thread_cpu_seconds();
  fast::pair_history(sequence, plan);
  return thread_cpu_seconds() - before;
}

}  // namespace

void LeftOut::add(const Scene& scene, const std::string& query) {
  const std::optional<fast::Plan> plan = plan_for(scene, query);
  if (!plan) return;
  ++planned;
  if (plan->left_out.empty()) ++kept;
  for (const auto& [what, why] : plan->left_out) {
    Part& part = parts[what];
    if (part.scenes++ == 0) part.why = why;
  }
}

void LeftOut::merge(const LeftOut& later) {
  planned += later.planned;
  kept += later.kept;
  for (const auto& [what, more] : later.parts) {
    Part& part = parts[what];
    if (part.scenes == 0) part.why = more.why;
    part.scenes += more.scenes;
  }
}

void PlanTimes::measure(const Scene& scene, const std::string& query) try {
  if (query != "broad_phase" || scene.frames.empty()) return;
  const fast::Plan plan = fast::plan(scene), all = fast::all_parts(scene);
  planned.count(seconds_of(scene, plan));
  all_parts.count(seconds_of(scene, all));
} catch (const InputError&) {  // coordinates beyond the limit of the strategies
}

void PlanTimes::merge(const PlanTimes& later) {
  planned.merge(later.planned);
  all_parts.merge(later.all_parts);
}

}  // namespace touchstone::app
