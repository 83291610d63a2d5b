// SPDX-License-Identifier: MIT
#include "results/case_results_writer.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "results/findings_json.h"
#include "results/folding.h"
#include "results/json_writer.h"
#include "results/picture_difference.h"
#include "results/samples_json.h"
#include "rules/all_rules.h"
#include "rules/changes.h"

namespace edgecase {
namespace {

using Pixels = std::vector<std::uint8_t>;

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
    json.member("agree", counts.agree);
    json.member("convention", counts.convention);
    json.member("permitted", counts.permitted);
    json.member("contested", counts.contested);
    json.member("violation", counts.violation);
    json.member("same", counts.same);
  });
}

// Writes a case. What is long is folded where the case is large.
class CaseWriter {
 public:
  CaseWriter(const CaseResults& one, std::string& text)
      : one_(one), is_large_(one.pixels->size() > kMostPixels), text_(text), json_(text) {}

  void write_case(const std::vector<RendererInfo>& renderers) {
    json_.object([&] {
      write_origin();
      write_exact();
      json_.key("results").object([&] {
        for (std::size_t i = 0; i < one_.results.size(); ++i) {
          json_.key(renderers[i].name);
          write_result(one_.results[i]);
        }
      });
    });
  }

 private:
  void write_origin();
  void write_exact();
  void write_result(const KnownResult& result);
  void write_judgement(const KnownResult& result);
  void write_findings(const KnownResult& result);
  void write_pictures(const KnownResult& result);
  void write_values(const ValueAggregate& values);
  void write_worst(const ValueAggregate& values);
  void write_picture(const Shared<PackedWords>& rendered);

  // A member that is folded where it is long.
  template <class Write>
  void keep(std::string_view name, Write write) {
    json_.key(name);
    const std::size_t first = text_.size();
    write();
    if (is_large_) fold(text_, first);
  }
  template <class Range, class Write>
  void keep_list(std::string_view name, const Range& items, Write write) {
    keep(name, [&] { json_.list(items, write); });
  }
  void keep_pixels(std::string_view name, const Pixels& pixels) {
    keep(name, [&] { json_.hex(pixels); });
  }
  void keep_samples(std::string_view name, const SampleImage& image) {
    if (image.samples > 1) keep(name, [&] { write_samples(json_, image); });
  }

  const CaseResults& one_;
  const bool is_large_;
  std::string& text_;
  JsonWriter json_;
};

void CaseWriter::write_origin() {
  json_.member("id", one_.id);
  json_.member("title", one_.title);
  json_.member("why", one_.why);
  json_.member("rules", one_.rules);
  json_.member("spec", one_.spec);
  json_.member("origin", one_.origin);
  json_.member("tags", one_.tags);
  json_.member("file", one_.file);
  json_.member("file_digest", one_.file_digest);
  json_.member("surface", one_.surface);
  json_.member("width", one_.width);
  json_.member("height", one_.height);
  if (const auto& v = one_.viewport) json_.key("viewport").array(v->x, v->y, v->width, v->height);
}

void CaseWriter::write_exact() {
  json_.member("fragments", one_.fragments);
  keep_pixels("pixels", one_.pixels->bytes());
  keep_samples("samples", one_.samples);
  keep_list("figure", one_.figure.marks, write_mark);
  json_.member("expect_failures", one_.expect_failures);
}

void CaseWriter::write_result(const KnownResult& result) {
  json_.object([&] {
    write_judgement(result);
    write_findings(result);
    write_pictures(result);
  });
}

void CaseWriter::write_judgement(const KnownResult& result) {
  json_.member("verdict", name_of(result.verdict));
  json_.member("fingerprint", result.fingerprint);
  json_.member("standing", name_of(result.standing));
  if (!result.standing_reason.empty()) json_.member("standing_reason", result.standing_reason);
  if (!result.faults.empty()) json_.member("faults", result.faults);
  if (result.again) write_answer(json_.key("again"), *result.again);
  if (result.failure)
    write_failure(json_.key("failure"), *result.failure);
  else
    write_pixel_counts(json_.key("pixel_counts"), result.pixel_counts);
}

void CaseWriter::write_findings(const KnownResult& result) {
  keep_list("disagreements", result.disagreements, write_disagreement);
  json_.key("values").list([&] {
    for (const ValueAggregate& values : result.values) write_values(values);
  });
  keep_list("evidence", result.evidence, write_evidence);
  json_.member("illegal_line_snaps", result.illegal_line_snaps);
  json_.member("refuted", text_of_refuted(result.refuted));
  if (!result.exact_fragments.empty())
    keep_list("exact_fragments", result.exact_fragments, write_fragment);
  if (!result.rendered_fragments.empty())
    keep_list("rendered_fragments", result.rendered_fragments, write_fragment);
  if (!result.ramp.empty()) json_.key("ramp").list(result.ramp, write_level);
}

void CaseWriter::write_pictures(const KnownResult& result) {
  if (!result.failure) write_picture(result.pixels);
  if (!result.exact_pixels->empty()) keep_pixels("exact_pixels", result.exact_pixels->bytes());
  keep_samples("samples", result.samples);
  keep_samples("exact_samples", result.exact_samples);
}

void CaseWriter::write_values(const ValueAggregate& values) {
  json_.object([&] {
    json_.member("attribute", values.attribute);
    json_.member("rule", name_of(values.rule));
    json_.member("ruling", values.ruling);
    json_.member("compared", values.compared);
    json_.member("components", values.components);
    write_worst(values);
    json_.key("ulp_histogram").object([&] {
      for (const auto& [bucket, count] : values.ulp_histogram)
        json_.member(std::to_string(bucket), count);
    });
    keep("differing", [&] {
      is_large_ ? write_places(json_, values.differing) : json_.list(values.differing, write_place);
    });
    if (!values.cause.empty()) json_.member("cause", text_of(values.cause));
  });
}

void CaseWriter::write_worst(const ValueAggregate& values) {
  write_place(json_.key("worst"), values.worst);
  json_.member("worst_component", values.worst_component);
  json_.member("worst_exact", values.worst_exact);
  json_.member("worst_rendered", values.worst_rendered);
  json_.member("worst_ulp", values.worst_ulp);
  json_.member("mean_ulp", values.mean_ulp);
  json_.member("worst_relative", values.worst_relative);
}

// Equal pictures are said to be so, not stored twice; of large ones only the difference is stored.
void CaseWriter::write_picture(const Shared<PackedWords>& rendered) {
  if (rendered == one_.pixels)
    json_.member("pixels", "exact");
  else if (!is_large_ || rendered->size() != one_.pixels->size())
    keep_pixels("pixels", rendered->bytes());
  else
    keep_pixels("difference", difference_of(rendered->bytes(), one_.pixels->bytes()));
}

}  // namespace

void append_case(const CaseResults& one, const std::vector<RendererInfo>& renderers,
                 std::string& text) {
  CaseWriter(one, text).write_case(renderers);
}

}  // namespace edgecase
