#include "app/units/shard_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <sstream>

#include "app/report/replay_command.h"
#include "app/report/timing_json.h"
#include "model/input_error.h"
#include "model/json.h"
#include "model/json_node.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* shard_format = "shard/3";
constexpr const char* timing_format = "shard-timing/1";
constexpr int most_shards = 100'000;

Json json_of(const RunOptions& options, const std::vector<std::string>& subjects) {
  return {{"subjects", subjects},
          {"queries", options.queries},
          {"properties", options.properties},
          {"effort", options.effort},
          {"cases", options.cases},
          {"seed", options.seed},
          {"time_limit", options.time_limit},
          {"meshes", options.meshes}};
}

std::vector<std::string> words_of(const Node& node) {
  std::vector<std::string> words;
  for (int i = 0; i < node.size(); ++i) words.push_back(node[i].text());
  return words;
}

RunOptions read_options(const Json& json, const Node& node) {
  RunOptions options;
  options.subjects = words_of(node.at("subjects"));
  options.queries = words_of(node.at("queries"));
  options.properties = words_of(node.at("properties"));
  options.effort = node.at("effort").text();
  options.cases = node.at("cases").index();
  if (!json.contains("seed") || !json["seed"].is_number_unsigned()) node.at("seed").refuse("expected an integer");
  options.seed = json["seed"].get<std::uint64_t>();
  options.time_limit = node.at("time_limit").number();
  options.meshes = node.at("meshes").text();
  return options;
}

/// The command that makes a shard again.
std::string command_of(const RunOptions& options, const std::string& folder, Shard shard) {
  std::string words = "touchstone report";
  for (const std::string& subject : options.subjects) words += " --subjects " + shell_word(subject);
  if (!options.queries.empty()) words += fmt::format(" --queries {}", fmt::join(options.queries, ","));
  if (!options.properties.empty()) words += fmt::format(" --properties {}", fmt::join(options.properties, ","));
  words += fmt::format(" --effort {} --seed {}", options.effort, options.seed);
  if (options.time_limit != RunOptions{}.time_limit) words += fmt::format(" --time-limit {}", options.time_limit);
  if (options.cases > 0) words += fmt::format(" --cases {}", options.cases);
  if (!options.meshes.empty()) words += " --meshes " + shell_word(options.meshes);
  return words + fmt::format(" --shard {}/{} --out {}", shard.number, shard.of, shell_word(folder));
}

/// Beside a shard.
fs::path timing_file(const fs::path& shard) { return fs::path(shard).replace_extension(".timing.json"); }

/// Times are no result: a shard without its file of times only has none.
std::map<std::string, QueryTimes> read_shard_times(const fs::path& shard) {
  const fs::path file = timing_file(shard);
  if (!fs::is_regular_file(file)) return {};
  const std::string place = file.string();
  const Json json = parse(read_text(place), place);
  const Node node(json, place);
  if (node.at("touchstone").text() != timing_format) node.at("touchstone").refuse("expected \"shard-timing/1\"");
  return read_times(json.at("times"), node.at("times"));
}

struct ShardFile {
  Shard shard;
  Json plan;
  ShardResult result;
};

ShardFile read_shard(const std::string& file) {
  std::istringstream lines(read_text(file));
  std::vector<Json> all;
  for (std::string line; std::getline(lines, line);) {
    all.push_back(parse(line, fmt::format("{}:{}", file, all.size() + 1)));
  }
  if (all.size() < 2 || !all.back().is_object() || !all.back().contains("end")) {
    throw InputError(file, "is cut off: its last line is missing");
  }
  const std::string place = file + ":1";  // a node does not keep it
  const Node head(all.front(), place);
  if (head.at("touchstone").text() != shard_format)
    head.at("touchstone").refuse(fmt::format("expected \"{}\"", shard_format));
  ShardFile shard;
  shard.shard = {head.at("shard").index(), head.at("of").index()};
  head.at("plan");
  shard.plan = all.front()["plan"];
  shard.result.versions = words_of(head.at("versions"));
  shard.result.units.assign(all.begin() + 1, all.end() - 1);
  shard.result.times = read_shard_times(file);
  return shard;
}

}  // namespace

Shard shard_of(const std::string& word) {
  Shard shard{0, 0};
  const char* const end = word.data() + word.size();
  const auto [slash, error] = std::from_chars(word.data(), end, shard.number);
  if (error == std::errc() && slash != end && *slash == '/') {
    const auto [rest, second_error] = std::from_chars(slash + 1, end, shard.of);
    const bool is_read = second_error == std::errc() && rest == end;
    if (is_read && 1 <= shard.number && shard.number <= shard.of && shard.of <= most_shards) return shard;
  }
  throw InputError("--shard", fmt::format("expected NUMBER/OF as 3/8, found \"{}\"", word));
}

std::string shard_file(const std::string& folder, Shard shard) {
  return (fs::path(folder) / fmt::format("shard-{}-of-{}.jsonl", shard.number, shard.of)).string();
}

void write_shard(const std::string& file, Shard shard, const RunOptions& options,
                 const std::vector<std::string>& subjects, const ShardResult& result) {
  const Json head = {{"touchstone", shard_format},
                     {"shard", shard.number},
                     {"of", shard.of},
                     {"versions", result.versions},
                     {"plan", json_of(options, subjects)}};
  const auto line = [](const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; };
  std::string text = line(head);
  for (const Json& unit : result.units) text += line(unit);
  write_text(timing_file(file).string(), line({{"touchstone", timing_format}, {"times", json_of(result.times)}}));
  write_text(file, text + line({{"end", result.units.size()}}));
}

ReadShards read_shards(const std::string& folder) {
  if (!fs::is_directory(folder)) throw InputError(folder, "is no folder");
  std::map<int, ShardFile> shards;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("shard-") || entry.path().extension() != ".jsonl") continue;
    ShardFile shard = read_shard(entry.path().string());
    const int number = shard.shard.number;
    if (!shards.try_emplace(number, std::move(shard)).second) {
      throw InputError(entry.path().string(), fmt::format("there is another shard {}", number));
    }
  }
  if (shards.empty()) throw InputError(folder, "has no file shard-NUMBER-of-OF.jsonl");
  const ShardFile& first = shards.begin()->second;
  const std::string place = folder + ": plan";
  ReadShards all{read_options(first.plan, Node(first.plan, place)), {}};
  for (int number = 1; number <= first.shard.of; ++number) {
    const auto found = shards.find(number);
    if (found == shards.end()) {
      throw InputError(folder, fmt::format("shard {} of {} is missing; to run it: {}", number, first.shard.of,
                                           command_of(all.options, folder, {number, first.shard.of})));
    }
    const ShardFile& shard = found->second;
    const std::string file = shard_file(folder, shard.shard);
    if (shard.shard.of != first.shard.of || shard.plan != first.plan) {
      throw InputError(file, "is of another run: its options differ from those of the first shard");
    }
    if (shard.result.versions != first.result.versions) {
      throw InputError(file,
                       fmt::format("was asked of other versions: {}; those of the first shard are {}",
                                   fmt::join(shard.result.versions, ", "), fmt::join(first.result.versions, ", ")));
    }
    all.shards.push_back(shard.result);
  }
  return all;
}

}  // namespace touchstone::app
