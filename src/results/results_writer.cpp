// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <future>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <utility>

#include "base/threads.h"
#include "results/case_results_json.h"
#include "results/clusters.h"
#include "results/packed_text.h"
#include "results/results_json.h"
#include "rules/choices.h"

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
  Json json = {{"index", shard.index + 1},
               {"count", shard.count},
               {"cases", shard.cases},
               {"selection", shard.selection}};
  if (shard.faulty > 0) json["faulty"] = shard.faulty;
  return json;
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

// Members that a cluster does not have are left out.
Json cluster_json(const Cluster& cluster) {
  Json object = Json::object();
  const auto add = [&object](const char* name, const std::string& text) {
    if (!text.empty()) object[name] = text;
  };
  add("cause", cluster.cause);
  add("rule", cluster.rule);
  add("kind", cluster.kind);
  add("attribute", cluster.attribute);
  add("surface", cluster.surface);
  object["legality"] = name_of(cluster.legality);
  object["disagreements"] = cluster.disagreements;
  object["cases"] = cluster.cases;
  if (!cluster.situations.empty()) object["situations"] = cluster.situations;
  add("common", cluster.common);
  object["smallest"] = {{"case", cluster.smallest_case},
                        {"pixel", {cluster.x, cluster.y}},
                        {"primitive", cluster.primitive}};
  return object;
}

using Gatherers = std::vector<ClusterGatherer>;  // by renderer

// renderer -> its clusters in their order.
Json clusters_json(const std::vector<RendererInfo>& renderers, Gatherers& gatherers) {
  Json json = Json::object();
  for (std::size_t i = 0; i < renderers.size(); ++i)
    json[renderers[i].name] = list(gatherers[i].take(), cluster_json);
  return json;
}

// Names and messages may hold bytes that are no UTF-8; they are replaced, never fatal.
std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Some cases, each on its own line, after its head if that is new.
struct Part {
  std::vector<CaseResults> cases;
  std::vector<std::size_t> heads;  // by case
  std::size_t first_new = 0;       // head
};

// The fields that cases of one file mostly share, as a key.
std::string head_of(const CaseResults& one) {
  std::string text;
  append_head(one, 0, text);
  return text;
}

std::string text_of(const Part& part, const std::vector<RendererInfo>& renderers) {
  std::string text;
  std::size_t next_head = part.first_new;
  for (std::size_t i = 0; i < part.cases.size(); ++i) {
    if (part.heads[i] == next_head) {
      append_head(part.cases[i], next_head++, text);
      text += '\n';
    }
    append_case(part.cases[i], part.heads[i], renderers, text);
    text += '\n';
  }
  return text;
}

// Divides cases into parts, and numbers their heads. Cases of a file stand together, so that only
// its heads are remembered.
class Divider {
 public:
  explicit Divider(const CaseList& cases) : cases_(cases) {}

  bool is_at_end() const { return next_ == cases_.size(); }
  Part next() {
    constexpr std::size_t kMostCases = 64;
    constexpr std::size_t kMostBytes = std::size_t{1} << 20;
    Part part{{}, {}, count_};
    std::size_t bytes = 0;
    for (; !is_at_end() && part.cases.size() < kMostCases && bytes < kMostBytes; ++next_) {
      bytes += cases_.bytes(next_);
      part.cases.push_back(cases_[next_]);
      part.heads.push_back(number_of(part.cases.back()));
    }
    return part;
  }

 private:
  std::size_t number_of(const CaseResults& one) {
    if (one.file != file_) numbers_.clear();
    file_ = one.file;
    const auto [found, is_new] = numbers_.try_emplace(head_of(one), count_);
    if (is_new) ++count_;
    return found->second;
  }

  const CaseList& cases_;
  std::size_t next_ = 0;   // case
  std::size_t count_ = 0;  // of heads
  std::string file_;
  std::map<std::string, std::size_t> numbers_;  // of the file's heads
};

using Take = std::function<void(std::string)>;

// Text is made on all processors, a few parts ahead of what is taken. The clusters are gathered on
// the way, while the cases are at hand.
void write_cases(const Results& results, const Take& take, Gatherers& gatherers) {
  struct Written {
    Part part;
    std::string text;
  };
  Ahead<Written> parts;
  const auto take_first = [&] {
    Written first = parts.take();
    take(std::move(first.text));
    for (const CaseResults& one : first.part.cases)
      for (std::size_t r = 0; r < std::min(gatherers.size(), one.results.size()); ++r)
        gatherers[r].add(one, one.results[r]);
  };
  for (Divider divider(results.cases); !divider.is_at_end();) {
    if (parts.is_full()) take_first();
    parts.start([part = divider.next(), &results]() mutable {
      std::string text = text_of(part, results.renderers);
      return Written{std::move(part), std::move(text)};
    });
  }
  while (!parts.empty()) take_first();
}

Json header_json(const Results& results) {
  Json json = {{"edgecase_results", kResultsFormat},
               {"tool", results.tool},
               {"policy", results.policy},
               {"latitude", name_of(results.latitude)},
               {"policy_digest", results.policy_digest},
               {"whole_suite", results.whole_suite}};
  if (results.shard) json["shard"] = shard_json(*results.shard);
  json["renderers"] = list(results.renderers, renderer_json);
  return json;
}

Json end_json(const Results& results, Gatherers& gatherers) {
  Json json = {
      {"end", true}, {"cases", results.cases.size()}, {"interrupted", results.interrupted}};
  if (results.left_out > 0) json["left_out"] = results.left_out;
  json["diagnostics"] = list(results.diagnostics, diagnostic_json);
  json["faults"] = list(results.faults, fault_json);
  json["summary"] = summary_json(results);
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    json["portraits"][results.renderers[r].name] = sentences_of(portrait_of(results, r));
  for (const auto& [renderer, surfaces] : results.refuted)
    for (const auto& [surface, refuted] : surfaces)
      if (const std::string text = text_of_refuted(refuted); !text.empty())
        json["refuted"][renderer][surface] = text;
  if (!results.rules.empty()) json["rules"] = results.rules;
  json["clusters"] = clusters_json(results.renderers, gatherers);
  return json;
}

}  // namespace

std::string header_line(const Results& results) {
  return dump(header_json(results)) + '\n';
}

std::string case_lines(const CaseResults& one, std::size_t number,
                       const std::vector<RendererInfo>& renderers) {
  std::string text;
  append_head(one, number, text);
  text += '\n';
  append_case(one, number, renderers, text);
  return text += '\n';
}

namespace {

void write_lines(const Results& results, const Take& take) {
  take(header_line(results));
  Gatherers gatherers;
  for (std::size_t r = 0; r < results.renderers.size(); ++r) gatherers.emplace_back(results, r);
  write_cases(results, take, gatherers);
  take(dump(end_json(results, gatherers)) + '\n');
}

}  // namespace

void write_results(const Results& results, std::ostream& out) {
  write_lines(results, [&](const std::string& text) { out << text; });
}

void write_packed_results(const Results& results, std::ostream& out) {
  TextPacker packer(out);
  // One text is packed while the next ones are made.
  std::future<void> packing;
  const auto wait = [&] {
    if (packing.valid()) packing.get();
  };
  write_lines(results, [&](std::string text) {
    wait();
    packing =
        std::async(std::launch::async, [&packer, text = std::move(text)] { packer.add(text); });
  });
  wait();
  packer.finish();
}

}  // namespace edgecase
