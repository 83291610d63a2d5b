// SPDX-License-Identifier: MIT
//
// Sharding: which share of the cases this run is about, by its option or by what a CI system says.
//
// Bazel sets TEST_TOTAL_SHARDS and TEST_SHARD_INDEX, which counts from 0; GitLab sets CI_NODE_TOTAL
// and CI_NODE_INDEX, which counts from 1. A total of 1 asks for nothing: GitLab sets it, without an
// index, wherever a job is not divided. A variable that is empty counts as one that is not set.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "run/selection.h"

namespace edgecase {

struct ShardChoice {
  Shard shard;
  std::string source;  // the variables that ask for it: "TEST_TOTAL_SHARDS and TEST_SHARD_INDEX"
};

// "I/N" with I from 1 to N; nothing otherwise.
std::optional<Shard> parse_shard(const std::string& text);

// What the variables ask for: all cases where they ask for nothing. A sentence that names them
// where one of a pair is missing or no number, an index is out of range, or the two pairs disagree.
// `variable` yields a variable's value, or null, as std::getenv does.
std::variant<ShardChoice, std::string> shard_of_variables(
    const std::function<const char*(const char*)>& variable);

}  // namespace edgecase
