// SPDX-License-Identifier: MIT
#include "search/find_file.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "casefile/case_writer.h"
#include "casefile/json/text.h"
#include "model/result.h"
#include "rules/all_rules.h"
#include "search/grid_search.h"
#include "search/minimize.h"
#include "search/trial.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostWords = 500;  // bytes of a renderer's text in one answer

// FNV-1a, 32 bits.
std::uint32_t hash_of(std::string_view text) {
  std::uint32_t hash = 0x811c9dc5u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193u;
  return hash;
}

std::string sentence_of_end(const Find& find) {
  switch (find.end) {
    case MinimizeEnd::finished:
      return "No smaller scene was found that shows it.";
    case MinimizeEnd::exhausted:
      return "Smaller scenes that show it may exist.";
    case MinimizeEnd::stopped:
      return "The search for a smaller scene was interrupted.";
    case MinimizeEnd::not_reproduced:
      return "The renderer did not show it again.";
  }
  return "";
}

// Why its coordinates are as fine as they are, if that is known.
std::string sentence_of_bits(const Find& find) {
  if (find.least_bits <= kReadableBits) return "";
  return fmt::format(
      " With fewer than {} fraction bits its vertices lie on both grids, that of the policy and "
      "that of the cause, and neither moves them.",
      find.least_bits);
}

std::string explanation_of(const Find& find) {
  if (find.result.failure)
    return fmt::format("The renderer fails: {}.", text_for_file(find.result.failure->reason));
  const Disagreement* d = first_disagreement(find);
  if (d == nullptr)
    return fmt::format("Its {} differs inside what is permitted.", find.key.signature.attribute);
  return fmt::format("Pixel ({}, {}): {}", d->x, d->y, d->explanation);
}

std::string judgement_of(const Find& find) {
  const Signature& signature = find.key.signature;
  std::string text = find.result.failure                     ? ""
                     : signature.legality == Legality::legal ? "The specification allows it"
                     : signature.legality == Legality::contested
                         ? "The wording of the specification forbids it, which is contested"
                         : "The specification does not allow it";
  if (!signature.cause.empty()) text += "; cause: " + signature.cause;
  if (!signature.situation.empty()) text += "; situation: " + signature.situation;
  return text.empty() ? text : text + ". ";
}

std::string why_of(const Find& find, std::uint64_t seed) {
  std::string why = explanation_of(find) + " " + judgement_of(find);
  for (const FindAnswer& answer : find.answers)
    why += fmt::format("{}: {}. ", text_for_file(answer.renderer), text_for_file(answer.words));
  return why + fmt::format("Found by edgecase fuzz: {}. {}{}", describe(find.origin, seed),
                           sentence_of_end(find), sentence_of_bits(find));
}

}  // namespace

std::string text_for_file(const std::string& words) {
  return std::string(beginning_of(clean_line(words), kMostWords));
}

FindFile find_file(const Find& find, std::uint64_t seed, const std::string& schema) {
  const std::string rule = rule_of(find);
  CaseWords words;
  words.title =
      beginning_of(fmt::format("{}: {}", text_for_file(find.renderer), title_of(find)), kMostTitle);
  words.rules = {rule};
  const CaseText plain = case_text(find.scene, words);
  FindFile file;
  file.name = fmt::format("{}-{:08x}.json", rule, hash_of(plain.text));
  words.schema = schema;
  words.why = why_of(find, seed);
  if (const Rule* known = find_rule(rule)) words.spec = "GL 4.6 core, " + known->spec;
  words.tags = {"fuzz", find.origin.family};
  CaseText text = case_text(find.scene, words);
  file.text = std::move(text.text);
  file.diagnostics = std::move(text.diagnostics);
  return file;
}

}  // namespace edgecase
