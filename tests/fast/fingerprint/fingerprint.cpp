// Prints one number per scene file: a hash of all bits of fast's simulation of it.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "fast/simulation.h"
#include "model/json.h"

namespace touchstone {
namespace {

/// FNV-1a over the bytes of 64-bit words.
class Fingerprint {
 public:
  void add(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) {
      hash_ = (hash_ ^ ((word >> (8 * byte)) & 0xff)) * 0x100000001b3;
    }
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const Vec3& v) {
    for (const double x : v) add(x);
  }
  void add(const State& state) {
    add(state.X_WB.p_WB);
    for (const double x : {state.X_WB.q_WB.w, state.X_WB.q_WB.x, state.X_WB.q_WB.y, state.X_WB.q_WB.z}) add(x);
    add(state.velocity.v_WBcm);
    add(state.velocity.w_WB);
  }
  void add(const Event& event) {
    add(static_cast<std::uint64_t>(event.kind));
    add(event.time);
    add(static_cast<std::uint64_t>(event.a));
    add(static_cast<std::uint64_t>(static_cast<std::int64_t>(event.b)));
    for (const Vec3& v : {event.p_WC, event.nhat_BA_W, event.P_A_W}) add(v);
    add(event.after_a);
    add(event.after_b);
  }

  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace
}  // namespace touchstone

int main(int count, char** paths) {
  using namespace touchstone;
  for (int i = 1; i < count; ++i) {
    const Scene scene = read_scene(paths[i]);
    const Trajectory said = fast::simulate(scene).trajectory;
    Fingerprint bits;
    for (const std::vector<State>& bodies : said.states) {
      for (const State& state : bodies) bits.add(state);
    }
    for (const Event& event : said.events.value()) bits.add(event);
    std::printf("%s %016llx\n", scene.name.c_str(), static_cast<unsigned long long>(bits.value()));
  }
}
