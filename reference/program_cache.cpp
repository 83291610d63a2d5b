// SPDX-License-Identifier: MIT
#include "reference/program_cache.h"

#include <utility>
#include <variant>

namespace edgecase {

namespace {

LookupForm form_of(const Scene& scene, const Draw& draw) {
  if (!draw.texture) return {};
  return {scene.textures[draw.texture->texture]->dimensions, draw.texture->lookup.kind};
}

// Keeps what was made, or returns why it was not.
template <class Key>
std::string keep(std::map<Key, Programs>& programs, const Key& key,
                 std::variant<Programs, ProgramError> made) {
  if (const auto* error = std::get_if<ProgramError>(&made)) return error->message;
  programs.emplace(key, std::get<Programs>(std::move(made)));
  return "";
}

}  // namespace

std::string ProgramCache::prepare(const Scene& scene, bool looks_up, bool query) {
  for (const Draw& draw : scene.draws) {
    std::string problem;
    if (scene.target.samples > 1)
      problem = prepare_sampled(draw.multisampling.location);
    else if (looks_up)
      problem = prepare_texture(form_of(scene, draw), query);
    if (!problem.empty()) return problem;
  }
  return "";
}

std::string ProgramCache::prepare_texture(const LookupForm& form, bool query) {
  if (texture_.count(form) > 0) return "";
  return keep(texture_, form, make_texture_programs(gl_, form, query));
}

std::string ProgramCache::prepare_sampled(AttributeLocation location) {
  if (sampled_.count(location) > 0) return "";
  return keep(sampled_, location, make_sampled_programs(gl_, location));
}

const Programs& ProgramCache::find(const Scene& scene, const Draw& draw, bool looks_up) const {
  if (scene.target.samples > 1) return sampled_.at(draw.multisampling.location);
  return looks_up ? texture_.at(form_of(scene, draw)) : plain_;
}

}  // namespace edgecase
