// SPDX-License-Identifier: MIT
#include "results/findings_json.h"

#include <utility>

#include "rules/all_rules.h"

namespace edgecase {
namespace {

void write_point(JsonWriter& json, const std::pair<double, double>& point) {
  json.array(point.first, point.second);
}

void write_told(JsonWriter& json, const Disagreement::Upright& told) {
  json.object([&] {
    json.member("rule", name_of(told.rule));
    json.member("ruling", told.ruling);
    json.member("legality", name_of(told.legality));
    json.member("cause", text_of(told.cause));
  });
}

}  // namespace

void write_mark(JsonWriter& json, const Mark& mark) {
  json.object([&] {
    json.member("role", name_of(mark.role));
    json.key("points").list(mark.points, write_point);
    if (mark.closed) json.member("closed", true);
    if (!mark.label.empty()) json.member("label", mark.label);
  });
}

void write_disagreement(JsonWriter& json, const Disagreement& d) {
  json.object([&] {
    json.key("pixel").array(d.x, d.y);
    json.member("sample", d.sample);
    json.member("primitive", d.primitive);
    json.member("kind", name_of(d.kind));
    json.member("rule", name_of(d.rule));
    json.member("legality", name_of(d.legality));
    json.member("cause", text_of(d.cause));
    if (!d.situation.empty()) json.member("situation", d.situation);
    if (d.policy_agrees) json.member("policy_agrees", true);
    json.member("ruling", d.ruling);
    if (d.upright) write_told(json.key("upright"), *d.upright);
    json.member("exact", d.exact);
    json.member("rendered", d.rendered);
    json.member("explanation", d.explanation);
    json.key("figure").list(d.figure.marks, write_mark);
  });
}

void write_evidence(JsonWriter& json, const Result::Evidence& evidence) {
  json.object([&] {
    json.member("primitive", evidence.primitive);
    json.key("causes").list(
        evidence.causes, [](JsonWriter& list, const Cause& cause) { list.value(text_of(cause)); });
    if (evidence.pass >= 0) json.member("pass", evidence.pass);
    if (!evidence.illegal_line_snaps.empty())
      json.member("illegal_line_snaps", evidence.illegal_line_snaps);
    if (!evidence.broken_clause.empty()) json.member("broken_clause", evidence.broken_clause);
  });
}

void write_fragment(JsonWriter& json, const Result::ReportedFragment& told) {
  const Fragment& f = told.fragment;
  json.list([&] {
    for (const int place : {f.x, f.y, f.primitive}) json.value(place);
    json.value(f.coverage);
    f.has_depth ? json.value(f.depth) : json.value(nullptr);
    f.has_color ? json.value(f.color) : json.value(nullptr);
    if (told.pass >= 0) json.value(told.pass);
  });
}

void write_level(JsonWriter& json, const Result::LevelPoint& p) {
  json.array(p.x, p.y, p.exact, p.low, p.high, p.rendered);
}

void write_place(JsonWriter& json, const ValueAggregate::Place& place) {
  json.array(place.x, place.y, place.primitive);
}

}  // namespace edgecase
