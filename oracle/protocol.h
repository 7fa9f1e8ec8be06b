// The messages between judge and subject: one JSON object a line (docs/protocol.md, docs/protocol.schema.json).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "model/json.h"
#include "oracle/subject.h"

namespace touchstone::oracle::protocol {

inline constexpr int version = 1;

/// Counts the messages of a process from 1; the answer carries its question's.
using Seq = std::int64_t;

struct Request {
  enum class Op { start, ask, stop };
  Op op = Op::start;
  Seq seq = 0;
  std::string query;  ///< of ask: "mass", "bounds", "broad_phase", "pair_history", "distance", "penetration",
                      ///< "impulse", "pixel"
  Scene scene;
};

/// Lines, each with its \n.
std::string start(Seq seq);
std::string ask(Seq seq, std::string_view query, std::string_view scene_json);
std::string stop(Seq seq);
Json json_of(const Card& card);
std::string introduction(Seq seq, const Card& card);
std::string answer(Seq seq, const Json& result);
std::string answer(Seq seq, const Abstains& abstains);
std::string answer(Seq seq, const Breaks& breaks);

/// Strict, as model/json.h is; InputError names the place. `seq` is the one that the answer must carry.
Request read_request(std::string_view line);

/// That of a message which may be unreadable otherwise; 0, which no question has, if there is none.
Seq seq_of(std::string_view line);

Card read_introduction(std::string_view line, Seq seq);
template <class T>
Answer<T> read_answer(std::string_view line, Seq seq);

}  // namespace touchstone::oracle::protocol
