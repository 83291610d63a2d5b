// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <future>
#include <nlohmann/json.hpp>
#include <ostream>
#include <span>
#include <thread>

#include "results/clusters.h"
#include "results/folding.h"
#include "results/hex.h"
#include "results/picture_difference.h"
#include "results/results_json.h"
#include "results/samples_json.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no NaN or infinity; strings say so rather than a null that might mean anything.
Json number(double value) {
  if (value != value) return "nan";
  if (value > 1.7976931348623157e308) return "inf";
  if (value < -1.7976931348623157e308) return "-inf";
  return value;
}

Json numbers(const std::vector<double>& values) {
  Json array = Json::array();
  for (double value : values) array.push_back(number(value));
  return array;
}

Json figure_json(const Figure& figure) {
  Json array = Json::array();
  for (const Mark& mark : figure.marks) {
    Json points = Json::array();
    for (const auto& [x, y] : mark.points) points.push_back({number(x), number(y)});
    Json object = {{"role", name_of(mark.role)}, {"points", std::move(points)}};
    if (mark.closed) object["closed"] = true;
    if (!mark.label.empty()) object["label"] = mark.label;
    array.push_back(std::move(object));
  }
  return array;
}

Json disagreement_json(const Disagreement& d) {
  Json object = {{"pixel", {d.x, d.y}},     {"sample", d.sample}, {"primitive", d.primitive},
                 {"kind", name_of(d.kind)}, {"rule", d.rule},     {"legal", d.legal},
                 {"cause", d.cause}};
  if (!d.situation.empty()) object["situation"] = d.situation;
  if (d.policy_agrees) object["policy_agrees"] = true;
  object["ruling"] = d.ruling;
  if (d.upright)
    object["upright"] = {{"rule", d.upright->rule},
                         {"ruling", d.upright->ruling},
                         {"legal", d.upright->legal},
                         {"cause", d.upright->cause}};
  object["exact"] = numbers(d.exact);
  object["rendered"] = numbers(d.rendered);
  object["explanation"] = d.explanation;
  object["figure"] = figure_json(d.figure);
  return object;
}

Json place_json(const ValueAggregate::Place& place) {
  return Json::array({place.x, place.y, place.primitive});
}

template <class Range, class Convert>
Json list(const Range& range, Convert convert) {
  Json array = Json::array();
  for (const auto& item : range) array.push_back(convert(item));
  return array;
}

// What becomes of long values: folded where the case is large.
struct Keeping {
  bool is_large;
  Json operator()(Json json) const { return is_large ? folded(std::move(json)) : json; }
  Json places(const std::vector<ValueAggregate::Place>& places) const {
    return is_large ? folded(places_json(places)) : list(places, place_json);
  }
};

Json values_json(const ValueAggregate& values, const Keeping& keep) {
  Json histogram = Json::object();
  for (const auto& [bucket, count] : values.ulp_histogram)
    histogram[std::to_string(bucket)] = count;
  Json object = {{"attribute", values.attribute},
                 {"rule", values.rule},
                 {"ruling", values.ruling},
                 {"compared", values.compared},
                 {"components", values.components},
                 {"worst", place_json(values.worst)},
                 {"worst_component", values.worst_component},
                 {"worst_exact", number(values.worst_exact)},
                 {"worst_rendered", number(values.worst_rendered)},
                 {"worst_ulp", number(values.worst_ulp)},
                 {"mean_ulp", number(values.mean_ulp)},
                 {"worst_relative", number(values.worst_relative)},
                 {"ulp_histogram", std::move(histogram)},
                 {"differing", keep.places(values.differing)}};
  if (!values.cause.empty()) object["cause"] = values.cause;
  return object;
}

Json evidence_json(const Result::Evidence& evidence) {
  Json object = {{"primitive", evidence.primitive}, {"causes", evidence.causes}};
  if (evidence.pass >= 0) object["pass"] = evidence.pass;
  if (!evidence.illegal_line_snaps.empty())
    object["illegal_line_snaps"] = evidence.illegal_line_snaps;
  if (!evidence.broken_clause.empty()) object["broken_clause"] = evidence.broken_clause;
  return object;
}

// [x, y, primitive, coverage, depth, [red, green, blue, alpha], pass].
Json fragment_json(const Result::ToldFragment& told) {
  const Fragment& f = told.fragment;
  Json json = {f.x, f.y, f.primitive, f.coverage, nullptr, nullptr};
  if (f.has_depth) json[4] = number(f.depth);
  if (f.has_color) json[5] = list(f.color, number);
  if (told.pass >= 0) json.push_back(told.pass);
  return json;
}

Json level_json(const Result::LevelPoint& point) {
  return Json::array({point.x, point.y, number(point.exact), number(point.low), number(point.high),
                      number(point.rendered)});
}

// Equal pictures are said to be so, not stored twice; of large ones only the difference is stored.
void add_picture(const std::vector<std::uint8_t>& rendered, const std::vector<std::uint8_t>& exact,
                 const Keeping& keep, Json& object) {
  if (rendered == exact)
    object["pixels"] = "exact";
  else if (!keep.is_large || rendered.size() != exact.size())
    object["pixels"] = keep(to_hex(rendered));
  else
    object["difference"] = keep(to_hex(difference_of(rendered, exact)));
}

Json pixel_counts_json(const PixelCounts& counts) {
  return {{"agree", counts.agree},
          {"convention", counts.convention},
          {"permitted", counts.permitted},
          {"violation", counts.violation},
          {"same", counts.same}};
}

