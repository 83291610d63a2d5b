// SPDX-License-Identifier: MIT
#include "results/case_results_json.h"

#include <fmt/format.h>

#include <algorithm>

#include "results/findings_json.h"
#include "results/packed_picture.h"
#include "results/packed_text.h"
#include "results/samples_json.h"
#include "rules/all_rules.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

using Picture = Shared<PackedWords>;

void write_answer(JsonWriter& json, const Judgement& answer) {
  json.object([&] {
    json.member("verdict", name_of(answer.verdict));
    json.member("fingerprint", answer.fingerprint);
  });
}

void write_failure(JsonWriter& json, const Failure& failure) {
  json.object([&] {
    json.member("kind", name_of(failure.kind));
    json.member("reason", failure.reason);
  });
}

void write_pixel_counts(JsonWriter& json, const PixelCounts& counts) {
  json.object([&] {
    for (const Verdict verdict : kDrawnVerdicts) json.member(name_of(verdict), counts[verdict]);
    json.member("same", counts.same);
  });
}

void write_shown(JsonWriter& json, const Result::Shown& shown) {
  const SingleThing& thing = shown.thing;
  if (thing.kind == SingleThing::Kind::sample_cells)
    json.array(name_of(thing.kind), thing.of, thing.sample, shown.cells->text());
  else if (thing.kind == SingleThing::Kind::alpha)
    json.array(name_of(thing.kind), thing.of, thing.sample, shown.low, shown.high, thing.x,
               thing.y);
  else
    json.array(name_of(thing.kind), thing.of, thing.sample, shown.low, shown.high);
}

// A member is left out where it says nothing.
class CaseWriter {
 public:
  CaseWriter(const CaseResults& one, std::string& text)
      : one_(one), is_shown_(has_details(outline_of(one))), json_(text) {}

  void write_case(std::size_t head, const std::vector<RendererInfo>& renderers) {
    json_.object([&] {
      json_.member("case", one_.id);
      json_.member("head", head);
      json_.member("fragments", one_.fragments);
      if (!one_.expect_failures.empty()) json_.member("expect_failures", one_.expect_failures);
      if (is_shown_) write_exact();
      json_.key("results").object([&] {
        for (std::size_t i = 0; i < one_.results.size(); ++i) {
          json_.key(renderers[i].name);
          write_result(one_.results[i]);
        }
      });
    });
  }

 private:
  void write_exact();
  void write_result(const Result& result);
  void write_judgement(const Result& result);
  void write_findings(const Result& result);
  void write_pictures(const Result& result);
  void write_picture(const char* name, const Picture& picture, const Picture& from);

  template <class Range, class Write>
  void list_unless_empty(const char* name, const Range& items, Write write) {
    if (!items.empty()) json_.key(name).list(items, write);
  }

  const CaseResults& one_;
  const bool is_shown_;
  JsonWriter json_;
};

void CaseWriter::write_exact() {
  if (!one_.pixels->empty())
    json_.member("pixels", packed_picture(one_.pixels->bytes(), one_.width));
  if (one_.samples.samples > 1) write_samples(json_.key("samples"), one_.samples, one_.width);
  if (!one_.figure.marks.empty()) write_figure(json_.key("figure"), one_.figure);
}

void CaseWriter::write_result(const Result& result) {
  json_.object([&] {
    write_judgement(result);
    write_findings(result);
    if (is_shown_) write_pictures(result);
  });
}

void CaseWriter::write_judgement(const Result& result) {
  json_.member("verdict", name_of(result.verdict));
  if (!result.fingerprint.empty()) json_.member("fingerprint", result.fingerprint);
  if (result.answer_digest != 0)
    json_.member("answer_digest", fmt::format("{:016x}", result.answer_digest));
  if (result.images != ImageCounts{})
    json_.key("images").array(result.images.drawn, result.images.refused);
  if (result.standing != Standing::expected) json_.member("standing", name_of(result.standing));
  if (!result.standing_reason.empty()) json_.member("standing_reason", result.standing_reason);
  if (!result.faults.empty()) json_.member("faults", result.faults);
  list_unless_empty("hypotheses", result.hypotheses, [](JsonWriter& list, NumberRun run) {
    list.array(int{run.first}, int{run.last});
  });
  if (result.again) write_answer(json_.key("again"), *result.again);
  if (result.failure)
    write_failure(json_.key("failure"), *result.failure);
  else if (result.pixel_counts != counts_of_agreement(one_.width, one_.height))
    write_pixel_counts(json_.key("pixel_counts"), result.pixel_counts);
}

void CaseWriter::write_findings(const Result& result) {
  list_unless_empty("disagreements", result.disagreements, write_disagreement);
  list_unless_empty("counted", result.counted, write_counted);
  list_unless_empty("values", result.values, write_values);
  list_unless_empty("evidence", result.evidence, write_evidence);
  if (!result.illegal_line_snaps.empty())
    json_.member("illegal_line_snaps", result.illegal_line_snaps);
  if (const std::string refuted = text_of_refuted(result.refuted); !refuted.empty())
    json_.member("refuted", refuted);
  if (!result.exact_fragments.empty())
    write_fragments(json_.key("exact_fragments"), result.exact_fragments);
  if (!result.rendered_fragments.empty())
    write_fragments(json_.key("rendered_fragments"), result.rendered_fragments);
  list_unless_empty("shown", result.shown, write_shown);
  list_unless_empty("ramp", result.ramp, write_level);
}

void CaseWriter::write_pictures(const Result& result) {
  const bool own = !result.exact_pixels->empty();
  if (own) {
    write_picture("exact_pixels", result.exact_pixels, one_.pixels);
    if (result.exact_samples.samples > 1)
      write_samples(json_.key("exact_samples"), result.exact_samples, one_.samples);
  }
  const Picture& exact = own ? result.exact_pixels : one_.pixels;
  if (!result.failure && result.pixels != exact) write_picture("pixels", result.pixels, exact);
  if (result.samples.samples > 1)
    write_samples(json_.key("samples"), result.samples, own ? result.exact_samples : one_.samples);
}

void CaseWriter::write_picture(const char* name, const Picture& picture, const Picture& from) {
  json_.member(name,
               packed_words(difference_of(words_of(picture->bytes()), words_of(from->bytes()))));
}

}  // namespace

void append_head(const CaseResults& one, std::size_t number, std::string& text) {
  JsonWriter json(text);
  const auto add = [&](const char* name, const std::string& words) {
    if (!words.empty()) json.member(name, words);
  };
  json.object([&] {
    json.member("head", number);
    json.member("file", one.file);
    json.member("file_digest", one.file_digest);
    add("title", one.title);
    add("why", one.why);
    json.member("rules", one.rules);
    add("spec", one.spec);
    add("origin", one.origin);
    json.member("tags", one.tags);
    json.member("surface", one.surface);
    json.member("width", one.width);
    json.member("height", one.height);
    if (const auto& v = one.viewport) json.key("viewport").array(v->x, v->y, v->width, v->height);
  });
}

void append_case(const CaseResults& one, std::size_t head,
                 const std::vector<RendererInfo>& renderers, std::string& text) {
  CaseWriter(one, text).write_case(head, renderers);
}

PixelCounts counts_of_agreement(int width, int height) {
  PixelCounts counts;
  counts[Verdict::agree] = counts.same =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return counts;
}

}  // namespace edgecase
