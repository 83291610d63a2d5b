// SPDX-License-Identifier: MIT
#include "reports/case_details.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reports/base64.h"
#include "reports/pixels.h"
#include "reports/ramp.h"
#include "reports/sample_data.h"
#include "reports/text.h"
#include "results/worst_first.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  // Whole numbers are written without ".0": JavaScript has only one kind of number.
  if (value == std::floor(value) && std::abs(value) < 1e15 && !std::signbit(value))
    return static_cast<std::int64_t>(value);
  return value;
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (double value : values) list.push_back(number(value));
  return list;
}

Json figure_json(const Figure& figure) {
  Json marks = Json::array();
  for (const Mark& mark : figure.marks) {
    Json points = Json::array();
    for (const auto& [x, y] : mark.points) {
      points.push_back(number(x));
      points.push_back(number(y));
    }
    marks.push_back(Json::array({name_of(mark.role), mark.closed ? 1 : 0, mark.label, points}));
  }
  return marks;
}

// Empty fields are omitted, since a report holds thousands of disagreements.
Json disagreement_json(const Disagreement& d, int samples) {
  Json json = {{"x", d.x}, {"y", d.y}, {"kind", name_of(d.kind)}, {"rule", name_of(d.rule)}};
  if (names_sample(d, samples)) json["sample"] = d.sample;
  if (d.primitive >= 0) json["primitive"] = d.primitive;
  json["legality"] = name_of(d.legality);
  if (!d.cause.empty()) json["cause"] = text_of(d.cause);
  if (!d.situation.empty()) json["situation"] = d.situation;
  if (d.ruling != 0) json["ruling"] = d.ruling;
  json["exact"] = numbers(d.exact);
  json["rendered"] = numbers(d.rendered);
  json["explanation"] = d.explanation;
  if (!d.figure.marks.empty()) json["figure"] = figure_json(d.figure);
  return json;
}

Json values_json(const ValueAggregate& v) {
  Json places = Json::array();
  // In the order in which results have them.
  std::vector<ValueAggregate::Place> sorted = v.differing;
  const auto row_and_column = [](const auto& place) { return std::pair(place.y, place.x); };
  if (!std::ranges::is_sorted(sorted, {}, row_and_column))
    std::ranges::sort(sorted, {}, row_and_column);
  const std::size_t listed = std::min(sorted.size(), kMaxDisagreementsPerAnswer);
  for (std::size_t i = 0; i < listed; ++i) {
    places.push_back(sorted[i].x);
    places.push_back(sorted[i].y);
  }
  Json histogram = Json::array();
  for (const auto& [exponent, count] : v.ulp_histogram)
    histogram.push_back(Json::array({exponent, count}));
  return {{"attribute", v.attribute},
          {"rule", name_of(v.rule)},
          {"ruling", v.ruling},
          {"cause", text_of(v.cause)},
          {"compared", v.compared},
          {"differing", v.differing.size()},
          {"places", places},
          {"worst",
           {{"x", v.worst.x},
            {"y", v.worst.y},
            {"primitive", v.worst.primitive},
            {"component", v.worst_component},
            {"exact", number(v.worst_exact)},
            {"rendered", number(v.worst_rendered)},
            {"permitted", std::isnan(v.worst_low)
                              ? Json()
                              : Json::array({number(v.worst_low), number(v.worst_high)})},
            {"ulp", number(v.worst_ulp)}}},
          {"components", v.components},
          {"mean_ulp", number(v.mean_ulp)},
          {"relative", number(v.worst_relative)},
          {"histogram", histogram}};
}

// Float32 numbers, in the fewest digits that distinguish them.
Json level(double value) {
  if (!std::isfinite(static_cast<float>(value))) return number(static_cast<float>(value));
  const std::string digits = fmt::format("{}", static_cast<float>(value));
  double shortest = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), shortest);
  return number(shortest);
}

Json ramp_json(const Result& result) {
  Json points = Json::array();
  for (const Result::LevelPoint& p : result.ramp)
    points.push_back(
        Json::array({p.x, p.y, level(p.exact), level(p.low), level(p.high), level(p.rendered)}));
  const RampSummary summary = summarize_ramp(result.ramp);
  Json json = {
      {"points", points}, {"words", describe(summary)}, {"outside", Json(summary.outside)}};
  if (summary.farthest) json["farthest"] = *summary.farthest;
  if (!summary.outside.empty()) json["causes"] = open_causes_of_levels(result);
  return json;
}

// The images of an answer, each as a difference: the rendered one from exact's; exact's from the
// case's, if it was drawn with other sample positions.
void add_images(Json& json, const CaseResults& one, const Result& result) {
  const bool own = !result.exact_pixels->empty();
  const Shared<PackedWords>& exact = own ? result.exact_pixels : one.pixels;
  const bool same_size = result.pixels->size() == exact->size();
  if (same_size && result.pixels != exact)
    json["difference"] =
        to_base64(pack_pixels(difference_of(exact->bytes(), result.pixels->bytes())));
  if (!same_size || result.pixels->empty()) json["blank"] = true;
  if (result.samples.samples > 1)
    json["samples"] = sample_difference(result.samples, own ? result.exact_samples : one.samples);
  if (own)
    json["exact"] = {
        {"difference", to_base64(pack_pixels(difference_of(one.pixels->bytes(), exact->bytes())))},
        {"samples", sample_difference(result.exact_samples, one.samples)}};
}

