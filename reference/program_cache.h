// SPDX-License-Identifier: MIT
//
// ProgramCache: which programs draw a scene. Those of scenes without textures and samples are there
// from the start, and the others are made for the first scene that needs them.
#pragma once

#include <map>
#include <string>

#include "model/scene.h"
#include "reference/programs.h"

namespace edgecase {

class ProgramCache {
 public:
  // The context must be current and outlive the cache.
  ProgramCache(const GladGLContext& gl, Programs plain) : gl_(gl), plain_(std::move(plain)) {}

  // Those of scenes without textures and samples.
  const Programs& plain() const { return plain_; }

  // Makes sure of all that a scene needs. `looks_up`: its textures count; `query`: as of
  // make_texture_programs. Returns why there are no such programs, as a sentence; empty: there are.
  std::string prepare(const Scene& scene, bool looks_up, bool query);
  // Those of a scene's draw, as prepared.
  const Programs& find(const Scene& scene, const Draw& draw, bool looks_up) const;

 private:
  std::string prepare_texture(const LookupForm& form, bool query);
  std::string prepare_sampled(AttributeLocation location);

  const GladGLContext& gl_;
  Programs plain_;
  std::map<LookupForm, Programs> texture_;
  std::map<AttributeLocation, Programs> sampled_;
};

}  // namespace edgecase
