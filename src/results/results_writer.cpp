// SPDX-License-Identifier: MIT
#include <algorithm>
#include <deque>
#include <functional>
#include <future>
#include <nlohmann/json.hpp>
#include <ostream>
#include <span>
#include <thread>

#include "results/case_results_writer.h"
#include "results/clusters.h"
#include "results/results_json.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

template <class Range, class Convert>
Json list(const Range& range, Convert convert) {
  Json array = Json::array();
  for (const auto& item : range) array.push_back(convert(item));
  return array;
}

Json renderer_json(const RendererInfo& info) {
  return {{"name", info.name},
          {"vendor", info.vendor},
          {"version", info.version},
          {"device", info.device},
          {"subpixel_bits", info.subpixel_bits},
          {"traits", info.traits}};
}

Json diagnostic_json(const Diagnostic& d) {
  return {{"file", d.file},
          {"line", d.line},
          {"pointer", d.pointer},
          {"message", d.message},
          {"remedy", d.remedy}};
}

Json shard_json(const ShareOfRun& shard) {
  return {{"index", shard.index + 1},
          {"count", shard.count},
          {"cases", shard.cases},
          {"selection", shard.selection}};
}

Json fault_json(const FaultSeen& seen) {
  Json json = {{"renderer", seen.renderer}, {"id", seen.id},       {"reason", seen.reason},
               {"link", seen.link},         {"cases", seen.cases}, {"state", name_of(seen.state)}};
  if (seen.before) json["before"] = *seen.before;
  return json;
}

// renderer -> verdict -> number of cases.
Json summary_json(const Results& results) {
  Json summary = Json::object();
  for (std::size_t i = 0; i < results.renderers.size(); ++i) {
    Json counts = Json::object();
    for (const auto& [verdict, count] : count_verdicts(results, i))
      counts[name_of(verdict)] = count;
    summary[results.renderers[i].name] = std::move(counts);
  }
  return summary;
}

// What a cluster does not have is left out.
Json cluster_json(const Cluster& cluster) {
  Json object = Json::object();
  const auto add = [&object](const char* name, const std::string& text) {
    if (!text.empty()) object[name] = text;
  };
  add("cause", cluster.cause);
  add("rule", cluster.rule);
  add("kind", cluster.kind);
  add("situation", cluster.situation);
  add("attribute", cluster.attribute);
  add("surface", cluster.surface);
  object["legality"] = name_of(cluster.legality);
  object["disagreements"] = cluster.disagreements;
  object["cases"] = cluster.cases;
  object["smallest"] = {{"case", cluster.smallest_case},
                        {"pixel", {cluster.x, cluster.y}},
                        {"primitive", cluster.primitive}};
  return object;
}

// renderer -> its clusters in their order.
Json clusters_json(const Results& results) {
  Json clusters = Json::object();
  for (std::size_t i = 0; i < results.renderers.size(); ++i)
    clusters[results.renderers[i].name] = list(clusters_of(results, i), cluster_json);
  return clusters;
}

// Names and messages may hold bytes that are no UTF-8; they are replaced, never fatal.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Some cases, each on a line of its own.
std::string cases_text(std::span<const CaseResults> cases,
                       const std::vector<RendererInfo>& renderers, bool are_first) {
  constexpr std::size_t kBesidePixels = 4096;  // at least, mostly
  std::size_t size = 0;
  for (const CaseResults& one : cases) size += 8 * one.pixels->size() + kBesidePixels;
  std::string text;
  text.reserve(size);
  const char* separator = are_first ? "\n" : ",\n";
  for (const CaseResults& one : cases) {
    text += separator;
    append_case(one, renderers, text);
    separator = ",\n";
  }
  return text;
}

// Text is made on all processors, a few parts ahead of what is written.
void write_cases(const Results& results, std::ostream& out) {
  constexpr std::size_t kCasesOfPart = 64;
  const std::size_t most_ahead = 2 * std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
  std::deque<std::future<std::string>> parts;
  const auto write_first = [&] {
    out << parts.front().get();
    parts.pop_front();
  };
  const std::span<const CaseResults> cases = results.cases;
  for (std::size_t first = 0; first < cases.size(); first += kCasesOfPart) {
    if (parts.size() >= most_ahead) write_first();
    const auto part = cases.subspan(first, std::min(kCasesOfPart, cases.size() - first));
    parts.push_back(
        std::async(std::launch::async, cases_text, part, std::cref(results.renderers), first == 0));
  }
  while (!parts.empty()) write_first();
}

}  // namespace

void write_results(const Results& results, std::ostream& out) {
  out << "{\n\"tool\":" << dump(results.tool) << ",\n\"policy\":" << dump(results.policy)
      << ",\n\"latitude\":" << dump(name_of(results.latitude))
      << ",\n\"policy_digest\":" << dump(results.policy_digest)
      << ",\n\"interrupted\":" << (results.interrupted ? "true" : "false");
  if (results.left_out > 0) out << ",\n\"left_out\":" << results.left_out;
  out << ",\n\"whole_suite\":" << (results.whole_suite ? "true" : "false");
  if (results.shard) out << ",\n\"shard\":" << dump(shard_json(*results.shard));
  out << ",\n\"renderers\":" << dump(list(results.renderers, renderer_json))
      << ",\n\"diagnostics\":" << dump(list(results.diagnostics, diagnostic_json))
      << ",\n\"faults\":" << dump(list(results.faults, fault_json))
      << ",\n\"summary\":" << dump(summary_json(results))
      << ",\n\"clusters\":" << dump(clusters_json(results)) << ",\n\"cases\":[";
  write_cases(results, out);
  out << "\n]\n}\n";
}

}  // namespace edgecase
