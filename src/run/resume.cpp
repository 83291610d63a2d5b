// SPDX-License-Identifier: MIT
#include "run/resume.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "model/text.h"

namespace edgecase {
namespace {

bool could_be_had(const CaseOutline& one) {
  return std::ranges::none_of(one.answers, [](const ResultOutline& answer) {
    return answer.failure && answer.failure->kind == FailureKind::unavailable;
  });
}

// May what the case draws lie in files beside its own? The keys of a mesh and of an image.
bool may_need_more_files(const std::string& source) {
  return source.find("\"mesh\"") != std::string::npos ||
         source.find("\"file\"") != std::string::npos;
}

bool is_still_right(const CaseResults& earlier, const Case& now) {
  return earlier.file_digest == digest_of_text(*now.source) && !may_need_more_files(*now.source);
}

// The cases that would be lost: files that are gone, and those whose cases may be others now, leave
// ids behind that nobody misses.
std::variant<Resumption, std::string> checked(Resumption resumed, const std::string& name,
                                              const CaseList& earlier,
                                              const std::map<std::string, std::size_t>& left) {
  std::set<std::string> changed;
  for (const Diagnostic& diagnostic : resumed.rest.diagnostics) changed.insert(diagnostic.file);
  for (const Case& one : resumed.rest.cases) changed.insert(one.file.generic_string());
  for (const auto& [id, index] : left) {
    const std::string file = earlier[index].file;
    std::error_code error;
    if (!changed.contains(file) && std::filesystem::exists(file, error))
      return fmt::format(
          "{} holds the case {}, which is not selected now and would be lost; name the paths and "
          "filters of that run, or run without --resume",
          name, id);
  }
  return resumed;
}

}  // namespace

std::variant<Resumption, std::string> resume(const Suite& suite, MergePart earlier) {
  const CaseList cases = std::exchange(earlier.results.cases, {});
  std::map<std::string, std::size_t> known;  // index by id
  for (const CaseOutline& one : cases.outlines()) known.emplace(one.id, known.size());
  Resumption resumed;
  Results& held = resumed.held = std::move(earlier.results);
  held.diagnostics.clear();
  held.faults.clear();
  held.shard.reset();
  held.interrupted = false;
  held.left_out = 0;
  resumed.rest.diagnostics = suite.diagnostics;
  for (const Case& now : suite.cases) {
    const auto found = known.find(now.id);
    bool is_kept = false;
    if (found != known.end() && could_be_had(cases.outline(found->second))) {
      CaseResults one = cases[found->second];
      is_kept = is_still_right(one, now);
      one.file = now.file.generic_string();
      if (is_kept) held.cases.push_back(one);
    }
    if (!is_kept) resumed.rest.cases.push_back(now);
    if (found != known.end()) known.erase(found);
  }
  return checked(std::move(resumed), earlier.name, cases, known);
}

}  // namespace edgecase
