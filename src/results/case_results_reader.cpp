// SPDX-License-Identifier: MIT
#include "results/case_results_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "results/findings_json.h"
#include "results/packed_picture.h"
#include "results/packed_text.h"
#include "results/samples_json.h"
#include "results/shallow_json.h"
#include "rules/all_rules.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

using Picture = Shared<PackedWords>;

// What the line of a case may still be unpacked to: a few bytes of it may stand for very many.
struct Room {
  std::size_t places = kMostPlaces;
  std::size_t fragments = kMostFragments;
};

RuleId to_rule(const ReadJson& json) {
  RuleId rule = RuleId::none;
  const std::string id = json.get<std::string>();
  if (!parse_name(id, rule)) throw std::runtime_error(fmt::format("no rule is called \"{}\"", id));
  return rule;
}

Cause to_cause(const ReadJson& json) {
  const std::string text = json.get<std::string>();
  if (auto cause = parse_cause(text)) return *std::move(cause);
  throw std::runtime_error(fmt::format("\"{}\" names no alternative of the catalogue", text));
}

// A whole number as a member's name.
int to_integer(std::string_view text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end)
    throw std::runtime_error(fmt::format("\"{}\" is no whole number", text));
  return value;
}

template <class Item, class Convert>
std::vector<Item> to_list(const ReadJson& json, Convert convert) {
  if (!json.is_array()) throw std::runtime_error("a list is missing");
  std::vector<Item> result;
  result.reserve(json.size());
  for (const ReadJson& item : json) result.push_back(convert(item));
  return result;
}

std::vector<double> to_numbers(const ReadJson& json, const char* member) {
  if (!json.contains(member)) return {};
  return to_list<double>(json.at(member), to_number);
}

Disagreement::Upright to_upright(const ReadJson& json) {
  return {to_rule(json.at("rule")), json.at("ruling"), to_named<Legality>(json.at("legality")),
          to_cause(json.at("cause"))};
}

// A member that is absent leaves `value` as it is.
template <class Value, class Convert>
void read_member(const ReadJson& json, const char* member, Value& value, Convert convert) {
  if (json.contains(member)) value = convert(json.at(member));
}

// The same of a whole number, or of what the library converts.
template <class Value>
void read_member(const ReadJson& json, const char* member, Value& value) {
  if (!json.contains(member)) return;
  if constexpr (std::integral<Value> && !std::same_as<Value, bool>)
    value = WholeNumber(json.at(member));
  else
    value = json.at(member).get<Value>();
}

void read_class(const ReadJson& json, DisagreementClass& d) {
  read_member(json, "sample", d.sample);
  read_member(json, "primitive", d.primitive);
  d.kind = to_named<DisagreementKind>(json.at("kind"));
  d.rule = to_rule(json.at("rule"));
  d.legality = to_named<Legality>(json.at("legality"));
  read_member(json, "cause", d.cause, to_cause);
  read_member(json, "policy_agrees", d.policy_agrees);
  read_member(json, "ruling", d.ruling);
  read_member(json, "upright", d.upright, to_upright);
}

Disagreement to_disagreement(const ReadJson& json) {
  Disagreement d;
  read_class(json, d);
  d.x = WholeNumber(json.at("pixel").at(0));
  d.y = WholeNumber(json.at("pixel").at(1));
  read_member(json, "situation", d.situation);
  d.exact = to_numbers(json, "exact");
  d.rendered = to_numbers(json, "rendered");
  read_member(json, "explanation", d.explanation);
  read_member(json, "figure", d.figure, to_figure);
  return d;
}

// Of a case whose size is known.
std::vector<CountedDisagreements> to_counted(const ReadJson& json, const CaseResults& one) {
  return to_list<CountedDisagreements>(json, [&](const ReadJson& item) {
    CountedDisagreements counted;
    read_class(item, counted);
    counted.runs = to_runs(to_text(item.at("pixels")), one.width, one.height);
    if (counted.runs.empty() ||
        counted.count() != static_cast<std::size_t>(WholeNumber(item.at("count"))))
      throw std::runtime_error("the pixels of counted disagreements are not as many as it says");
    return counted;
  });
}

