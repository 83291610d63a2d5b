// SPDX-License-Identifier: MIT
#include "results/known_faults.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>

#include "model/text.h"
#include "results/shallow_json.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

// The numbers of "22.3.6". Digits beyond nine of a number are ignored.
std::vector<int> numbers_of(const std::string& text) {
  std::vector<int> numbers;
  static const std::regex kNumber("[0-9]{1,9}");
  for (auto at = std::sregex_iterator(text.begin(), text.end(), kNumber);
       at != std::sregex_iterator(); ++at)
    numbers.push_back(std::stoi(at->str()));
  return numbers;
}

// The text after OpenGL's own version: "Mesa 22.3.6" of "4.5 (Core Profile) Mesa 22.3.6", or what
// is in brackets there: "ANGLE 2.1" of "OpenGL ES 3.1 (ANGLE 2.1)". The whole text if nothing with
// a number follows.
std::string after_opengl(const std::string& version, bool& is_es) {
  static const std::regex kOpenGl(
      R"(^(OpenGL ES )?\d+\.\d+(?:\.\d+)?(?: \([^)]*\))? +([^(].*\d.*|\d.*)$)");
  is_es = version.starts_with("OpenGL ES ");
  static const std::regex kBracketed(R"(^(OpenGL ES )?\d+\.\d+(?:\.\d+)? \((.*\d.*)\)$)");
  std::smatch match;
  const bool follows =
      std::regex_match(version, match, kOpenGl) || std::regex_match(version, match, kBracketed);
  return follows ? match[2].str() : version;
}

std::string dotted(const std::vector<int>& numbers) {
  return fmt::format("{}", fmt::join(numbers, "."));
}

// "Mesa 22.3.6" without its number, or the number alone.
std::string joined(const std::string& product, const std::string& rest) {
  return product.empty() || rest.empty() ? product + rest : product + " " + rest;
}

}  // namespace

std::string text_of(const Release& release) {
  const std::string text = joined(release.product, dotted(release.numbers));
  return (text.empty() ? "unversioned" : text) + (release.is_es ? " ES" : "");
}

bool is_of_es_alone(const KnownFault& fault) {
  return !fault.cases_on.empty() && std::ranges::all_of(fault.cases_on, [](const auto& counted) {
    return counted.first.ends_with(" ES");
  });
}

Release release_of(const RendererInfo& info) {
  Release release;
  std::string text = info.version;
  if (is_opengl(known_as(info))) text = after_opengl(text, release.is_es);
  static const std::regex kVersion(R"(\d+(\.\d+)*)");
  std::smatch match;
  if (std::regex_search(text, match, kVersion)) release.numbers = numbers_of(match.str());
  release.product = trimmed(match.empty() ? text : match.prefix().str());
  return release;
}

namespace {

// What ANGLE draws with; of another driver the device.
std::string below_angle(const std::string& device) {
  static const std::regex kAngle(R"(^ANGLE \([^,]*, (?:Vulkan [\d.]+ \()?(.*), [^,]*\)$)");
  std::smatch match;
  return std::regex_match(device, match, kAngle) ? match[1].str() : device;
}

}  // namespace

std::string driver_of(const RendererInfo& info) {
  if (!is_opengl(known_as(info))) return known_as(info);
  const std::string device = below_angle(info.device);
  for (const char* name : {"llvmpipe", "softpipe", "SwiftShader"})
    if (device.starts_with(name)) return name;
  if (device.starts_with("zink"))
    return device.find("SwiftShader") != std::string::npos ? "SwiftShader" : "zink";
  const std::string name = trimmed(device.substr(0, device.find_first_of("(/")));
  return name.empty() ? known_as(info) : name;
}

std::string text_of(const VersionRange& range) {
  std::string text = range.product;
  if (!range.low.empty()) text = joined(text, ">=" + dotted(range.low));
  if (!range.high.empty()) text = joined(text, "<" + dotted(range.high));
  return text;
}

