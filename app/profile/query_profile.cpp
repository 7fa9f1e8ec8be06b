#include "app/profile/query_profile.h"

namespace touchstone::app {

void QueryTimes::merge(const QueryTimes& later) {
  answers.resize(later.answers.size());
  for (std::size_t s = 0; s < answers.size(); ++s) answers[s].merge(later.answers[s]);
  plans.merge(later.plans);
}

void QueryProfile::merge(const QueryProfile& later) {
  atlas.resize(later.atlas.size());
  for (std::size_t s = 0; s < atlas.size(); ++s) app::merge(atlas[s], later.atlas[s]);
  left_out.merge(later.left_out);
  times.merge(later.times);
}

}  // namespace touchstone::app
