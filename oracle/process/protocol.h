// The messages between judge and subject: one JSON object per line (docs/protocol.md, docs/protocol.schema.json).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "model/json.h"
#include "oracle/subject.h"

namespace touchstone::oracle::protocol {

inline constexpr int version = 1;

/// The number of a message, counted from 1 in each process. An answer carries the number of its query.
using Seq = std::int64_t;

struct Request {
  enum class Op { start, ask, reproduce, work, stop };
  Op op = Op::start;
  Seq seq = 0;
  std::string query;  ///< unless op is start or stop: the name of a query (oracle/query.h)
  Scene scene;
  std::string expected;  ///< of reproduce: what the program prints before the engine's answer; may be empty
};

/// Each returns one line, with its \n.
std::string start(Seq seq);
std::string ask(Seq seq, std::string_view query, std::string_view scene_json);
std::string reproduce(Seq seq, std::string_view query, std::string_view scene_json, std::string_view expected);
std::string work(Seq seq, std::string_view query, std::string_view scene_json);
std::string stop(Seq seq);
Json json_of(const Domain& domain);      ///< of limits that are there
Json json_of(const Dynamics& dynamics);  ///< of what differs
Json json_of(const std::map<std::string, Precision>& precision_of);
Json json_of(const Card& card);
std::string introduction(Seq seq, const Card& card);
std::string answer(Seq seq, const Json& result);
std::string snippet(Seq seq, const std::string& program);
std::string work(Seq seq, const Work& counts);
std::string answer(Seq seq, const Abstains& abstains);
std::string answer(Seq seq, const Breaks& breaks);

/// Strict, as model/json.h is; InputError names the place. The answer must carry the number `seq`.
Request read_request(std::string_view line);

/// The number of a message that may be unreadable otherwise; 0, which no query has, if it has none.
Seq seq_of(std::string_view line);

Card read_introduction(std::string_view line, Seq seq);
template <class T>
Answer<T> read_answer(std::string_view line, Seq seq);

/// The answer to `reproduce`.
Answer<std::string> read_snippet(std::string_view line, Seq seq);

/// The answer to `work`.
Answer<Work> read_work(std::string_view line, Seq seq);

}  // namespace touchstone::oracle::protocol
