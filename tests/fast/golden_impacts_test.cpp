// properties/corpus/impulse/golden.jsonl: 65 impacts of each family of contacts, their numbers as doubles bit for bit,
// and the truth to 50 digits, of which those within `error` count. TOUCHSTONE_UPDATE=1 writes the file again.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "fast/impulse.h"
#include "model/json.h"
#include "properties/scenes/domain.h"
#include "reference/impulse.h"
#include "tests/catch.h"

namespace touchstone::fast {
namespace {

namespace mp = boost::multiprecision;
using Decimal = mp::number<mp::cpp_bin_float<80>, mp::et_off>;
using reference::ImpulseTruth;

constexpr std::uint64_t seed = 2026;
constexpr std::uint64_t draws = 65;  ///< per family

const std::string path = TOUCHSTONE_SOURCE "/properties/corpus/impulse/golden.jsonl";

Decimal decimal(const reference::Rational& r) {
  const std::string text = r.text();
  const auto slash = text.find('/');
  const Decimal numerator(text.substr(0, slash));
  return slash == std::string::npos ? numerator : numerator / Decimal(text.substr(slash + 1));
}

std::string digits(const reference::Rational& r) { return decimal(r).str(50, std::ios::scientific); }

std::vector<const properties::Family*> families() {
  std::vector<const properties::Family*> all;
  for (const properties::Family& family : properties::families()) {
    if (family.id.starts_with("contact.")) all.push_back(&family);
  }
  return all;
}

std::string made(const properties::Family& family, std::uint64_t index) {
  const Scene scene = properties::draw(family, seed, index);
  const ImpulseTruth truth = reference::impulse(scene);
  Json json = {
      {"family", family.id},      {"index", index},
      {"scene", json_of(scene)},  {"P_A_W", {digits(truth.P_A_W[0]), digits(truth.P_A_W[1]), digits(truth.P_A_W[2])}},
      {"p_c", digits(truth.p_c)}, {"p_f", digits(truth.p_f)},
      {"error", truth.error},     {"certified", truth.certified}};
  if (truth.ambiguous) json["ambiguous"] = *truth.ambiguous;
  return json.dump();
}

std::vector<std::string> lines() {
  std::istringstream text(read_text(path));
  std::vector<std::string> all;
  for (std::string line; std::getline(text, line);) all.push_back(line);
  return all;
}

/// √(dPᵀ K dP).
double apart(const ImpulseTruth& of, const std::array<Decimal, 3>& P, const std::array<Decimal, 3>& other) {
  Decimal sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += decimal(of.K_W[i][j]) * (P[i] - other[i]) * (P[j] - other[j]);
  }
  return static_cast<double>(sqrt(sum));
}

TEST_CASE("golden impacts: a sample is still what the reference says, digit for digit") {
  const auto all = families();
  if (std::getenv("TOUCHSTONE_UPDATE") != nullptr) {
    std::string text;
    for (std::uint64_t index = 0; index < draws; ++index) {
      for (const properties::Family* family : all) text += made(*family, index) + "\n";
    }
    write_text(path, text);
  }
  const std::vector<std::string> golden = lines();
  REQUIRE(golden.size() == draws * all.size());
  REQUIRE(golden.size() >= 1000);
  for (std::size_t k = 0; k < golden.size(); k += 41) {
    CHECK(golden[k] == made(*all[k % all.size()], k / all.size()));
  }
}

TEST_CASE("golden impacts: fast is within the error that it states, and the truth for judging within its own") {
  int certified = 0;
  int compared = 0;
  double worst = 0;
  for (const std::string& line : lines()) {
    const Json json = Json::parse(line);
    const Scene scene = scene_from(json.at("scene").dump(), "golden");
    const auto number = [&](std::size_t i) { return Decimal(json.at("P_A_W").at(i).get<std::string>()); };
    const std::array<Decimal, 3> P = {number(0), number(1), number(2)};
    certified += json.at("certified").get<bool>();
    if (json.contains("ambiguous")) continue;
    CAPTURE(json.at("family").get<std::string>(), json.at("index").get<int>());
    const ImpulseTruth some = reference::impulse(scene, reference::Digits::some);
    const double own = json.at("error").get<double>();
    const Decimal trace = decimal(some.K_W[0][0] + some.K_W[1][1] + some.K_W[2][2]);
    const double digits_cut = 1e-48 * static_cast<double>(sqrt(trace) * (abs(P[0]) + abs(P[1]) + abs(P[2])));
    CHECK(apart(some, {decimal(some.P_A_W[0]), decimal(some.P_A_W[1]), decimal(some.P_A_W[2])}, P) <=
          some.error + own + digits_cut);
    const Impacted said = impact(scene);
    const double off = apart(some, {said.P_A_W.x(), said.P_A_W.y(), said.P_A_W.z()}, P);
    CHECK(off <= said.error + own + digits_cut);
    if (said.error > 0) worst = std::max(worst, off / said.error);
    ++compared;
  }
  WARN("worst share of the claimed error: " << worst << " of " << compared);
  CHECK(certified >= 900);
  CHECK(compared >= 1000);
}

}  // namespace
}  // namespace touchstone::fast
