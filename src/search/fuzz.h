// SPDX-License-Identifier: MIT
//
// Fuzz: the endless search for disagreements.
//
//   families, corpus -> scenes -> {renderers, exact} -> suspects -> ledger -> candidates
//     -> minimize -> finds -> corpus
//
// Rounds of some hundred scenes are cut into pieces, which a few threads take, each with its own
// renderers. The results of a round are judged, minimized and added to the corpus before the next
// one begins, so equal renderers, seed, corpus and number of scenes give equal finds, whatever the
// number of threads. A search with a time limit ends between two pieces and uses the rest of its
// time for finds that are hard to read.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/policy.h"
#include "model/renderer.h"
#include "run/profiles.h"
#include "search/families.h"
#include "search/find.h"
#include "search/minimize.h"
#include "search/scene_source.h"

namespace edgecase {

// One renderer to search.
struct FuzzRenderer {
  std::string name;                                 // as on the command line
  std::function<std::unique_ptr<Renderer>()> make;  // makes one for each thread
  Policy policy;                                    // of the exact side
  ReleaseProfiles profiles;                         // what it is measured to follow
};

// Finds that are known in advance.
struct KnownFinds {
  std::map<std::string, std::vector<FindKey>> keys;  // by renderer
  std::vector<Scene> scenes;                         // whatever they show is known
};

struct FuzzProgress {
  std::size_t scenes = 0;
  std::map<Verdict, std::size_t> finds;
};

struct FuzzOptions {
  std::uint64_t seed = 1;
  std::vector<const Family*> families;
  std::vector<Surface> surfaces = {Surface::fbo, Surface::window};
  std::vector<CorpusScene> corpus;
  bool exhaustive = false;  // every scene of finite families; nothing is mutated
  KnownFinds known;
  Verdict least = Verdict::convention;  // of finds; failures always count
  // Limits, whichever comes first; nothing: no limit.
  std::optional<std::size_t> count;  // scenes
  std::optional<std::size_t> finds;
  std::optional<std::chrono::milliseconds> time;
  MinimizeOptions minimize{1'500};
  int jobs = 1;                                       // threads, at least 1
  std::function<void(const FuzzProgress&)> progress;  // from any thread, one at a time; or empty
  const std::atomic<bool>* stop = nullptr;            // ends the search, keeping its finds; or null
};

// The statistics of one renderer.
struct FuzzedRenderer {
  RendererInfo info;
  std::size_t drawn = 0;           // scenes
  std::size_t not_drawn = 0;       // mostly unsupported ones
  std::size_t known = 0;           // known finds that were met again
  std::optional<Failure> failure;  // of the first scene that was not drawn
};

struct FuzzReport {
  std::vector<FuzzedRenderer> renderers;         // in the given order
  std::size_t scenes = 0;                        // rendered by all renderers
  std::map<std::string, std::size_t> by_family;  // including kMutated
  // By renderer, worst first.
  std::vector<Find> finds;
  bool stopped = false;
};

// Throws what a renderer's `make` throws.
FuzzReport fuzz(const std::vector<FuzzRenderer>& renderers, const FuzzOptions& options);

}  // namespace edgecase