// A byte for each pixel is kept of a target with counted ones (diff/judge.h).
void check_places(const CaseResults& one, const Result& result) {
  const auto is_outside = [&](const auto& place) {
    return place.x < 0 || place.x >= one.width || place.y < 0 || place.y >= one.height;
  };
  if (result.disagreements.empty() || std::ranges::any_of(result.disagreements, is_outside))
    throw std::runtime_error("a disagreement lies outside the target");
  for (const ValueAggregate& values : result.values)
    if (std::ranges::any_of(values.differing, is_outside))
      throw std::runtime_error("a value lies outside the target");
}

ValueAggregate::Place to_place(const ReadJson& json) {
  return {WholeNumber(json.at(0)), WholeNumber(json.at(1)), WholeNumber(json.at(2))};
}

ValueAggregate to_values(const ReadJson& json, Room& room) {
  ValueAggregate values;
  values.attribute = json.at("attribute");
  values.rule = to_rule(json.at("rule"));
  read_member(json, "ruling", values.ruling);
  read_member(json, "cause", values.cause, to_cause);
  values.compared = WholeNumber(json.at("compared"));
  values.components = WholeNumber(json.at("components"));
  values.worst = to_place(json.at("worst"));
  values.worst_component = WholeNumber(json.at("worst_component"));
  values.worst_exact = to_number(json.at("worst_exact"));
  values.worst_rendered = to_number(json.at("worst_rendered"));
  read_member(json, "worst_permitted", values.worst_low,
              [](const ReadJson& range) { return to_number(range.at(0)); });
  read_member(json, "worst_permitted", values.worst_high,
              [](const ReadJson& range) { return to_number(range.at(1)); });
  values.worst_ulp = to_number(json.at("worst_ulp"));
  values.mean_ulp = to_number(json.at("mean_ulp"));
  values.worst_relative = to_number(json.at("worst_relative"));
  for (const auto& [bucket, count] : json.at("ulp_histogram").items())
    values.ulp_histogram[to_integer(bucket)] = WholeNumber(count);
  values.differing = to_places(to_text(json.at("differing")), room.places);
  room.places -= values.differing.size();
  return values;
}

Result::Evidence to_evidence(const ReadJson& json) {
  Result::Evidence evidence;
  evidence.primitive = WholeNumber(json.at("primitive"));
  read_member(json, "pass", evidence.pass);
  read_member(json, "causes", evidence.causes,
              [](const ReadJson& causes) { return to_list<Cause>(causes, to_cause); });
  read_member(json, "illegal_line_snaps", evidence.illegal_line_snaps);
  read_member(json, "broken_clause", evidence.broken_clause);
  return evidence;
}

Result::LevelPoint to_level(const ReadJson& json) {
  return {WholeNumber(json.at(0)), WholeNumber(json.at(1)), to_number(json.at(2)),
          to_number(json.at(3)),   to_number(json.at(4)),   to_number(json.at(5))};
}

Result::Shown to_shown(const ReadJson& json) {
  SingleThing thing{to_named<SingleThing::Kind>(json.at(0)), WholeNumber(json.at(1)),
                    WholeNumber(json.at(2))};
  if (thing.kind == SingleThing::Kind::alpha) {
    thing.x = WholeNumber(json.at(5));
    thing.y = WholeNumber(json.at(6));
  }
  if (thing.kind != SingleThing::Kind::sample_cells)
    return {thing, to_number(json.at(3)), to_number(json.at(4))};
  if (const auto cells = PlaceCells::parse(json.at(3).get<std::string>()))
    return {thing, 0, 0, *cells};
  throw std::runtime_error("the cells of a sample's places have other digits");
}

