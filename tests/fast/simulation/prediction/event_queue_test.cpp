#include "fast/simulation/prediction/event_queue.h"

#include <set>

#include "tests/catch.h"
#include "tests/fast/allocations.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::simulation {
namespace {

using tests::Dice;

/// The same by a sorted container, slowly.
struct Sorted {
  void drop(BodyId body) {
    std::erase_if(all, [body](const PairEvent& pair_event) { return pair_event.a == body || pair_event.b == body; });
  }
  void pop() { all.erase(all.begin()); }

  std::multiset<PairEvent> all;
};

/// An event at one of few times, so that most events tie.
PairEvent drawn(Dice& dice, BodyId bodies, int times) {
  const auto last = static_cast<int>(bodies) - 1;
  const int b = dice.between(1, last), a = dice.between(0, b - 1);
  return {dice.between(0, times) / 4.0, static_cast<BodyId>(a), static_cast<BodyId>(b)};
}

bool agree(const EventQueue& heap, const Sorted& sorted) {
  if (heap.empty() || sorted.all.empty()) return heap.empty() == sorted.all.empty();
  return heap.top() == *sorted.all.begin();
}

struct Mix {
  int puts, pops, drops, rounds;
};

/// One random call in each round.
void random_calls(EventQueue& heap, Sorted& sorted, BodyId bodies, const Mix& mix, Dice& dice) {
  for (int i = 0; i < mix.rounds; ++i) {
    const int chosen = dice.between(1, mix.puts + mix.pops + mix.drops);
    if (chosen <= mix.puts) {
      const PairEvent pair_event = drawn(dice, bodies, 40);
      heap.put(pair_event);
      sorted.all.insert(pair_event);
    } else if (chosen <= mix.puts + mix.drops) {
      const auto body = static_cast<BodyId>(dice.between(0, static_cast<int>(bodies) - 1));
      heap.drop(body);
      sorted.drop(body);
    } else if (!sorted.all.empty()) {
      heap.pop();
      sorted.pop();
    }
    CAPTURE(i, chosen);
    REQUIRE(agree(heap, sorted));
  }
}

void drain(EventQueue& heap, Sorted& sorted) {
  while (!sorted.all.empty()) {
    REQUIRE(heap.top() == *sorted.all.begin());
    heap.pop();
    sorted.pop();
  }
  REQUIRE(heap.empty());
}

TEST_CASE("pair heap: on top is what a sorted list has first") {
  constexpr BodyId bodies = 60;
  for (int seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    Dice dice(static_cast<std::uint64_t>(seed));
    EventQueue heap(bodies);
    Sorted sorted;
    REQUIRE(heap.empty());
    random_calls(heap, sorted, bodies, {30, 2, 1, 2000}, dice);  // grows, and is cleared in between
    CHECK(sorted.all.size() > 200);
    random_calls(heap, sorted, bodies, {6, 1, 1, 2000}, dice);  // most entries are stale
    random_calls(heap, sorted, bodies, {30, 2, 1, 1000}, dice);
    CHECK(sorted.all.size() > 200);
    drain(heap, sorted);
    random_calls(heap, sorted, bodies, {1, 1, 1, 200}, dice);  // sometimes empty
    drain(heap, sorted);
  }
}

TEST_CASE("pair heap: all of one body go at once, and may come back") {
  EventQueue heap(4);
  heap.put({1, 0, 1});
  heap.put({2, 1, 2});
  heap.put({3, 2, 3});
  heap.drop(1);
  CHECK(heap.top() == PairEvent{3, 2, 3});
  heap.put({2.5, 1, 2});
  CHECK(heap.top() == PairEvent{2.5, 1, 2});
  heap.drop(3);
  heap.pop();
  CHECK(heap.empty());
}

TEST_CASE("pair heap: what is stale beneath the top takes no more room than what is good") {
  constexpr BodyId bodies = 300;
  EventQueue heap(bodies);
  heap.put({0, 0, 1});  // always on top: stale entries below it are not removed
  for (BodyId b = 2; b < bodies; ++b) heap.put({1, 1, b});
  std::size_t before = 0;
  for (int round = 0; round < 20; ++round) {
    if (round == 4) before = tests::allocations();
    for (BodyId b = 2; b < bodies; ++b) {
      heap.drop(b);
      heap.put({2, 1, b});
    }
  }
  CHECK(tests::allocations() == before);
  CHECK(heap.top() == PairEvent{0, 0, 1});
}

}  // namespace
}  // namespace touchstone::fast::simulation