Json answer_json(const Judgement& answer) {
  return {{"verdict", name_of(answer.verdict)}, {"fingerprint", answer.fingerprint}};
}

Json result_json(const KnownResult& result, const CaseResults& exact, const Keeping& keep) {
  Json object = {{"verdict", name_of(result.verdict)},
                 {"fingerprint", result.fingerprint},
                 {"standing", name_of(result.standing)}};
  if (!result.expectation.empty()) object["expectation"] = result.expectation;
  if (result.expected) object["expected"] = answer_json(*result.expected);
  if (result.again) object["again"] = answer_json(*result.again);
  if (result.failure)
    object["failure"] = {{"kind", name_of(result.failure->kind)},
                         {"reason", result.failure->reason}};
  if (!result.failure) object["pixel_counts"] = pixel_counts_json(result.pixel_counts);
  object["disagreements"] = keep(list(result.disagreements, disagreement_json));
  object["values"] =
      list(result.values, [&](const ValueAggregate& v) { return values_json(v, keep); });
  object["evidence"] = keep(list(result.evidence, evidence_json));
  object["illegal_line_snaps"] = result.illegal_line_snaps;
  object["refuted"] = result.refuted;
  if (!result.exact_fragments.empty())
    object["exact_fragments"] = keep(list(result.exact_fragments, fragment_json));
  if (!result.rendered_fragments.empty())
    object["rendered_fragments"] = keep(list(result.rendered_fragments, fragment_json));
  if (!result.ramp.empty()) object["ramp"] = list(result.ramp, level_json);
  if (!result.failure) add_picture(result.pixels, exact.pixels, keep, object);
  if (!result.exact_pixels.empty()) object["exact_pixels"] = keep(to_hex(result.exact_pixels));
  if (result.samples.samples > 1) object["samples"] = keep(samples_json(result.samples));
  if (result.exact_samples.samples > 1)
    object["exact_samples"] = keep(samples_json(result.exact_samples));
  return object;
}

// What stands before a case's pixels, and after them.
Json case_head(const CaseResults& one) {
  Json object = {{"id", one.id},           {"title", one.title}, {"why", one.why},
                 {"rules", one.rules},     {"spec", one.spec},   {"origin", one.origin},
                 {"tags", one.tags},       {"file", one.file},   {"file_digest", one.file_digest},
                 {"surface", one.surface}, {"width", one.width}, {"height", one.height}};
  if (const auto& v = one.viewport) object["viewport"] = {v->x, v->y, v->width, v->height};
  object["fragments"] = one.fragments;
  return object;
}

Json case_tail(const CaseResults& one, const std::vector<RendererInfo>& renderers,
               const Keeping& keep) {
  Json results = Json::object();
  for (std::size_t i = 0; i < one.results.size(); ++i)
    results[renderers[i].name] = result_json(one.results[i], one, keep);
  Json object = Json::object();
  if (one.samples.samples > 1) object["samples"] = keep(samples_json(one.samples));
  object["figure"] = keep(figure_json(one.figure));
  object["expect_failures"] = one.expect_failures;
  object["results"] = std::move(results);
  return object;
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

Json missing_json(const MissingCase& missing) {
  return {{"renderer", missing.renderer},
          {"case", missing.id},
          {"verdict", name_of(missing.expected.verdict)},
          {"fingerprint", missing.expected.fingerprint},
          {"reason", missing.reason}};
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
  object["legal"] = cluster.legal;
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

// A case as one JSON object. Its digits need no escapes, and are most of the text.
void write_case(const CaseResults& one, const std::vector<RendererInfo>& renderers,
                std::string& text) {
  const Keeping keep{one.pixels.size() > 4 * kMostPixels};
  const std::string head = dump(case_head(one));
  const std::string tail = dump(case_tail(one, renderers, keep));
  text.append(head, 0, head.size() - 1).append(",\"pixels\":");
  if (keep.is_large) {
    text += dump(keep(to_hex(one.pixels)));
  } else {
    text += '"';
    append_hex(one.pixels, text);
    text += '"';
  }
  text.append(1, ',').append(tail, 1);
}

// Some cases, each on a line of its own.
std::string cases_text(std::span<const CaseResults> cases,
                       const std::vector<RendererInfo>& renderers, bool are_first) {
  constexpr std::size_t kBesidePixels = 4096;  // at least, mostly
  std::size_t size = 0;
  for (const CaseResults& one : cases) size += 2 * one.pixels.size() + kBesidePixels;
  std::string text;
  text.reserve(size);
  const char* separator = are_first ? "\n" : ",\n";
  for (const CaseResults& one : cases) {
    text += separator;
    write_case(one, renderers, text);
    separator = ",\n";
  }
  return text;
}

// Text is made on all processors, a few parts ahead of what is written.
void write_cases(const Results& results, std::ostream& out) {
  constexpr std::size_t kCasesOfPart = 64;
  const std::size_t most_ahead = 2 * std::max(std::thread::hardware_concurrency(), 1u);
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
      << ",\n\"missing\":" << dump(list(results.missing, missing_json))
      << ",\n\"summary\":" << dump(summary_json(results))
      << ",\n\"clusters\":" << dump(clusters_json(results)) << ",\n\"cases\":[";
  write_cases(results, out);
  out << "\n]\n}\n";
}

}  // namespace edgecase
