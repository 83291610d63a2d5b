// SPDX-License-Identifier: MIT
//
// Profile: the policy that a renderer is measured to follow, with the answers that say so.
//
// The cases of a suite are asked in rounds. In each, all answers together say which alternatives of
// a rule remain; those are what the next round compares with, until nothing changes. A renderer's
// claims play no part: one that reports 4 sub-pixel bits and rounds to 8 has 8 in its profile.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "model/case.h"
#include "model/policy.h"
#include "model/renderer.h"
#include "model/rendering.h"
#include "rules/rule_answers.h"
#include "suite/case_store.h"

namespace edgecase {

struct SurfaceProfile {
  Surface surface = Surface::fbo;
  std::size_t cases = 0;    // that were asked
  std::size_t drawn = 0;    // that were answered with a drawing
  std::size_t as_told = 0;  // drawings that are the policy's, but for inexact arithmetic
  std::string refusal;      // of the first case, by id, that was not drawn; otherwise empty
  // In the catalogue's order: the rules that were asked.
  std::vector<RuleAnswers> rules;
  // The same of the cases of one folder, "textures/bias": a renderer may look up with a bias
  // otherwise than with gradients.
  std::map<std::string, std::vector<RuleAnswers>> by_folder;
};

struct Profile {
  RendererInfo renderer;
  std::size_t rounds = 0;
  std::vector<SurfaceProfile> surfaces;  // those of the cases
  Policy policy;                         // the argument of `--policy`
};

struct MeasureOptions {
  std::string name;  // of the renderer, for the policy
  int jobs = 2;
  std::function<void(std::size_t done, std::size_t total)> progress;  // cases; from any thread
  const std::atomic<bool>* stop = nullptr;
};

using MakeRenderer = std::function<std::unique_ptr<Renderer>()>;

// Thrown by measure() once `stop` is true.
struct MeasurementStopped {};

// Of each rule at most this many cases that name it, evenly from all that are not large, on each
// surface: enough to tell what is followed, and few enough to wait for.
CaseStore cases_that_tell(const CaseStore& all, std::size_t of_each_rule);

// Asks every case in every round, each thread with a renderer of its own. Equal renderers and cases
// give equal profiles, whatever the number of threads.
Profile measure(const CaseStore& cases, const MakeRenderer& make_renderer,
                const MeasureOptions& options);

// Alternatives of the rules that the case names, and of those of coverage, that the renderer's
// drawing contradicts under a policy. All of a rule's, if it is drawn by none of them.
struct Contradiction {
  AlternativeSet against;
  bool is_as_told = false;  // nothing differs from the policy, but for inexact arithmetic
  // Alternatives of several rules that draw some primitive only together.
  std::set<Cause> together;
};
Contradiction contradiction_of(const Case& one, const Rendering& rendering, const Policy& policy,
                               const RendererInfo& info);

// At most ten lines: the renderer and the measurement; for each surface how many rules were asked,
// of which of them nothing is known, and how many answers are as told; then the rules that decide
// coverage.
std::string profile_summary(const Profile& profile);

// Per surface a table: of each rule what is followed, how many answers speak for it, and for what
// else; of those of which nothing is known, the same by folder of the suite.
std::string profile_tables(const Profile& profile);

// {"tool", "renderer", "rounds", "policy", "surfaces": [{"surface", "cases", "drawn", "as_told",
// "rules": [rule_answers.h's], "by_folder": {FOLDER: [...]}}]}, indented; equal profiles give
// equal bytes.
std::string profile_json(const Profile& profile, const std::string& tool);

// A file for casefile/policy_reader.h: the profile as a policy with OpenGL's latitude, and what was
// measured as its "why".
std::string policy_text(const Profile& profile);

}  // namespace edgecase
