// The laws that hold for every query: a hang is no other answer.
#include "properties/judging/asking.h"

#include "tests/catch.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Outcome;

/// Says how many questions it was asked if `counts`, else 1; does not answer one of them.
class Slow : public oracle::Subject {
 public:
  Slow(int hangs_at, bool counts, Breaks::Kind kind) : hangs_at_(hangs_at), counts_(counts), kind_(kind) {}
  const oracle::Card& card() const override { return card_; }
  Answer<Distance> distance(const Scene&) override {
    if (++asked_ == hangs_at_) return Breaks{kind_, "no answer within 1 s"};
    Distance said;
    said.distance = counts_ ? asked_ : 1;
    return said;
  }

 private:
  int hangs_at_;
  bool counts_;
  Breaks::Kind kind_;
  int asked_ = 0;
  oracle::Card card_;
};

Finding repeated(int hangs_at, bool counts = false, Breaks::Kind kind = Breaks::Kind::hung) {
  Slow subject(hangs_at, counts, kind);
  return repeats<Distance>(&oracle::Subject::distance, Scene{}, Scene{}, subject);
}

TEST_CASE("repeats: a question that is answered once and hangs once is not judged") {
  CHECK(repeated(0).outcome == Outcome::holds);
  CHECK(repeated(1).defect == Defect::hung);
  CHECK(repeated(2).outcome == Outcome::outside);
  CHECK(repeated(3).outcome == Outcome::holds);  // the question in between
  CHECK(repeated(4).outcome == Outcome::outside);
  CHECK(repeated(2).why == "answered once, and once not within the time limit");
}

TEST_CASE("repeats: another answer, and any other break, is nondeterministic") {
  CHECK(repeated(0, true).defect == Defect::nondeterministic);
  for (const Breaks::Kind kind : {Breaks::Kind::threw, Breaks::Kind::refused, Breaks::Kind::crashed}) {
    CHECK(repeated(2, false, kind).defect == Defect::nondeterministic);
  }
}

}  // namespace
}  // namespace touchstone::properties