// One side's fragments at listed disagreements.
Json fragments_json(const std::vector<Result::ReportedFragment>& fragments, const Result& result) {
  const std::size_t listed = std::min(result.disagreements.size(), kMaxDisagreementsPerAnswer);
  const std::vector<const Disagreement*> disagreements = worst_first(result);
  std::set<std::pair<int, int>> pixels;
  for (const Disagreement* d : std::span(disagreements).first(listed)) pixels.emplace(d->x, d->y);
  const auto is_beyond = [&](const Fragment& f) {
    return listed < result.disagreements.size() && !pixels.contains({f.x, f.y});
  };
  Json list = Json::array();
  for (const auto& [f, pass] : fragments) {
    if (is_beyond(f)) continue;
    Json json = {f.x, f.y, f.primitive, f.coverage, nullptr, nullptr};
    if (f.has_depth) json[4] = number(f.depth);
    if (f.has_color) json[5] = numbers({f.color.begin(), f.color.end()});
    if (pass >= 0) json.push_back(pass);
    list.push_back(std::move(json));
  }
  return list;
}

// A renderer's answer, without its name.
Json answer_json(const CaseResults& one, const Result& result) {
  Json json;
  json["fingerprint"] = result.fingerprint;
  add_images(json, one, result);
  Json list = Json::array();
  const std::size_t listed = std::min(result.disagreements.size(), kMaxDisagreementsPerAnswer);
  const std::vector<const Disagreement*> disagreements = worst_first(result);
  for (std::size_t i = 0; i < listed; ++i)
    list.push_back(disagreement_json(*disagreements[i], one.samples.samples));
  json["disagreements"] = std::move(list);
  if (listed < result.disagreements.size()) json["omitted"] = result.disagreements.size() - listed;
  if (!result.counted.empty()) {
    json["counted"] = describe_counted(result);
    json["total"] = count_disagreements(result);
  }
  Json values = Json::array();
  for (const ValueAggregate& v : result.values) values.push_back(values_json(v));
  json["values"] = std::move(values);
  Json evidence = Json::array();
  for (const Result::Evidence& e : result.evidence) {
    if (e.primitive == kAllValues) continue;
    Json causes = Json::array();
    for (const Cause& cause : e.causes) causes.push_back(text_of(cause));
    evidence.push_back({{"primitive", e.primitive},
                        {"causes", std::move(causes)},
                        {"illegal_line_snaps", e.illegal_line_snaps},
                        {"broken_clause", e.broken_clause}});
    if (e.pass >= 0) evidence.back()["pass"] = e.pass;
  }
  if (!result.exact_fragments.empty() || !result.rendered_fragments.empty())
    json["fragments"] = {{"exact", fragments_json(result.exact_fragments, result)},
                         {"rendered", fragments_json(result.rendered_fragments, result)}};
  json["evidence"] = std::move(evidence);
  json["illegal_line_snaps"] = result.illegal_line_snaps;
  if (!result.ramp.empty()) json["ramp"] = ramp_json(result);
  return json;
}

Json outcome_json(const Judgement& answer) {
  return {{"verdict", name_of(answer.verdict)}, {"fingerprint", answer.fingerprint}};
}

Json result_json(const Result& result, std::size_t answer) {
  Json json = {{"standing_reason", result.standing_reason}, {"answer", answer}};
  if (!result.faults.empty()) json["faults"] = result.faults;
  if (result.again) json["again"] = outcome_json(*result.again);
  if (!result.failure) json["pixel_counts"] = pixel_counts_json(result.pixel_counts);
  if (result.failure)
    json["failure"] = {{"kind", name_of(result.failure->kind)}, {"reason", result.failure->reason}};
  return json;
}

void add_results(Json& json, const CaseResults& one) {
  Json answers = Json::array();
  Json results = Json::array();
  for (const Result& result : one.results) {
    Json answer = answer_json(one, result);
    const auto found = std::find(answers.begin(), answers.end(), answer);
    const auto index = static_cast<std::size_t>(found - answers.begin());
    if (found == answers.end()) answers.push_back(std::move(answer));
    results.push_back(result_json(result, index));
  }
  json["answers"] = std::move(answers);
  json["results"] = std::move(results);
}

}  // namespace

nlohmann::ordered_json pixel_counts_json(const PixelCounts& counts) {
  Json json;
  for (const Verdict verdict : kDrawnVerdicts) json[name_of(verdict)] = counts[verdict];
  json["same"] = counts.same;
  return json;
}

nlohmann::ordered_json case_details(const CaseResults& one) {
  Json json = {{"pixels", to_base64(pack_pixels(one.pixels->bytes()))}};
  if (one.samples.samples > 1) json["samples"] = sample_data(one.samples);
  if (const auto& v = one.viewport) json["viewport"] = {v->x, v->y, v->width, v->height};
  json["figure"] = figure_json(one.figure);
  json["expect_failures"] = one.expect_failures;
  add_results(json, one);
  return json;
}

}  // namespace edgecase
