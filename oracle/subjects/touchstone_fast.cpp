#include "oracle/subjects/touchstone_fast.h"

#include "fast/bounds.h"
#include "fast/broad_phase.h"

namespace touchstone::oracle::subjects {
namespace {

class Fast : public Subject {
 public:
  const Card& card() const override { return card_; }
  Answer<Bounds> bounds(const Scene& scene) override { return fast::bounds(scene); }
  Answer<PairSet> broad_phase(const Scene& scene) override { return fast::broad_phase(scene); }

 private:
  const Card card_{.name = "fast",
                   .version = "0.1.0",
                   .answers = {"bounds", "broad_phase"},
                   .about = "Touchstone's optimised algorithms, default strategy",
                   .homepage = "",
                   .deviations = {}};
};

}  // namespace

std::unique_ptr<Subject> make_fast() { return std::make_unique<Fast>(); }

}  // namespace touchstone::oracle::subjects