std::variant<VersionRange, std::string> parse_range(const std::string& text) {
  static const std::regex kRange(
      R"(^([^<>=]*?) *(?:>= *(\d{1,9}(?:\.\d{1,9})*))? *(?:< *(\d{1,9}(?:\.\d{1,9})*))?$)");
  std::smatch match;
  if (!std::regex_match(text, match, kRange) || match.str().empty())
    return fmt::format(
        "\"{}\" is no range of versions; write for instance \"Mesa >=22.3\" or "
        "\"Mesa >=22.3 <25.1\"",
        text);
  VersionRange range{trimmed(match[1].str()), numbers_of(match[2].str()),
                     numbers_of(match[3].str())};
  if (!range.low.empty() && !range.high.empty() && !is_before(range.low, range.high))
    return fmt::format("the range of versions \"{}\" is empty", text);
  return range;
}

bool holds(const VersionRange& range, const Release& release) {
  if (range.product != release.product) return false;
  if (!range.low.empty() && is_before(release.numbers, range.low)) return false;
  return range.high.empty() || is_before(release.numbers, range.high);
}

bool is_before(const std::vector<int>& a, const std::vector<int>& b) {
  const auto number = [](const std::vector<int>& version, std::size_t i) {
    return i < version.size() ? version[i] : 0;
  };
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
    if (number(a, i) != number(b, i)) return number(a, i) < number(b, i);
  return false;
}

