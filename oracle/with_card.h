// A subject with another card.
#pragma once

#include <utility>

#include "oracle/passing_on.h"

namespace touchstone::oracle {

/// Shows this card, and passes all questions on. `subject` must outlive this object.
class WithCard final : public PassingOn<WithCard> {
 public:
  WithCard(Subject& subject, Card card) : PassingOn(subject), card_(std::move(card)) {}

  const Card& card() const override { return card_; }

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    return (subject_.*query)(scene);
  }

  Card card_;
};

}  // namespace touchstone::oracle
