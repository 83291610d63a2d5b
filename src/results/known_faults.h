// SPDX-License-Identifier: MIT
//
// Known faults of a driver, written as a person would file them, so that CI is green on known
// faults and red on new ones.
//
//   {"driver": "llvmpipe", "faults": [
//     {"id": "first-fragment-lost", "rule": "line.diamond-exit", "kind": "missing",
//      "cause": "line.algorithm=…", "surface": "fbo", "cases": ["lines"],
//      "versions": "Mesa >=22.3", "cases_on": {"Mesa 22.3.6": 96}, "reason": "…", "link": "…"}]}
//
// A file belongs to one driver (driver_of), however that is reached. An entry accounts
// for a difference that the letter of the specification forbids if rule, kind, cause, surface,
// case, renderer and release of the driver fit; what is absent fits any, but a rule or a cause is
// named. Legal differences need no entry. "rule", "kind" and "renderer" may be lists. "cause" is
// part of the difference's cause, or "none" where no catalogued alternative may explain it. A name
// in "cases" holds for the case, and for all cases of the file and folder of that name; * and ? are
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

#include "model/renderer.h"
#include "model/rule_id.h"
#include "model/verdict.h"
#include "results/results.h"

namespace edgecase {

// Drivers and their releases, from the reports of a renderer.
//
// Known faults belong to a driver, however it is reached: llvmpipe has the same faults through
// OSMesa and through EGL. An OpenGL driver is read from GL_RENDERER and its release from
// GL_VERSION. Any other program is its own driver, with its renderer's name.

struct Release {
  std::string product;       // "Mesa"; empty where the version begins with a number
  std::vector<int> numbers;  // 22, 3, 6; empty where no version is reported
  bool is_es = false;        // reached as OpenGL ES

  friend bool operator==(const Release&, const Release&) = default;
};

// "Mesa 22.3.6", "Mesa 22.3.6 ES", "1.0"; "unversioned" where nothing is reported.
std::string text_of(const Release& release);

// "4.5 (Core Profile) Mesa 22.3.6" is Mesa 22.3.6, "OpenGL ES 3.2 NVIDIA 535.104" is NVIDIA
// 535.104 of OpenGL ES, "OpenGL ES 3.1 (ANGLE 2.1.2)" is ANGLE 2.1.2 of OpenGL ES, "tiny 1.2" is
// tiny 1.2. It is the release of the upper layer: a fault of SwiftShader itself has no versions,
// and one in which zink has part has those of Mesa.
Release release_of(const RendererInfo& info);

// "llvmpipe", "softpipe", "zink" (on Mesa's own Vulkan), "SwiftShader" (below zink or ANGLE); of
// another OpenGL, GL_RENDERER up to its first bracket or slash, where ANGLE's names what it draws
// with; else known_as(info).
std::string driver_of(const RendererInfo& info);

// The releases of one product from `low` on and before `high`, if these are given:
// "Mesa >=22.3 <25.1". OpenGL and OpenGL ES are not distinguished.
struct VersionRange {
  std::string product;
  std::vector<int> low;   // empty: from the first on
  std::vector<int> high;  // empty: without end

  friend bool operator==(const VersionRange&, const VersionRange&) = default;
};

std::string text_of(const VersionRange& range);
// Otherwise a sentence that says what is wrong.
std::variant<VersionRange, std::string> parse_range(const std::string& text);

bool holds(const VersionRange& range, const Release& release);

// True if version `a` is before `b`. Missing numbers count as 0.
bool is_before(const std::vector<int>& a, const std::vector<int>& b);

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

  // True if it is about missing answers.
  bool is_failure() const { return rules.empty() && !cause; }
  friend bool operator==(const KnownFault&, const KnownFault&) = default;
};

// True if it was counted on releases that are reached as OpenGL ES, and on no others: OpenGL
// permits or defines there what OpenGL ES forbids.
bool is_of_es_alone(const KnownFault& fault);

struct KnownFaults {
  std::string driver;
  std::vector<KnownFault> faults;  // in the file's order
};

// Parses a file's text. Otherwise a sentence that says what is wrong and where.
std::variant<KnownFaults, std::string> parse_known_faults(const std::string& text);
std::string known_faults_text(const KnownFaults& known);

// The name of a file about a driver or a renderer: "llvmpipe.json", "egl-zink.json". A program's
// command line may be longer than a file system's names: of such a name the beginning is kept, with
// a digest of the whole.
std::string file_name_about(const std::string& name);

// True if a name of KnownFault::cases matches a case.
bool names_case(const std::string& name, const std::string& id);

// True if the fault accounts for one difference of an answer, or for a missing answer, regardless
// of the renderer and its release. `surface` is the case's. A cause fits if it is part of the
// difference's cause or, for coverage, of any cause that explains the primitive: which of these is
// reported depends on the run.
bool accounts_for(const KnownFault& fault, const std::string& id, const std::string& surface,
                  const Result& result, const DisagreementClass& d);
bool accounts_for(const KnownFault& fault, const std::string& id, const std::string& surface,
                  const Failure& failure);

// The faults that a renderer of this name and release may have.
std::vector<const KnownFault*> faults_of(const KnownFaults& known, const RendererInfo& info);

}  // namespace edgecase
