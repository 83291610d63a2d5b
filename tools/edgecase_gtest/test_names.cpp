// SPDX-License-Identifier: MIT
#include "tools/edgecase_gtest/test_names.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "casefile/loader.h"

namespace edgecase {
namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' ||
         c == '=';
}

// "lines/short.every_place/start=_9" without the values of a sweep.
std::string without_values(const std::string& name) {
  const std::size_t test = name.find('.');
  return name.substr(0, name.find('/', test == std::string::npos ? 0 : test));
}

}  // namespace

std::string name_text(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return !is_plain(c); }, '_');
  return text;
}

TestName test_name_of(const std::string& prefix, const std::string& id) {
  const std::size_t values = std::min(id.find(':'), id.size());
  const std::string file = name_text(id.substr(0, values));
  std::string rest = id.substr(values);
  std::ranges::replace(rest, ':', '/');
  const std::size_t slash = file.rfind('/');
  const std::string folders = slash == std::string::npos ? "cases" : file.substr(0, slash);
  return {prefix + folders, file.substr(slash + 1) + name_text(rest)};
}

bool narrow_to_filter(const std::string& filter, std::span<const std::string> prefixes,
                      Selection& selection) {
  const std::string wanted = filter.substr(0, filter.find('-'));
  if (wanted.empty() || wanted.find_first_of("*?") != std::string::npos) return false;
  std::set<std::string> files;
  std::istringstream patterns(wanted);
  for (std::string one; std::getline(patterns, one, ':');) {
    if (one.starts_with(kFilesSuite)) return false;
    files.insert(without_values(one));
  }
  selection.only.emplace();
  for (const CaseFile& file : find_cases(selection.paths).cases)
    for (const std::string& prefix : prefixes) {
      const TestName name = test_name_of(prefix, file.id);
      if (files.contains(without_values(name.suite + "." + name.test)))
        selection.only->files.insert(file.file);
    }
  return true;
}

}  // namespace edgecase
