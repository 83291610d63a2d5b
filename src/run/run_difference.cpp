// SPDX-License-Identifier: MIT
#include "run/run_difference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "run/judging.h"

namespace edgecase {
namespace {

using Difference = std::optional<RunDifference>;

std::string words_of(const Results& results) {
  return fmt::format("policy {}{}", results.policy,
                     results.latitude == Latitude::none ? " without latitude" : "");
}

std::string renderer_names(const Results& results) {
  std::vector<std::string> names;
  for (const RendererInfo& info : results.renderers) names.push_back(info.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

// What a renderer says of itself, without what judging says of it.
auto claims_of(const RendererInfo& info) {
  auto traits = info.traits;
  std::erase_if(traits, [](const auto& trait) { return is_of_judging(trait.first); });
  return std::tuple(info.vendor, info.version, info.device, info.subpixel_bits, std::move(traits));
}

std::string words_of(const RendererInfo& info) {
  std::string text = fmt::format("{}, version {}, vendor {}, {} subpixel bits", info.device,
                                 info.version, info.vendor, info.subpixel_bits);
  for (const auto& [name, value] : info.traits)
    if (!is_of_judging(name)) text += fmt::format(", {}: {}", name, value);
  return text;
}

Difference difference_of_renderers(const MergePart& a, const MergePart& b) {
  if (renderer_names(a.results) != renderer_names(b.results))
    return RunDifference{fmt::format("{} holds results of {}, {} of {}", a.name,
                                     renderer_names(a.results), b.name, renderer_names(b.results)),
                         "merge shards of one run"};
  for (std::size_t r = 0; r < a.results.renderers.size(); ++r) {
    const RendererInfo& one = a.results.renderers[r];
    const RendererInfo& other = b.results.renderers[r];
    if (has_never_answered(one) || has_never_answered(other) || claims_of(one) == claims_of(other))
      continue;
    return RunDifference{
        fmt::format("the renderer {} is not the same: in {} it is {}; in {} it is {}", one.name,
                    a.name, words_of(one), b.name, words_of(other)),
        "run all shards against one version"};
  }
  return std::nullopt;
}

}  // namespace

bool has_never_answered(const RendererInfo& renderer) {
  return renderer.device.empty();
}

Difference difference_of_runs(const MergePart& a, const MergePart& b) {
  if (a.results.tool != b.results.tool)
    return RunDifference{fmt::format("{} was written by {}, {} by {}", a.name, a.results.tool,
                                     b.name, b.results.tool),
                         "run all shards with one version"};
  if (words_of(a.results) != words_of(b.results))
    return RunDifference{fmt::format("{} was judged by {}, {} by {}", a.name, words_of(a.results),
                                     b.name, words_of(b.results)),
                         "run all shards with one policy"};
  if (a.results.policy_digest != b.results.policy_digest)
    return RunDifference{
        fmt::format("{} and {} were judged by policies or profiles that differ, though their names "
                    "do not",
                    a.name, b.name),
        "run all shards with the same files"};
  return difference_of_renderers(a, b);
}

}  // namespace edgecase
