// SPDX-License-Identifier: MIT
//
// ProgramCache: chooses the programs for a scene. Those for scenes without textures and samples
// exist from the start; others are made for the first scene that needs them.
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

  // The programs for scenes without textures and samples.
  const Programs& plain() const { return plain_; }

  // Makes the programs that a scene needs. `looks_up`: whether its textures matter; `query`: as for
  // make_texture_programs. Returns why there are none, as a sentence; empty on success.
  std::string prepare(const Scene& scene, bool looks_up, bool query);
  // The programs for a scene's draw, after prepare.
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
