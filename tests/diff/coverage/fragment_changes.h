// SPDX-License-Identifier: MIT
//
// Ways to spoil a list of fragments, of which mutants are made.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/diff/coverage/mutants.h"
#include "tests/diff/named_scenes.h"

namespace edgecase {

using Fragments = std::vector<Fragment>;
using Mutation = std::function<Rendering(const Scene&, const Rendering& exact)>;

// A mutation from a change to the list of fragments; hits and pixels follow.
template <class Change>
Mutation changed(Change change) {
  return [change](const Scene& scene, const Rendering& exact) {
    Fragments fragments = exact.fragments;
    change(scene, fragments);
    return compose(scene, std::move(fragments));
  };
}

// Every fragment by so many pixels, with the values that belong to its new place.
inline Mutation shifted(int dx, int dy) {
  return changed([=](const Scene& scene, Fragments& fragments) {
    for (Fragment& f : fragments) f = fragment_at(scene, f.primitive, f.x + dx, f.y + dy);
  });
}

// One more fragment of primitive 0.
inline void draw(const Scene& scene, Fragments& fragments, int x, int y) {
  fragments.push_back(fragment_at(scene, 0, x, y));
}

// The fragment of a line that lies first, or last, along the way from its first vertex.
Fragments::iterator end_of(const Scene& scene, Fragments& fragments, int primitive, bool last);

// The scene with every vertex moved, in pixels that are multiples of 2^-16.
Scene moved(Scene scene, double dx, double dy);

}  // namespace edgecase
