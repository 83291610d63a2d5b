// SPDX-License-Identifier: MIT
#include "results/driver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>

namespace edgecase {
namespace {

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

// "22.3.6"; digits beyond nine of a number are left out, since no release has them.
std::vector<int> numbers_of(const std::string& text) {
  std::vector<int> numbers;
  static const std::regex kNumber("[0-9]{1,9}");
  for (auto at = std::sregex_iterator(text.begin(), text.end(), kNumber);
       at != std::sregex_iterator(); ++at)
    numbers.push_back(std::stoi(at->str()));
  return numbers;
}

// What follows OpenGL's own version: "Mesa 22.3.6" of "4.5 (Core Profile) Mesa 22.3.6". All of the
// text where nothing with a number follows.
std::string after_opengl(const std::string& version, bool& is_es) {
  static const std::regex kOpenGl(R"(^(OpenGL ES )?\d+\.\d+(?:\.\d+)?(?: \([^)]*\))? +(.*\d.*)$)");
  is_es = version.starts_with("OpenGL ES ");
  std::smatch match;
  return std::regex_match(version, match, kOpenGl) ? match[2].str() : version;
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

std::string driver_of(const RendererInfo& info) {
  if (!is_opengl(known_as(info))) return known_as(info);
  for (const char* name : {"llvmpipe", "softpipe"})
    if (info.device.starts_with(name)) return name;
  if (info.device.starts_with("zink"))
    return info.device.find("SwiftShader") != std::string::npos ? "SwiftShader" : "zink";
  const std::string name = trimmed(info.device.substr(0, info.device.find_first_of("(/")));
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

}  // namespace edgecase
