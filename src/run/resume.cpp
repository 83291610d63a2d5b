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

bool could_be_had(const CaseResults& one) {
  return std::ranges::none_of(one.results, [](const Result& result) {
    return result.failure && result.failure->kind == FailureKind::unavailable;
  });
}

// May what the case draws lie in files beside its own? The keys of a mesh and of an image.
bool may_need_more_files(const std::string& source) {
  return source.find("\"mesh\"") != std::string::npos ||
         source.find("\"file\"") != std::string::npos;
}

bool is_still_right(const CaseResults& earlier, const Case& now) {
  return earlier.file_digest == digest_of_text(*now.source) && could_be_had(earlier) &&
         !may_need_more_files(*now.source);
}

// The cases that would be lost: files that are gone, and those whose cases may be others now, leave
// ids behind that nobody misses.
std::variant<Resumption, std::string> checked(Resumption resumed, const std::string& name,
                                              const std::map<std::string, CaseResults>& left) {
  std::set<std::string> changed;
  for (const Diagnostic& diagnostic : resumed.rest.diagnostics) changed.insert(diagnostic.file);
  for (const Case& one : resumed.rest.cases) changed.insert(one.file.generic_string());
  for (const auto& [id, one] : left) {
    std::error_code error;
    if (!changed.contains(one.file) && std::filesystem::exists(one.file, error))
      return fmt::format(
          "{} holds the case {}, which is not selected now and would be lost; name the paths and "
          "filters of that run, or run without --resume",
          name, id);
  }
  return resumed;
}

}  // namespace

std::variant<Resumption, std::string> resume(const Suite& suite, MergePart earlier) {
  std::map<std::string, CaseResults> known;
  for (CaseResults& one : earlier.results.cases) known.emplace(one.id, std::move(one));
  Resumption resumed;
  Results& held = resumed.held = std::move(earlier.results);
  held.cases.clear();
  held.diagnostics.clear();
  held.faults.clear();
  held.shard.reset();
  held.interrupted = false;
  held.left_out = 0;
  resumed.rest.diagnostics = suite.diagnostics;
  for (const Case& now : suite.cases) {
    const auto found = known.find(now.id);
    if (found == known.end() || !is_still_right(found->second, now)) {
      resumed.rest.cases.push_back(now);
    } else {
      CaseResults& one = held.cases.emplace_back(std::move(found->second));
      one.file = now.file.generic_string();
      one.source = now.source;
    }
    if (found != known.end()) known.erase(found);
  }
  return checked(std::move(resumed), earlier.name, known);
}

}  // namespace edgecase