PixelCounts to_pixel_counts(const ReadJson& json) {
  PixelCounts counts;
  for (const Verdict verdict : kDrawnVerdicts)
    counts[verdict] = WholeNumber(json.at(name_of(verdict)));
  counts.same = WholeNumber(json.at("same"));
  return counts;
}

std::uint64_t to_digest(const ReadJson& json) {
  const std::string_view text = to_text(json);
  std::uint64_t digest = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, digest, 16);
  if (read.ec != std::errc{} || read.ptr != end)
    throw std::runtime_error(fmt::format("\"{}\" is no digest", text));
  return digest;
}

Judgement to_answer(const ReadJson& json) {
  return {to_named<Verdict>(json.at("verdict")), json.at("fingerprint")};
}

Viewport to_viewport(const ReadJson& json) {
  return {WholeNumber(json.at(0)), WholeNumber(json.at(1)), WholeNumber(json.at(2)),
          WholeNumber(json.at(3))};
}

// A picture from its difference to another one. The empty text is no picture.
Picture to_difference(const ReadJson& json, const CaseResults& one, const Picture& from) {
  const std::string_view text = to_text(json);
  if (text.empty()) return {};
  const auto size = static_cast<std::size_t>(one.width) * static_cast<std::size_t>(one.height);
  return to_difference(text, size, *from, WordsAre::pixels);
}

// A failure has no picture; any other result has exact's picture unless a member says otherwise.
void read_pictures(const ReadJson& json, const CaseResults& one, Result& result) {
  const auto to_own_samples = [&](const char* member, const SampleImage& from) {
    return json.contains(member) ? to_samples(json.at(member), one.width, one.height, from)
                                 : SampleImage();
  };
  const bool own = json.contains("exact_pixels");
  if (own) result.exact_pixels = to_difference(json.at("exact_pixels"), one, one.pixels);
  result.exact_samples = to_own_samples("exact_samples", one.samples);
  result.samples = to_own_samples("samples", own ? result.exact_samples : one.samples);
  if (result.failure) return;
  result.pixels = own ? result.exact_pixels : one.pixels;
  if (json.contains("pixels")) result.pixels = to_difference(json.at("pixels"), one, result.pixels);
}

NumberRun to_number_run(const ReadJson& json) {
  const int first = WholeNumber(json.at(0));
  const int last = WholeNumber(json.at(1));
  if (first < 0 || last < first || last > std::numeric_limits<std::uint16_t>::max())
    throw std::runtime_error(fmt::format("{} to {} is no run of numbers", first, last));
  return {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(last)};
}

ImageCounts to_images(const ReadJson& json) {
  return {WholeNumber(json.at(0)), WholeNumber(json.at(1))};
}

Failure to_failure(const ReadJson& json) {
  return {to_named<FailureKind>(json.at("kind")), json.at("reason")};
}

void read_judgement(const ReadJson& json, const CaseResults& one, Result& result) {
  result.verdict = to_named<Verdict>(json.at("verdict"));
  read_member(json, "fingerprint", result.fingerprint);
  read_member(json, "answer_digest", result.answer_digest, to_digest);
  read_member(json, "images", result.images, to_images);
  read_member(json, "standing", result.standing, to_named<Standing>);
  read_member(json, "standing_reason", result.standing_reason);
  read_member(json, "faults", result.faults);
  read_member(json, "hypotheses", result.hypotheses,
              [](const ReadJson& list) { return to_list<NumberRun>(list, to_number_run); });
  read_member(json, "again", result.again, to_answer);
  read_member(json, "failure", result.failure, to_failure);
  if (!result.failure) result.pixel_counts = counts_of_agreement(one.width, one.height);
  read_member(json, "pixel_counts", result.pixel_counts, to_pixel_counts);
}

