// SPDX-License-Identifier: MIT
#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "model/text.h"
#include "results/worst_first.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

constexpr std::uint32_t kReplacement = 0xFFFD;
constexpr std::uint32_t kControlPictures = 0x2400;

struct Decoded {
  std::uint32_t code = kReplacement;
  std::size_t bytes = 1;  // consumed, at least one
};

std::uint32_t byte_at(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

// The number of bytes that a lead byte announces; 0: it is no lead byte.
std::size_t sequence_length(std::uint32_t lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

// Decodes the character at `at`; what is not UTF-8 (overlong, surrogate, cut off) is one
// replacement character per byte.
Decoded decode(std::string_view text, std::size_t at) {
  constexpr std::uint32_t kLeadMask[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const std::uint32_t lead = byte_at(text, at);
  const std::size_t length = sequence_length(lead);
  if (length == 0 || at + length > text.size()) return {};
  std::uint32_t code = lead & kLeadMask[length];
  for (std::size_t i = 1; i < length; ++i) {
    const std::uint32_t byte = byte_at(text, at + i);
    if ((byte & 0xC0) != 0x80) return {};
    code = code << 6 | (byte & 0x3F);
  }
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (code < kLeast[length] || code > 0x10FFFF || surrogate) return {};
  return {code, length};
}

void append_utf8(std::string& out, std::uint32_t code) {
  const auto put = [&out](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (code < 0x80) return put(code);
  if (code < 0x800) {
    put(0xC0 | code >> 6);
  } else {
    if (code < 0x10000) {
      put(0xE0 | code >> 12);
    } else {
      put(0xF0 | code >> 18);
      put(0x80 | (code >> 12 & 0x3F));
    }
    put(0x80 | (code >> 6 & 0x3F));
  }
  put(0x80 | (code & 0x3F));
}

// Marks that change the direction of the text around them.
bool turns_text(std::uint32_t code) {
  return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

std::uint32_t visible(std::uint32_t code, bool keep_breaks) {
  if (keep_breaks && (code == '\t' || code == '\n')) return code;
  if (code < 0x20) return kControlPictures + code;
  if (code == 0x7F) return kControlPictures + 0x21;
  if (!keep_breaks && turns_text(code)) return kReplacement;
  const bool c1 = code >= 0x80 && code < 0xA0;
  return c1 || code == 0xFFFE || code == 0xFFFF ? kReplacement : code;
}

// White space before a command does not hide it from the runner.
bool is_space(std::uint32_t code) {
  return code == ' ' || (code >= '\t' && code <= '\r') || code == 0x85 || code == 0xA0 ||
         code == 0x1680 || (code >= 0x2000 && code <= 0x200A) || code == 0x2028 || code == 0x2029 ||
         code == 0x202F || code == 0x205F || code == 0x3000 || code == 0xFEFF;
}

// Is a space needed at `at`, so that a log of GitHub's is not obeyed there? Its runner takes
// "::error::" at the beginning of a line, and "##[error]" anywhere, for commands.
bool breaks_command(std::string_view text, std::size_t at, bool is_at_begin) {
  const std::string_view before = text.substr(0, at);
  return (is_at_begin && text[at] == ':' && before.ends_with(':')) ||
         (text[at] == '[' && before.ends_with("##"));
}

std::string make_visible(std::string_view text, bool keep_breaks) {
  std::string out;
  out.reserve(text.size());
  bool is_at_begin = true;  // of a line, but for spaces and a colon
  for (std::size_t at = 0; at < text.size();) {
    if (breaks_command(text, at, is_at_begin)) out += ' ';
    const Decoded next = decode(text, at);
    const std::uint32_t code = visible(next.code, keep_breaks);
    append_utf8(out, code);
    at += next.bytes;
    const bool stays = is_at_begin && (is_space(code) || code == ':');
    is_at_begin = code == '\n' || stays;
  }
  return out;
}

}  // namespace

std::string xml_text(std::string_view text) {
  return make_visible(text, true);
}

std::string one_line(std::string_view text) {
  return make_visible(text, false);
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t end = most;
  while (end > 0 && (byte_at(text, end) & 0xC0) == 0x80) --end;  // inside a character
  return fmt::format("{}\xE2\x80\xA6 ({} bytes more)", text.substr(0, end), text.size() - end);
}

std::size_t count_differences(const Result& result) {
  std::size_t count = count_disagreements(result);
  for (const ValueAggregate& values : result.values) count += values.differing.size();
  return count;
}

std::string headline(const Result& result) {
  std::string text = fmt::format("{}, {}", name_of(result.verdict), name_of(result.standing));
  if (result.verdict == Verdict::not_run) {
    if (result.failure) text += fmt::format(", {}", name_of(result.failure->kind));
    return text;
  }
  const std::size_t disagreements = count_disagreements(result);
  const std::size_t values = count_differences(result) - disagreements;
  text += ", " + counted(disagreements, "disagreement", "disagreements");
  if (values > 0) text += ", " + counted(values, "value", "values") + " within what is permitted";
  return text;
}

std::string words_of_interruption(const Results& results) {
  if (results.left_out == 0) return "The run was interrupted.";
  return fmt::format("The run was interrupted; {} missing.",
                     counted(results.left_out, "case is", "cases are"));
}

std::string words_of_idleness(const Results& results, std::size_t renderer) {
  constexpr std::size_t kMostReasons = 6;
  constexpr std::size_t kMostOfReason = 300;
  std::string text = fmt::format("{} drew none of {}:", one_line(results.renderers[renderer].name),
                                 counted(results.cases.size(), "case", "cases"));
  const std::vector<Refusal> refusals = refusals_of(results, renderer);
  const std::size_t listed = std::min(kMostReasons, refusals.size());
  for (std::size_t i = 0; i < listed; ++i)
    text += fmt::format("{} {} x \"{}\"", i > 0 ? "," : "", grouped(refusals[i].cases),
                        one_line(shortened(refusals[i].reason, kMostOfReason)));
  if (listed < refusals.size())
    text += ", and " + counted(refusals.size() - listed, "more reason", "more reasons");
  if (results.shard && results.shard->count > 1)
    text += "; whether that is so of the whole run, `edgecase merge` tells";
  return text;
}

bool names_sample(const Disagreement& d, int samples) {
  return samples > 1 && d.sample >= 0;
}

std::string place_of(const Disagreement& d, int samples) {
  const std::string pixel = fmt::format("pixel ({}, {})", d.x, d.y);
  return names_sample(d, samples) ? fmt::format("{}, sample {}", pixel, d.sample) : pixel;
}

namespace {

// ", missing, triangle.fill-rule, not allowed by ruling 4".
std::string describe_class(const DisagreementClass& d) {
  std::string text =
      fmt::format(", {}, {}, {}", name_of(d.kind), name_of(d.rule), describe(d.legality));
  if (d.ruling > 0) text += fmt::format(" by ruling {}", d.ruling);
  if (!d.cause.empty()) text += fmt::format(", cause {}", text_of(d.cause));
  return text;
}

}  // namespace

std::string describe(const Disagreement& d, int samples) {
  std::string text = place_of(d, samples);
  if (d.primitive >= 0) text += fmt::format(", primitive {}", d.primitive);
  return text + describe_class(d) + ": " + d.explanation;
}

std::vector<std::string> describe_counted(const Result& result) {
  std::map<std::pair<Legality, std::string>, std::size_t, std::greater<>> counts;
  for (const CountedDisagreements& one : result.counted)
    counts[{one.legality, describe_class(one)}] += one.count();
  std::vector<std::string> lines;
  for (const auto& [of, count] : counts)
    lines.push_back(fmt::format("and {} more{}", grouped(count), of.second));
  return lines;
}

std::string describe_permitted(const ValueAggregate& values) {
  if (std::isnan(values.worst_low)) return "";
  return fmt::format(", {:.9g} to {:.9g} permitted", values.worst_low, values.worst_high);
}

std::string describe(const ValueAggregate& values) {
  if (values.differing.empty())
    return fmt::format("{}: all {} values agree", values.attribute, values.compared);
  return fmt::format(
      "{}: {} of {} values differ {}, worst {:.4g} ULP at pixel ({}, {}): "
      "{} exact, {} rendered{}; mean {:.3g} ULP, at most {:.3g} of the attribute's range",
      values.attribute, values.differing.size(), values.compared,
      values.cause.empty() ? "within what is permitted" : "by " + text_of(values.cause),
      values.worst_ulp, values.worst.x, values.worst.y, values.worst_exact, values.worst_rendered,
      describe_permitted(values), values.mean_ulp, values.worst_relative);
}

std::string describe(const FaultSeen& seen) {
  const std::string cases = counted(seen.cases, "case", "cases");
  switch (seen.state) {
    case FaultState::known:
      return cases;
    case FaultState::grown:
      return fmt::format("it has grown: {}, and {} known on this release", cases,
                         *seen.before == 1 ? "1 is" : fmt::format("{} are", *seen.before));
    case FaultState::shrunk:
      return fmt::format("it has shrunk: {} of {} that are known on this release", cases,
                         *seen.before);
    case FaultState::fixed:
      return seen.before
                 ? fmt::format("it is fixed: none of {}", counted(*seen.before, "case", "cases"))
                 : "it does not show on this release";
    case FaultState::uncounted:
      return fmt::format("{}, of a release without a count", cases);
  }
  return "";
}

const char* describe(ChangeKind change) {
  switch (change) {
    case ChangeKind::new_disagreement:
      return "new disagreements";
    case ChangeKind::worse:
      return "worse";
    case ChangeKind::not_run:
      return "not run any more";
    case ChangeKind::changed:
      return "changed";
    case ChangeKind::appeared:
      return "cases that appeared";
    case ChangeKind::disappeared:
      return "cases that disappeared";
    case ChangeKind::runs:
      return "run now";
    case ChangeKind::better:
      return "better";
    case ChangeKind::fixed:
      return "fixed";
  }
  return "?";
}

std::string first_explanation(const Result& result, int samples) {
  if (result.failure) return result.failure->reason;
  if (!result.disagreements.empty()) {
    const Disagreement& first = *worst_first(result).front();
    return fmt::format("{}: {}", place_of(first, samples), first.explanation);
  }
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty()) return describe(values);
  return result.standing_reason;
}

}  // namespace edgecase
