// SPDX-License-Identifier: MIT
//
// Expectations: what a named renderer is known to answer, so that CI is green on known faults and
// red on new ones.
//
// A file belongs to one renderer. An entry names a case, the verdict, the fingerprint of what
// differs, and the reason, for people. A case without an entry is expected to agree. An entry
// matches only if both verdict and fingerprint are what they were, but for the two legal verdicts,
// convention and permitted, which count as one: which of them the same difference gets depends on
// the other cases of the run. A known fault that changes is as red as a new one, and so is one that
// is gone.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/verdict.h"
#include "results/results.h"

namespace edgecase {

struct Expectation {
  Verdict verdict = Verdict::violation;
  std::string fingerprint;
  std::string reason;  // one sentence, never empty
  std::string link;    // where it is reported, or empty
};

struct Expectations {
  std::string renderer;  // name, "osmesa:llvmpipe"
  std::string measured;  // device and version on which the entries were measured
  std::map<std::string, Expectation> cases;  // by case id
};

// Is anything asked of a renderer? Empty: of every one.
using WantedRenderer = std::function<bool(const std::string& renderer)>;

// Reads a file's text; a sentence that says what is wrong and where, otherwise. Of a renderer that
// is not wanted only the name is returned, and what follows it is not read.
std::variant<Expectations, std::string> parse_expectations(const std::string& text,
                                                           const WantedRenderer& wanted = {});

// The file's text: an entry on a line each, sorted by case id.
std::string expectations_text(const Expectations& expectations);

// The name of a renderer's file: "osmesa-llvmpipe.json". A program's command line may be longer
// than a file system's names: of such a name the beginning is kept, with a digest of the whole.
std::string expectations_file_name(const std::string& renderer);

// Sets standing, expectation and expected of every result of the renderer at `index`.
// `expectations` may be null: then every case is expected to agree. A result that was another one
// when it was asked for again is a flake, whatever is expected. A contested answer that no entry
// expects is tolerated.
void apply_expectations(Results& results, std::size_t index, const Expectations* expectations);

// As --strict has it: what is tolerated becomes unexpected, or changed where there is an entry.
void hold_contested(Results& results);

// The entries without a case, of results that hold every case of the suite; of others none, since a
// case may have been left out.
std::vector<MissingCase> missing_cases(const Results& results, const Expectations& expectations);

// What blessing would change: for each case of the results whose entry would be another, the old
// and the new one, and the entries of missing cases, which go. Reasons of unchanged entries are
// kept; a new entry gets `reason`, or where that is empty a reason made of the causes found. Flakes
// are left as they are: nothing that changes can be expected. Sorted by case id.
struct ExpectationChange {
  std::string id;
  const Expectation* before = nullptr;  // null: the entry is new
  std::optional<Expectation> after;     // nothing: the entry goes
};

std::vector<ExpectationChange> plan_blessing(const Results& results, std::size_t index,
                                             const Expectations& current,
                                             const std::string& reason);

// The reason that a new entry gets where nobody gives one: what was found, in short.
std::string reason_from(const Result& result);

}  // namespace edgecase
