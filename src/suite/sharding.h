// SPDX-License-Identifier: MIT
//
// Sharding: the share of the cases for this run, from its option or from the variables of a CI
// system, and which cases a shard has.
//
// Bazel sets TEST_TOTAL_SHARDS and TEST_SHARD_INDEX, which counts from 0; GitLab sets CI_NODE_TOTAL
// and CI_NODE_INDEX, which counts from 1. A total of 1 asks for nothing: GitLab sets it, without an
// index, wherever a job is not divided. A variable that is empty counts as one that is not set.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "model/scene.h"
#include "suite/selection.h"

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

// About what it costs to run a case with this scene, beside a small flat triangle.
double cost_of(const Scene& scene);

// Where each of `count` shards begins among cases with these costs, which are in the order of their
// ids: it ends where the next one begins. Shards cost about the same, and none is empty if there
// are as many cases. They are of neighbours, which repeat programs and states of the driver.
std::vector<std::size_t> first_of_shards(std::span<const double> costs, std::size_t count);

}  // namespace edgecase