namespace {

using Json = nlohmann::json;

constexpr const char* kNoCause = "none";  // in "cause": no catalogued alternative explains it

constexpr FailureKind kFailures[] = {FailureKind::crashed, FailureKind::timed_out,
                                     FailureKind::garbage};
constexpr DisagreementKind kDifferences[] = {DisagreementKind::missing, DisagreementKind::extra,
                                             DisagreementKind::duplicate, DisagreementKind::value};

template <class Kinds>
bool is_among(const Kinds& kinds, const std::string& name) {
  return std::ranges::any_of(kinds, [&](auto kind) { return name == name_of(kind); });
}

[[noreturn]] void refuse(const std::string& sentence) {
  throw std::runtime_error(sentence);
}

void refuse_unknown_keys(const Json& json, std::initializer_list<const char*> known) {
  for (const auto& [key, value] : json.items())
    if (std::ranges::find(known, key) == known.end())
      refuse(fmt::format("unknown key \"{}\"; there are {}", key, fmt::join(known, ", ")));
}

// A name, or a list of names.
std::vector<std::string> names_in(const Json& json) {
  if (json.is_string()) return {json.get<std::string>()};
  std::vector<std::string> names = json.get<std::vector<std::string>>();
  if (names.empty()) refuse("a list of names is empty");
  return names;
}

// A missing or empty member is refused.
std::string text_in(const Json& json, const char* key) {
  const std::string text = json.value(key, "");
  if (text.empty()) refuse(fmt::format("\"{}\" is missing", key));
  return text;
}

void read_kinds(const Json& json, KnownFault& fault) {
  if (json.contains("kind")) fault.kinds = names_in(json.at("kind"));
  if (fault.is_failure() && fault.kinds.empty())
    refuse("\"rule\", \"cause\" or \"kind\" is missing");
  const bool is_failure = fault.is_failure();
  for (const std::string& kind : fault.kinds)
    if (is_failure ? !is_among(kFailures, kind) : !is_among(kDifferences, kind))
      refuse(fmt::format("\"kind\" is {}, not \"{}\"",
                         is_failure
                             ? "crashed, timed-out or garbage where there is no rule and no cause"
                             : "missing, extra, duplicate or value",
                         kind));
}

void read_rules(const Json& json, KnownFault& fault) {
  for (const std::string& name : names_in(json)) {
    fault.rules.emplace_back();
    if (!parse_name(name, fault.rules.back()) || fault.rules.back() == RuleId::none)
      refuse(fmt::format("there is no rule \"{}\"", name));
  }
}

std::map<std::string, std::size_t> to_counts(const Json& json) {
  std::map<std::string, std::size_t> counts;
  for (const auto& [release, count] : json.items()) {
    if (!count.is_number_unsigned()) refuse("\"cases_on\" holds a number of cases by release");
    counts[release] = count.get<std::size_t>();
  }
  return counts;
}

KnownFault to_fault(const Json& json) {
  refuse_unknown_keys(json, {"id", "rule", "kind", "cause", "surface", "renderer", "cases",
                             "versions", "cases_on", "reason", "link"});
  KnownFault fault;
  fault.id = text_in(json, "id");
  if (json.contains("rule")) read_rules(json.at("rule"), fault);
  if (json.contains("cause")) {
    const std::string text = json.at("cause");
    fault.cause = text == kNoCause ? Cause() : parse_cause(text);
    if (!fault.cause) refuse(fmt::format("\"{}\" names no alternative of the catalogue", text));
  }
  read_kinds(json, fault);
  fault.surface = json.value("surface", "");
  if (json.contains("renderer")) fault.renderers = names_in(json.at("renderer"));
  if (!json.contains("cases")) refuse("\"cases\" is missing");
  fault.cases = names_in(json.at("cases"));
  if (json.contains("versions")) {
    auto range = parse_range(json.at("versions"));
    if (const auto* sentence = std::get_if<std::string>(&range)) refuse(*sentence);
    fault.versions = std::get<VersionRange>(range);
  }
  if (json.contains("cases_on")) fault.cases_on = to_counts(json.at("cases_on"));
  fault.reason = text_in(json, "reason");
  fault.link = json.value("link", "");
  return fault;
}

std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string list_text(const std::vector<std::string>& names, bool may_be_single) {
  if (may_be_single && names.size() == 1) return quoted(names.front());
  std::vector<std::string> texts;
  for (const std::string& name : names) texts.push_back(quoted(name));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

// An entry is a few lines: what it is about, where it shows, since when, and why.
std::string fault_text(const KnownFault& fault) {
  std::string text = fmt::format("    {{\"id\": {}", quoted(fault.id));
  const auto add = [&](const char* separator, const char* key, const std::string& value) {
    text += fmt::format("{}\"{}\": {}", separator, key, value);
  };
  constexpr const char* kSameLine = ", ";
  constexpr const char* kNextLine = ",\n     ";
  std::vector<std::string> rules;
  for (const RuleId rule : fault.rules) rules.emplace_back(name_of(rule));
  if (!rules.empty()) add(kSameLine, "rule", list_text(rules, true));
  if (!fault.kinds.empty()) add(kSameLine, "kind", list_text(fault.kinds, true));
  if (fault.cause)
    add(kNextLine, "cause", quoted(fault.cause->empty() ? kNoCause : text_of(*fault.cause)));
  if (!fault.surface.empty()) add(kSameLine, "surface", quoted(fault.surface));
  if (!fault.renderers.empty()) add(kNextLine, "renderer", list_text(fault.renderers, true));
  add(kNextLine, "cases", list_text(fault.cases, false));
  if (fault.versions) add(kNextLine, "versions", quoted(text_of(*fault.versions)));
  if (!fault.cases_on.empty()) {
    std::vector<std::string> counts;
    for (const auto& [release, count] : fault.cases_on)
      counts.push_back(fmt::format("{}: {}", quoted(release), count));
    add(fault.versions ? kSameLine : kNextLine, "cases_on",
        fmt::format("{{{}}}", fmt::join(counts, ", ")));
  }
  add(kNextLine, "reason", quoted(fault.reason));
  if (!fault.link.empty()) add(kNextLine, "link", quoted(fault.link));
  return text + "}";
}

bool matches(const std::string& glob, const std::string& text) {
  return fnmatch(glob.c_str(), text.c_str(), 0) == 0;
}

bool is_of(const KnownFault& fault, const std::string& renderer) {
  return fault.renderers.empty() ||
         std::ranges::any_of(fault.renderers,
                             [&](const std::string& glob) { return matches(glob, renderer); });
}

bool fits(const KnownFault& fault, const std::string& id, const std::string& surface,
          const char* kind) {
  return (fault.kinds.empty() || std::ranges::find(fault.kinds, kind) != fault.kinds.end()) &&
         (fault.surface.empty() || fault.surface == surface) &&
         std::ranges::any_of(fault.cases,
                             [&](const std::string& name) { return names_case(name, id); });
}

// True if `whole` has all alternatives of `part`.
bool is_part(const Cause& part, const Cause& whole) {
  return std::ranges::all_of(part.parts, [&](AlternativeId id) {
    return std::ranges::find(whole.parts, id) != whole.parts.end();
  });
}

// True if the cause is part of one that explains the drawing of the difference's primitive.
bool is_part_of_candidate(const Cause& part, const Result& result, const DisagreementClass& d) {
  return std::ranges::any_of(result.evidence, [&](const Result::Evidence& evidence) {
    return evidence.primitive == d.primitive && (evidence.pass < 0 || evidence.pass == d.sample) &&
           std::ranges::any_of(evidence.causes,
                               [&](const Cause& cause) { return is_part(part, cause); });
  });
}

bool fits_rule_and_cause(const KnownFault& fault, RuleId rule, const Cause& cause,
                         const Result& result, const DisagreementClass& d) {
  if (!fault.rules.empty() && std::ranges::find(fault.rules, rule) == fault.rules.end())
    return false;
  if (!fault.cause) return true;
  if (fault.cause->empty()) return cause.empty();
  return is_part(*fault.cause, cause) || is_part_of_candidate(*fault.cause, result, d);
}

}  // namespace

std::variant<KnownFaults, std::string> parse_known_faults(const std::string& text) {
  std::string where = "the file";
  try {
    const Json json = parse_shallow(text);
    if (!json.is_object()) refuse("it is no object");
    refuse_unknown_keys(json, {"driver", "faults"});
    KnownFaults known;
    known.driver = text_in(json, "driver");
    if (!json.contains("faults") || !json.at("faults").is_array())
      refuse("\"faults\" is missing, or no list");
    std::set<std::string> ids;
    for (const Json& item : json.at("faults")) {
      where = fmt::format("fault {}", known.faults.size() + 1);
      if (!item.is_object()) refuse("it is no object");
      if (item.contains("id") && item.at("id").is_string())
        where = fmt::format("fault \"{}\"", item.at("id").get<std::string>());
      known.faults.push_back(to_fault(item));
      if (!ids.insert(known.faults.back().id).second) refuse("its id is taken by another fault");
    }
    return known;
  } catch (const std::exception& error) {
    return fmt::format("{}: {}", where, fault_of(error));
  }
}

std::string known_faults_text(const KnownFaults& known) {
  std::vector<std::string> faults;
  for (const KnownFault& fault : known.faults) faults.push_back("\n" + fault_text(fault));
  return fmt::format("{{\n  \"driver\": {},\n  \"faults\": [{}{}]\n}}\n", quoted(known.driver),
                     fmt::join(faults, ","), faults.empty() ? "" : "\n  ");
}

std::string file_name_about(const std::string& name) {
  constexpr std::size_t kMostOfName = 200;  // bytes; file systems take 255
  std::string file = name.substr(0, kMostOfName);
  if (file.size() < name.size()) file += "-" + digest_of_text(name);
  std::ranges::replace_if(
      file, [](char c) { return c == ':' || c == '/' || c == ' '; }, '-');
  return file + ".json";
}

bool names_case(const std::string& name, const std::string& id) {
  if (name.find_first_of("*?[") != std::string::npos) return matches(name, id);
  return id.starts_with(name) &&
         (id.size() == name.size() || id[name.size()] == ':' || id[name.size()] == '/');
}

bool accounts_for(const KnownFault& fault, const std::string& id, const std::string& surface,
                  const Result& result, const DisagreementClass& d) {
  if (fault.is_failure() || !fits(fault, id, surface, name_of(d.kind))) return false;
  if (fits_rule_and_cause(fault, d.rule, d.cause, result, d)) return true;
  return d.upright && fits_rule_and_cause(fault, d.upright->rule, d.upright->cause, result, d);
}

bool accounts_for(const KnownFault& fault, const std::string& id, const std::string& surface,
                  const Failure& failure) {
  return fault.is_failure() && fits(fault, id, surface, name_of(failure.kind));
}

std::vector<const KnownFault*> faults_of(const KnownFaults& known, const RendererInfo& info) {
  const Release release = release_of(info);
  // A browser tells its own release and keeps the driver's to itself: any may be below it.
  const bool is_any_release = known_as(info).starts_with("webgl:");
  const auto is_in_range = [&](const KnownFault& fault) {
    return is_any_release || !fault.versions || holds(*fault.versions, release);
  };
  std::vector<const KnownFault*> faults;
  for (const KnownFault& fault : known.faults)
    if (is_in_range(fault) && is_of(fault, known_as(info))) faults.push_back(&fault);
  return faults;
}

}  // namespace edgecase
