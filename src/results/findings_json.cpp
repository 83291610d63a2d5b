// SPDX-License-Identifier: MIT
#include "results/findings_json.h"

#include <string>

#include "results/figure_json.h"
#include "results/packed_text.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

void write_told(JsonWriter& json, const Disagreement::Upright& told) {
  json.object([&] {
    json.member("rule", name_of(told.rule));
    json.member("ruling", told.ruling);
    json.member("legality", name_of(told.legality));
    json.member("cause", text_of(told.cause));
  });
}

}  // namespace

// Members that say nothing are left out: a file holds very many of these.
void write_disagreement(JsonWriter& json, const Disagreement& d) {
  json.object([&] {
    json.key("pixel").array(d.x, d.y);
    if (d.sample != 0) json.member("sample", d.sample);
    if (d.primitive != -1) json.member("primitive", d.primitive);
    json.member("kind", name_of(d.kind));
    json.member("rule", name_of(d.rule));
    json.member("legality", name_of(d.legality));
    if (!d.cause.empty()) json.member("cause", text_of(d.cause));
    if (!d.situation.empty()) json.member("situation", d.situation);
    if (d.policy_agrees) json.member("policy_agrees", true);
    if (d.ruling != 0) json.member("ruling", d.ruling);
    if (d.upright) write_told(json.key("upright"), *d.upright);
    if (!d.exact.empty()) json.member("exact", d.exact);
    if (!d.rendered.empty()) json.member("rendered", d.rendered);
    if (!d.explanation.empty()) json.member("explanation", d.explanation);
    if (!d.figure.marks.empty()) write_figure(json.key("figure"), d.figure);
  });
}

void write_evidence(JsonWriter& json, const Result::Evidence& evidence) {
  json.object([&] {
    json.member("primitive", evidence.primitive);
    if (!evidence.causes.empty())
      json.key("causes").list(evidence.causes, [](JsonWriter& list, const Cause& cause) {
        list.value(text_of(cause));
      });
    if (evidence.pass >= 0) json.member("pass", evidence.pass);
    if (!evidence.illegal_line_snaps.empty())
      json.member("illegal_line_snaps", evidence.illegal_line_snaps);
    if (!evidence.broken_clause.empty()) json.member("broken_clause", evidence.broken_clause);
  });
}

void write_level(JsonWriter& json, const Result::LevelPoint& p) {
  json.array(p.x, p.y, p.exact, p.low, p.high, p.rendered);
}

void write_values(JsonWriter& json, const ValueAggregate& values) {
  json.object([&] {
    json.member("attribute", values.attribute);
    json.member("rule", name_of(values.rule));
    if (values.ruling != 0) json.member("ruling", values.ruling);
    if (!values.cause.empty()) json.member("cause", text_of(values.cause));
    json.member("compared", values.compared);
    json.member("components", values.components);
    json.key("worst").array(values.worst.x, values.worst.y, values.worst.primitive);
    json.member("worst_component", values.worst_component);
    json.member("worst_exact", values.worst_exact);
    json.member("worst_rendered", values.worst_rendered);
    json.member("worst_ulp", values.worst_ulp);
    json.member("mean_ulp", values.mean_ulp);
    json.member("worst_relative", values.worst_relative);
    json.key("ulp_histogram").object([&] {
      for (const auto& [bucket, count] : values.ulp_histogram)
        json.member(std::to_string(bucket), count);
    });
    json.member("differing", packed_places(values.differing));
  });
}

}  // namespace edgecase
