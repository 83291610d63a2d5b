// SPDX-License-Identifier: MIT
#include "suite/sharding.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>

#include "casefile/scene/scene_reader.h"
#include "results/results.h"

namespace edgecase {
namespace {

using Variable = std::function<const char*(const char*)>;

// Costs beside that of a small case with one flat triangle, as measured with llvmpipe: of a sample,
// and what is added where its colour varies in a multisampled target, where its derivatives are
// told, or where it is looked up in a texture; of a draw with a polygon offset, which llvmpipe
// compiles; of a mip chain that the driver generates; of a further pass.
constexpr double kSample = 0.007;
constexpr double kVaryingSample = 0.055;
constexpr double kDerivedSample = 0.15;
constexpr double kTexturedSample = 0.035;
constexpr double kMipmappedSample = 0.125;
constexpr double kAnisotropicSample = 0.5;
constexpr double kOffset = 4.7;
constexpr double kMipChain = 30;
constexpr double kPass = 1.1;

double cost_of_sample(const Scene& scene, const Draw& draw) {
  double cost = kSample;
  if (scene.details.derivatives) cost += kDerivedSample;
  if (scene.target.samples > 1 && draw.interpolation != Interpolation::flat) cost += kVaryingSample;
  if (!draw.texture) return cost;
  const Sampler& sampler = draw.texture->sampler;
  const LookupKind kind = draw.texture->lookup.kind;
  const bool derives_level = kind == LookupKind::implicit || kind == LookupKind::bias;
  if (sampler.max_anisotropy > 1) return cost + kAnisotropicSample;
  if (sampler.mipmap != MipFilter::none && derives_level) return cost + kMipmappedSample;
  return cost + kTexturedSample;
}

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

double cost_of(const Scene& scene) {
  double cost = 1;
  double of_sample = kSample;
  for (const Draw& draw : scene.draws) {
    of_sample = std::max(of_sample, cost_of_sample(scene, draw));
    if (draw.polygon_offset) cost += kOffset;
  }
  for (const auto& texture : scene.textures)
    if (texture->generated) cost += kMipChain;
  for (std::size_t pass = 1; pass < scene.supersampling.size(); ++pass) cost += kPass;
  return cost + of_sample * static_cast<double>(most_drawn_samples(scene));
}

std::vector<std::size_t> first_of_shards(std::span<const double> costs, std::size_t count) {
  std::vector<std::size_t> first;
  double left = std::accumulate(costs.begin(), costs.end(), 0.0);
  std::size_t at = 0;
  for (std::size_t shards = count; shards > 0; --shards) {
    first.push_back(at);
    if (at == costs.size()) continue;
    const double share = left / static_cast<double>(shards);
    double taken = costs[at++];
    // Those behind keep a case each.
    while (at + shards <= costs.size() && (shards == 1 || taken + costs[at] / 2 < share))
      taken += costs[at++];
    left -= taken;
  }
  return first;
}

}  // namespace edgecase
