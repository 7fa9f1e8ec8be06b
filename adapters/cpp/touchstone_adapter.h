// Speaks Touchstone's protocol (docs/protocol.md) for an adapter, which supplies a card and one function a query.
//
//   touchstone_adapter::serve({{"name", "mine"}, {"version", "1"}, {"precision", "binary64"}}, {{"mass", mass}});
//
// A function gets a scene (docs/scene.schema.json) and returns the result (docs/protocol.schema.json). It throws an
// Abstain if it does not answer this scene, a Refused if the engine says that it does not take it; any other exception
// is reported as a failure of the engine, and the next question follows. Needs nlohmann-json 3 (header only) and POSIX.
#pragma once

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace touchstone_adapter {

using Json = nlohmann::ordered_json;
using Vec3 = std::array<double, 3>;
using Queries = std::map<std::string, std::function<Json(const Json& scene)>>;
using Snippets = std::map<std::string, std::function<std::string(const Json& scene)>>;  // programs in its own API

/// This scene is not answered; the message says why.
struct Abstain : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The engine says that it does not take this scene; the message is its reason.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The engine computed NaN or an infinity, which JSON cannot hold; the message says where.
struct NotFinite : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// w, x, y, z of length 1 with the rotation of q, an object of any length but 0, however large or small.
inline std::array<double, 4> unit_quaternion(const Json& q) {
  std::array<double, 4> unit = {q.at("w"), q.at("x"), q.at("y"), q.at("z")};
  double largest = 0, sum = 0;
  for (const double c : unit) largest = std::fmax(largest, std::abs(c));
  for (double& c : unit) c /= largest;
  for (const double c : unit) sum += c * c;
  for (double& c : unit) c /= std::sqrt(sum);
  return unit;
}

/// R(q) v: a vector of the body's frame B, in the world's frame W.
inline Vec3 rotated(const Json& q, const Vec3& v) {
  const auto [w, x, y, z] = unit_quaternion(q);
  const Vec3 t = {2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])};
  return {v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
          v[2] + w * t[2] + x * t[1] - y * t[0]};
}

/// The point of the body's frame B, in the world's frame W: R(q) p_BQ + p.
inline Vec3 in_world(const Json& pose, const Vec3& p_BQ) {
  const Vec3 turned = rotated(pose.at("q"), p_BQ), p = pose.at("p");
  return {turned[0] + p[0], turned[1] + p[1], turned[2] + p[2]};
}

/// The value. Throws NotFinite if a number of it is not finite; the library would silently write null.
inline Json finite(const Json& value, const std::string& place) {
  const double x = value.is_number() ? value.get<double>() : 0;
  if (!std::isfinite(x)) throw NotFinite(place + " is " + (std::isnan(x) ? "NaN" : x > 0 ? "infinity" : "-infinity"));
  std::size_t i = 0;
  for (const auto& [key, part] : value.items()) {
    if (value.is_array()) finite(part, place + '[' + std::to_string(i++) + ']');
    if (value.is_object()) finite(part, place + '.' + key);
  }
  return value;
}

/// Answers until `stop` or the end of stdin. What the engine prints to stdout goes to stderr, and spoils no answer.
inline void serve(Json card, const Queries& queries, const Snippets& snippets = {}) {
  card["answers"] = card["reproduces"] = Json::array();
  for (const auto& [name, query] : queries) card["answers"].push_back(name);
  for (const auto& [name, snippet] : snippets) card["reproduces"].push_back(name);
  std::FILE* const out = fdopen(dup(STDOUT_FILENO), "w");
  if (!out || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) throw std::runtime_error("stdout is closed");
  for (std::string line; std::getline(std::cin, line);) {
    Json answer = {{"seq", 0}};
    const auto breaks = [&](const char* kind, const char* how) { answer["breaks"] = {{"kind", kind}, {"how", how}}; };
    try {
      const Json message = Json::parse(line);
      answer["seq"] = message.at("seq");
      const std::string op = message.at("op");
      if (op == "stop") break;
      if (op == "start") {
        answer.update({{"protocol", 1}, {"card", card}});
      } else if (const std::string name = message.at("query"); op == "reproduce") {
        if (!snippets.count(name)) throw Abstain("no snippets of " + name);
        answer["snippet"] = snippets.at(name)(message.at("scene"));
      } else {
        if (!queries.count(name)) throw Abstain("no " + name + " query");
        answer["result"] = finite(queries.at(name)(message.at("scene")), "result");
      }
    } catch (const Abstain& why) {
      answer["abstains"] = why.what();
    } catch (const Refused& why) {
      breaks("refused", why.what());
    } catch (const NotFinite& where) {
      breaks("garbage", where.what());
    } catch (const std::exception& error) {
      breaks("threw", error.what());
    }
    std::fprintf(out, "%s\n", answer.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
    std::fflush(out);
  }
}

}  // namespace touchstone_adapter
