// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "results/folding.h"
#include "results/hex.h"
#include "results/picture_difference.h"
#include "results/results_json.h"
#include "results/samples_json.h"
#include "results/shallow_json.h"
#include "results/whole_number.h"
#include "rules/all_rules.h"
#include "rules/changes.h"

namespace edgecase {
namespace {

using Json = nlohmann::json;

// RGBA8 of a picture of the given size.
std::vector<std::uint8_t> to_pixels(const Json& json, int width, int height) {
  std::vector<std::uint8_t> pixels = from_hex(unfolded(json).get<std::string>());
  if (width < 0 || height < 0 ||
      pixels.size() != 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw std::runtime_error(fmt::format("{} bytes of pixels do not make a picture of {} by {}",
                                         pixels.size(), width, height));
  return pixels;
}

double to_number(const Json& json) {
  if (json.is_number()) return json.get<double>();
  const std::string text = json.get<std::string>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  throw std::runtime_error(fmt::format("\"{}\" is no number", text));
}

// The value whose name_of is the given text, among those from `first` to `last`.
template <class Enum>
Enum to_enum(const Json& json, Enum first, Enum last) {
  const std::string text = json.get<std::string>();
  for (int i = static_cast<int>(first); i <= static_cast<int>(last); ++i)
    if (text == name_of(static_cast<Enum>(i))) return static_cast<Enum>(i);
  throw std::runtime_error(fmt::format("\"{}\" is not known here", text));
}

RuleId to_rule(const Json& json) {
  RuleId rule = RuleId::none;
  const std::string id = json.get<std::string>();
  if (!parse_name(id, rule)) throw std::runtime_error(fmt::format("no rule is called \"{}\"", id));
  return rule;
}

Cause to_cause(const Json& json) {
  const std::string text = json.get<std::string>();
  if (auto cause = parse_cause(text)) return *std::move(cause);
  throw std::runtime_error(fmt::format("\"{}\" names no alternative of the catalogue", text));
}

AlternativeSet to_refuted(const Json& json) {
  if (const auto refuted = parse_refuted(json.get<std::string>())) return *refuted;
  throw std::runtime_error("what is refuted does not fit the catalogue");
}

// A whole number as a member's name.
int to_integer(const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end)
    throw std::runtime_error(fmt::format("\"{}\" is no whole number", text));
  return value;
}

template <class Item, class Convert>
std::vector<Item> to_list(const Json& json, Convert convert) {
  if (!json.is_array()) throw std::runtime_error("a list is missing");
  std::vector<Item> result;
  for (const Json& item : json) result.push_back(convert(item));
  return result;
}

Figure to_figure(const Json& json) {
  Figure figure;
  for (const Json& item : json) {
    Mark mark;
    mark.role = to_enum(item.at("role"), MarkRole::primitive, MarkRole::edge);
    mark.closed = item.value("closed", false);
    mark.label = item.value("label", "");
    for (const Json& point : item.at("points"))
      mark.points.emplace_back(to_number(point.at(0)), to_number(point.at(1)));
    figure.marks.push_back(std::move(mark));
  }
  return figure;
}

Disagreement to_disagreement(const Json& json) {
  Disagreement d;
  d.x = WholeNumber(json.at("pixel").at(0));
  d.y = WholeNumber(json.at("pixel").at(1));
  d.sample = WholeNumber(json.at("sample"));
  d.primitive = WholeNumber(json.at("primitive"));
  d.kind = to_enum(json.at("kind"), DisagreementKind::missing, DisagreementKind::value);
  d.rule = to_rule(json.at("rule"));
  d.legality = to_enum(json.at("legality"), Legality::legal, Legality::illegal);
  d.cause = to_cause(json.at("cause"));
  d.situation = json.value("situation", "");
  d.policy_agrees = json.value("policy_agrees", false);
  d.ruling = json.at("ruling");
  if (json.contains("upright")) {
    const Json& upright = json.at("upright");
    d.upright =
        Disagreement::Upright{to_rule(upright.at("rule")), upright.at("ruling"),
                              to_enum(upright.at("legality"), Legality::legal, Legality::illegal),
                              to_cause(upright.at("cause"))};
  }
  d.exact = to_list<double>(json.at("exact"), to_number);
  d.rendered = to_list<double>(json.at("rendered"), to_number);
  d.explanation = json.at("explanation");
  d.figure = to_figure(json.at("figure"));
  return d;
}

ValueAggregate::Place to_place(const Json& json) {
  return {WholeNumber(json.at(0)), WholeNumber(json.at(1)), WholeNumber(json.at(2))};
}

ValueAggregate to_values(const Json& json) {
  ValueAggregate values;
  values.attribute = json.at("attribute");
  values.rule = to_rule(json.at("rule"));
  values.ruling = json.at("ruling");
  if (json.contains("cause")) values.cause = to_cause(json.at("cause"));
  values.compared = WholeNumber(json.at("compared"));
  values.components = WholeNumber(json.at("components"));
  values.worst = to_place(json.at("worst"));
  values.worst_component = WholeNumber(json.at("worst_component"));
  values.worst_exact = to_number(json.at("worst_exact"));
  values.worst_rendered = to_number(json.at("worst_rendered"));
  values.worst_ulp = to_number(json.at("worst_ulp"));
  values.mean_ulp = to_number(json.at("mean_ulp"));
  values.worst_relative = to_number(json.at("worst_relative"));
  for (const auto& [bucket, count] : json.at("ulp_histogram").items())
    values.ulp_histogram[to_integer(bucket)] = WholeNumber(count);
  values.differing = to_places(unfolded(json.at("differing")));
  return values;
}

Result::Evidence to_evidence(const Json& json) {
  Result::Evidence evidence;
  evidence.primitive = WholeNumber(json.at("primitive"));
  if (json.contains("pass")) evidence.pass = WholeNumber(json.at("pass"));
  evidence.causes = to_list<Cause>(json.at("causes"), to_cause);
  evidence.illegal_line_snaps = json.value("illegal_line_snaps", std::vector<std::string>{});
  evidence.broken_clause = json.value("broken_clause", "");
  return evidence;
}

Result::ReportedFragment to_fragment(const Json& json) {
  Result::ReportedFragment told;
  Fragment& f = told.fragment;
  f.x = WholeNumber(json.at(0));
  f.y = WholeNumber(json.at(1));
  f.primitive = WholeNumber(json.at(2));
  f.coverage = WholeNumber(json.at(3));
  f.has_depth = !json.at(4).is_null();
  f.has_color = !json.at(5).is_null();
  if (f.has_depth) f.depth = to_number(json.at(4));
  for (std::size_t i = 0; f.has_color && i < f.color.size(); ++i)
    f.color[i] = to_number(json.at(5).at(i));
  if (json.size() > 6) told.pass = WholeNumber(json.at(6));
  return told;
}

// What the renderer drew: stored, as the difference from exact's picture, or the same as that.
Shared<PackedWords> to_picture(const Json& json, const CaseResults& exact) {
  if (json.contains("difference"))
    return difference_of(to_pixels(json.at("difference"), exact.width, exact.height),
                         exact.pixels->bytes());
  const Json& pixels = json.at("pixels");
  if (pixels == "exact") return exact.pixels;
  return to_pixels(pixels, exact.width, exact.height);
}

// Of one side; none where there is no such member.
std::vector<Result::ReportedFragment> to_fragments(const Json& json, const char* member) {
  if (!json.contains(member)) return {};
  return to_list<Result::ReportedFragment>(unfolded(json.at(member)), to_fragment);
}

Result::LevelPoint to_level(const Json& json) {
  return {WholeNumber(json.at(0)), WholeNumber(json.at(1)), to_number(json.at(2)),
          to_number(json.at(3)),   to_number(json.at(4)),   to_number(json.at(5))};
}

PixelCounts to_pixel_counts(const Json& json) {
  return {WholeNumber(json.at("agree")),     WholeNumber(json.at("convention")),
          WholeNumber(json.at("permitted")), WholeNumber(json.at("contested")),
          WholeNumber(json.at("violation")), WholeNumber(json.at("same"))};
}

Judgement to_answer(const Json& json) {
  return {to_enum(json.at("verdict"), Verdict::agree, Verdict::not_run), json.at("fingerprint")};
}

FaultSeen to_fault(const Json& json) {
  FaultSeen seen{json.at("renderer"),
                 json.at("id"),
                 json.at("reason"),
                 json.at("link"),
                 json.at("cases"),
                 std::nullopt,
                 to_enum(json.at("state"), FaultState::known, FaultState::uncounted)};
  if (json.contains("before")) seen.before = json.at("before").get<std::size_t>();
  return seen;
}

KnownResult to_result(const Json& json, const CaseResults& exact) {
  KnownResult result;
  result.verdict = to_enum(json.at("verdict"), Verdict::agree, Verdict::not_run);
  result.fingerprint = json.at("fingerprint");
  result.standing = to_enum(json.at("standing"), Standing::expected, Standing::flake);
  result.standing_reason = json.value("standing_reason", "");
  if (json.contains("faults")) result.faults = json.at("faults").get<std::vector<std::string>>();
  if (json.contains("again")) result.again = to_answer(json.at("again"));
  if (json.contains("failure")) {
    const Json& failure = json.at("failure");
    result.failure =
        Failure{to_enum(failure.at("kind"), FailureKind::unsupported, FailureKind::unavailable),
                failure.at("reason")};
  }
  // Who failed has drawn nothing; of all others a picture must be there, and what is said of it.
  if (!result.failure) {
    result.pixel_counts = to_pixel_counts(json.at("pixel_counts"));
    result.pixels = to_picture(json, exact);
  }
  result.disagreements = to_list<Disagreement>(unfolded(json.at("disagreements")), to_disagreement);
  result.values = to_list<ValueAggregate>(json.at("values"), to_values);
  result.evidence = to_list<Result::Evidence>(unfolded(json.at("evidence")), to_evidence);
  result.illegal_line_snaps = json.at("illegal_line_snaps").get<std::vector<std::string>>();
  result.refuted = to_refuted(json.at("refuted"));
  result.exact_fragments = to_fragments(json, "exact_fragments");
  result.rendered_fragments = to_fragments(json, "rendered_fragments");
  if (json.contains("ramp")) result.ramp = to_list<Result::LevelPoint>(json.at("ramp"), to_level);
  if (json.contains("exact_pixels"))
    result.exact_pixels = to_pixels(json.at("exact_pixels"), exact.width, exact.height);
  if (json.contains("samples"))
    result.samples = to_samples(unfolded(json.at("samples")), exact.width, exact.height);
  if (json.contains("exact_samples"))
    result.exact_samples =
        to_samples(unfolded(json.at("exact_samples")), exact.width, exact.height);
  return result;
}

Viewport to_viewport(const Json& json) {
  return {WholeNumber(json.at(0)), WholeNumber(json.at(1)), WholeNumber(json.at(2)),
          WholeNumber(json.at(3))};
}

CaseResults to_case(const Json& json, const std::vector<RendererInfo>& renderers) {
  CaseResults one;
  one.id = json.at("id");
  one.title = json.at("title");
  one.why = json.at("why");
  one.rules = json.at("rules").get<std::vector<std::string>>();
  one.spec = json.at("spec");
  one.origin = json.at("origin");
  one.tags = json.at("tags").get<std::vector<std::string>>();
  one.file = json.at("file");
  one.file_digest = json.at("file_digest");
  one.surface = json.at("surface");
  one.width = WholeNumber(json.at("width"));
  one.height = WholeNumber(json.at("height"));
  if (json.contains("viewport")) one.viewport = to_viewport(json.at("viewport"));
  one.fragments = WholeNumber(json.at("fragments"));
  one.pixels = to_pixels(json.at("pixels"), one.width, one.height);
  if (json.contains("samples"))
    one.samples = to_samples(unfolded(json.at("samples")), one.width, one.height);
  one.figure = to_figure(unfolded(json.at("figure")));
  one.expect_failures = json.at("expect_failures").get<std::vector<std::string>>();
  for (const RendererInfo& info : renderers)
    one.results.push_back(to_result(json.at("results").at(info.name), one));
  return one;
}

RendererInfo to_renderer(const Json& json) {
  RendererInfo info;
  info.name = json.at("name");
  info.vendor = json.at("vendor");
  info.version = json.at("version");
  info.device = json.at("device");
  info.subpixel_bits = WholeNumber(json.at("subpixel_bits"));
  info.traits = json.at("traits").get<std::map<std::string, std::string>>();
  return info;
}

ShareOfRun to_shard(const Json& json) {
  const int number = WholeNumber(json.at("index"));
  const int count = WholeNumber(json.at("count"));
  if (number < 1 || number > count)
    throw std::runtime_error(fmt::format("there is no share {} of {}", number, count));
  return {number - 1, count, WholeNumber(json.at("cases")), json.at("selection")};
}

Diagnostic to_diagnostic(const Json& json) {
  return {json.at("file"), WholeNumber(json.at("line")), json.at("pointer"), json.at("message"),
          json.at("remedy")};
}

}  // namespace

std::variant<Results, std::string> read_results(const std::string& text) {
  std::string where;
  try {
    const Json json = parse_shallow(text);
    Results results;
    results.tool = json.at("tool");
    results.policy = json.at("policy");
    results.latitude = to_enum(json.at("latitude"), Latitude::opengl, Latitude::none);
    results.policy_digest = json.at("policy_digest");
    results.interrupted = json.at("interrupted");
    if (json.contains("left_out")) results.left_out = WholeNumber(json.at("left_out"));
    results.whole_suite = json.at("whole_suite");
    if (json.contains("shard")) results.shard = to_shard(json.at("shard"));
    results.renderers = to_list<RendererInfo>(json.at("renderers"), to_renderer);
    results.diagnostics = to_list<Diagnostic>(json.at("diagnostics"), to_diagnostic);
    results.faults = to_list<FaultSeen>(json.at("faults"), to_fault);
    results.cases = to_list<CaseResults>(json.at("cases"), [&](const Json& one) {
      where = fmt::format("case {}: ", one.at("id").get<std::string>());
      return to_case(one, results.renderers);
    });
    return results;
  } catch (const std::exception& error) {
    return fmt::format("this is no results file of `edgecase run`: {}{}", where, fault_of(error));
  }
}

}  // namespace edgecase
