// SPDX-License-Identifier: MIT
//
// Digests by which a run finds out that nothing has changed: that its rules are those of another
// run, and that an answer, to the bit, has been compared before.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "model/case.h"
#include "model/renderer.h"
#include "model/rendering.h"
#include "run/profiles.h"

namespace edgecase {

// Of the text of the case's file, which neighbouring cases share: it is taken once for those that a
// thread asks for in turn. Valid until the thread's next call.
const std::string& digest_of_source(const Case& one);

// Everything besides the cases that decides on results: the policy, and the profiles of the
// renderers' releases. Profiles count under their own names, so that a recording has that of its
// renderer.
std::string digest_of(const Policy& policy, const Profiles& profiles,
                      const std::vector<RendererInfo>& renderers);

// Of a run under one policy, whose renderers have these profiles. Safe to use from several threads.
class AnswerDigests {
 public:
  // Both must live as long.
  AnswerDigests(const Policy& policy, const Profiles& profiles)
      : policy_(policy), profiles_(profiles) {}

  // A digest of a rendering and of all else that its comparison, and what results say of its case,
  // depend on: the sources of the program, the case's file, id and scene, the policy, the
  // renderer's profile and what a comparison knows of it beside that (RendererFacts). Its name and
  // release do not matter. Two comparisons with the same digest find the same. Never 0.
  // `outcome_digest`: Renderer::outcome_digest.
  std::uint64_t of(const Case& one, const Rendering& rendering, const RendererInfo& info,
                   std::uint64_t outcome_digest = 0);

 private:
  // Of the program and its rules, and of a profile, which may be null.
  const std::string& of_rules(const Policy* profile);

  const Policy& policy_;
  const Profiles& profiles_;
  std::mutex mutex_;
  std::map<const Policy*, std::string> of_rules_;  // by profile
};

}  // namespace edgecase