void read_findings(const ReadJson& json, const CaseResults& one, Room& room, Result& result) {
  read_member(json, "disagreements", result.disagreements,
              [](const ReadJson& list) { return to_list<Disagreement>(list, to_disagreement); });
  read_member(json, "counted", result.counted,
              [&](const ReadJson& list) { return to_counted(list, one); });
  const auto to_own_values = [&](const ReadJson& item) { return to_values(item, room); };
  read_member(json, "values", result.values,
              [&](const ReadJson& list) { return to_list<ValueAggregate>(list, to_own_values); });
  read_member(json, "evidence", result.evidence,
              [](const ReadJson& list) { return to_list<Result::Evidence>(list, to_evidence); });
  read_member(json, "illegal_line_snaps", result.illegal_line_snaps);
  read_member(json, "refuted", result.refuted, to_refuted);
  for (auto [member, list] : {std::pair("exact_fragments", &result.exact_fragments),
                              std::pair("rendered_fragments", &result.rendered_fragments)}) {
    if (json.contains(member)) *list = to_fragments(json.at(member), room.fragments);
    room.fragments -= list->size();
  }
  read_member(json, "shown", result.shown,
              [](const ReadJson& list) { return to_list<Result::Shown>(list, to_shown); });
  read_member(json, "ramp", result.ramp,
              [](const ReadJson& list) { return to_list<Result::LevelPoint>(list, to_level); });
}

Result to_result(const ReadJson& json, const CaseResults& one, Room& room) {
  Result result;
  read_judgement(json, one, result);
  read_findings(json, one, room, result);
  if (!result.counted.empty()) check_places(one, result);
  read_pictures(json, one, result);
  return result;
}

}  // namespace

AlternativeSet to_refuted(const ReadJson& json) {
  if (const auto refuted = parse_refuted(json.get<std::string>())) return *refuted;
  throw std::runtime_error("what is refuted does not fit the catalogue");
}

CaseResults to_head(const ReadJson& json) {
  CaseResults head;
  head.file = json.at("file");
  head.file_digest = json.at("file_digest");
  read_member(json, "title", head.title);
  read_member(json, "why", head.why);
  read_member(json, "rules", head.rules);
  read_member(json, "spec", head.spec);
  read_member(json, "origin", head.origin);
  read_member(json, "tags", head.tags);
  head.surface = json.at("surface");
  head.width = WholeNumber(json.at("width"));
  head.height = WholeNumber(json.at("height"));
  constexpr int kMost = 4096;  // pixels: of the largest target
  if (head.width < 0 || head.height < 0 || head.width > kMost || head.height > kMost)
    throw std::runtime_error(
        fmt::format("there is no target of {} by {} pixels", head.width, head.height));
  read_member(json, "viewport", head.viewport, to_viewport);
  return head;
}

void HeadsRead::keep_last_file() {
  if (list.empty()) return;
  const std::string& last = list.back()->file;
  const auto kept = std::ranges::find(list, last, [](const auto& head) { return head->file; });
  first += static_cast<std::size_t>(kept - list.begin());
  list.erase(list.begin(), kept);
}

CaseResults to_case(const ReadJson& json, const HeadsRead& heads,
                    const std::vector<RendererInfo>& renderers) {
  const std::size_t head = WholeNumber(json.at("head"));
  if (head < heads.first || head - heads.first >= heads.list.size())
    throw std::runtime_error(fmt::format("there is no head {} of this file", head));
  CaseResults one = *heads.list[head - heads.first];
  one.id = json.at("case");
  one.fragments = WholeNumber(json.at("fragments"));
  read_member(json, "expect_failures", one.expect_failures);
  read_member(json, "pixels", one.pixels, [&](const ReadJson& pixels) {
    return to_picture(to_text(pixels), one.width, one.height);
  });
  read_member(json, "samples", one.samples,
              [&](const ReadJson& samples) { return to_samples(samples, one.width, one.height); });
  read_member(json, "figure", one.figure, to_figure);
  Room room;
  for (const RendererInfo& info : renderers)
    one.results.push_back(to_result(json.at("results").at(info.name), one, room));
  return one;
}

}  // namespace edgecase
