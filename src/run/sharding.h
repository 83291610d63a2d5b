// SPDX-License-Identifier: MIT
//
// Sharding: the share of the cases for this run, from its option or from the variables of a CI
// system.
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

// The shard that the variables ask for, or all cases if they are not set. Returns a sentence that
// names them if one of a pair is missing or no number, an index is out of range, or the two pairs
// disagree.
// `variable` yields a variable's value, or null, as std::getenv does.
std::variant<ShardChoice, std::string> shard_of_variables(
    const std::function<const char*(const char*)>& variable);

}  // namespace edgecase
