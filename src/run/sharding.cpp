// SPDX-License-Identifier: MIT
#include "run/sharding.h"

#include <fmt/format.h>

#include <charconv>

namespace edgecase {
namespace {

using Variable = std::function<const char*(const char*)>;

constexpr int kMostShards = 1'000'000;

struct Pair {
  const char* total;
  const char* index;
  int first;  // what the index counts from
};

constexpr Pair kBazel = {"TEST_TOTAL_SHARDS", "TEST_SHARD_INDEX", 0};
constexpr Pair kGitLab = {"CI_NODE_TOTAL", "CI_NODE_INDEX", 1};

std::optional<int> to_number(const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end || value < 0 || value > kMostShards)
    return std::nullopt;
  return value;
}

std::string value_of(const Variable& variable, const char* name) {
  const char* value = variable(name);
  return value != nullptr ? value : "";
}

using Asked = std::variant<std::optional<Shard>, std::string>;

// The shard that one pair asks for, or nothing, or what is wrong with it.
Asked shard_of(const Pair& pair, const Variable& variable) {
  const std::string total = value_of(variable, pair.total);
  const std::string index = value_of(variable, pair.index);
  if (total.empty() && index.empty()) return std::nullopt;
  if (total.empty())
    return fmt::format("{} is set and {} is not; set both or neither", pair.index, pair.total);
  const auto count = to_number(total);
  if (!count || *count < 1)
    return fmt::format("{} is \"{}\"; set it to the number of shards, from 1", pair.total, total);
  if (index.empty()) {
    if (*count == 1) return std::nullopt;
    return fmt::format("{} is set and {} is not; set both or neither", pair.total, pair.index);
  }
  const auto at = to_number(index);
  if (!at || *at < pair.first || *at - pair.first >= *count)
    return fmt::format("{} is \"{}\"; with {}={} set it to a number from {} to {}", pair.index,
                       index, pair.total, *count, pair.first, *count - 1 + pair.first);
  if (*count == 1) return std::nullopt;
  return Shard{*at - pair.first, *count};
}

std::string variables_of(const Pair& pair) {
  return fmt::format("{} and {}", pair.total, pair.index);
}

}  // namespace

std::optional<Shard> parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto index = to_number(text.substr(0, slash));
  const auto count = to_number(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count) return std::nullopt;
  return Shard{*index - 1, *count};
}

std::variant<ShardChoice, std::string> shard_of_variables(const Variable& variable) {
  const Asked bazel = shard_of(kBazel, variable);
  if (const auto* fault = std::get_if<std::string>(&bazel)) return *fault;
  const Asked gitlab = shard_of(kGitLab, variable);
  if (const auto* fault = std::get_if<std::string>(&gitlab)) return *fault;
  const auto& one = std::get<std::optional<Shard>>(bazel);
  const auto& other = std::get<std::optional<Shard>>(gitlab);
  if (one && other && (one->index != other->index || one->count != other->count))
    return fmt::format("{} ask for shard {}/{}, {} for shard {}/{}; unset one pair, or say --shard",
                       variables_of(kBazel), one->index + 1, one->count, variables_of(kGitLab),
                       other->index + 1, other->count);
  if (one) return ShardChoice{*one, variables_of(kBazel)};
  if (other) return ShardChoice{*other, variables_of(kGitLab)};
  return ShardChoice{};
}

}  // namespace edgecase
