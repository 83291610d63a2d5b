// SPDX-License-Identifier: MIT
//
// Known faults: what is known of a driver, as a person would file it, so that CI is green on known
// faults and red on new ones.
//
//   {"driver": "llvmpipe", "faults": [
//     {"id": "first-fragment-lost", "rule": "line.diamond-exit", "kind": "missing",
//      "cause": "line.algorithm=…", "surface": "fbo", "cases": ["lines"],
//      "versions": "Mesa >=22.3", "cases_on": {"Mesa 22.3.6": 96}, "reason": "…", "link": "…"}]}
//
// A file belongs to one driver (results/driver.h), however that is reached. An entry accounts for a
// difference that the letter of the specification forbids if rule, kind, cause, surface, case,
// renderer and release of the driver fit; what is absent fits any, but a rule or a cause is named.
// Legal differences need no entry. "rule", "kind" and "renderer" may be lists. "cause" is part of
// the difference's cause, or "none" where no catalogued alternative may explain it. A name in
// "cases" holds for the case, and for all cases of the file and folder of that name; * and ? are
// wildcards, in "renderer" as well. An entry for answers that did not come has neither rule nor
// cause, and the kind "crashed", "timed-out" or "garbage".
//
// "cases_on" is how many cases the entry accounted for in runs of the whole suite, by release.
// Where a release has more, the fault has grown, and that is as red as a new one.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/rule_id.h"
#include "model/verdict.h"
#include "results/driver.h"
#include "results/results.h"

namespace edgecase {

struct KnownFault {
  std::string id;             // unique in its file
  std::vector<RuleId> rules;  // empty: any, where there is a cause
  std::vector<std::string>
      kinds;                   // names of DisagreementKind or FailureKind; empty: any difference
  std::optional<Cause> cause;  // nothing: any; empty: no catalogued alternative explains it
  std::string surface;         // "fbo", "window"; empty: any
  std::vector<std::string> renderers;           // names of renderers; empty: any
  std::vector<std::string> cases;               // never empty
  std::optional<VersionRange> versions;         // nothing: any
  std::map<std::string, std::size_t> cases_on;  // by text_of(Release)
  std::string reason;                           // a sentence, never empty
  std::string link;                             // where it is reported, or empty

  // Is it about answers that did not come?
  bool is_failure() const { return rules.empty() && !cause; }
  friend bool operator==(const KnownFault&, const KnownFault&) = default;
};

struct KnownFaults {
  std::string driver;
  std::vector<KnownFault> faults;  // in the file's order
};

// A file's text; a sentence that says what is wrong and where, otherwise.
std::variant<KnownFaults, std::string> parse_known_faults(const std::string& text);
std::string known_faults_text(const KnownFaults& known);

// The name of a file about a driver or a renderer: "llvmpipe.json", "egl-zink.json". A program's
// command line may be longer than a file system's names: of such a name the beginning is kept, with
// a digest of the whole.
std::string file_name_about(const std::string& name);

// Does a name of KnownFault::cases hold for a case?
bool names_case(const std::string& name, const std::string& id);

// Does the fault account for one difference of an answer, or for the answer that did not come,
// whatever the renderer and its release? `surface` is the case's. A cause fits if it is part of the
// difference's or, of coverage, of one that explains its primitive: which of these is told depends
// on the run.
bool accounts_for(const KnownFault& fault, const std::string& id, const std::string& surface,
                  const Result& result, const Disagreement& d);
bool accounts_for(const KnownFault& fault, const std::string& id, const std::string& surface,
                  const Failure& failure);

// The faults that a renderer of this name and release may have.
std::vector<const KnownFault*> faults_of(const KnownFaults& known, const RendererInfo& info);

}  // namespace edgecase
