// SPDX-License-Identifier: MIT
//
// Fuzz: the endless search for disagreements.
//
//   families, corpus -> scenes -> {renderers, exact} -> suspects -> ledger -> candidates
//     -> minimize -> finds -> corpus
//
// Rounds of some hundred scenes are cut into pieces, which a few threads take, each with renderers
// of its own; what a round shows is judged, minimised and added to the corpus before the next one
// begins. So the same renderers, seed, corpus and number of scenes give the same finds, whatever
// the number of threads. A search that is ended by the clock ends between two pieces; what is
// left of its time goes to finds that are hard to read.
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
#include "search/find.h"
#include "search/minimize.h"
#include "search/scene_source.h"

namespace edgecase {

// One renderer that is searched.
struct FuzzRenderer {
  std::string name;                                 // as the command line names it
  std::function<std::unique_ptr<Renderer>()> make;  // a new one: each thread has its own
  Policy policy;                                    // of the exact side
  std::optional<Policy> profile;                    // what it is measured to follow
};

// Finds that are known beforehand.
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
  bool exhaustive = false;  // every scene of families that have an end; nothing is mutated
  KnownFinds known;
  Verdict least = Verdict::convention;  // of finds; failures always count
  // Whichever comes first; none: not at all.
  std::optional<std::size_t> count;  // scenes
  std::optional<std::size_t> finds;
  std::optional<std::chrono::milliseconds> time;
  MinimizeOptions minimize{1'500};
  int jobs = 1;                                       // threads, at least 1
  std::function<void(const FuzzProgress&)> progress;  // from any thread, one at a time; or empty
  const std::atomic<bool>* stop = nullptr;            // keeps what is found; or null
};

// How one renderer did.
struct FuzzedRenderer {
  RendererInfo info;
  std::size_t drawn = 0;           // scenes
  std::size_t not_drawn = 0;       // unsupported ones mostly
  std::size_t known = 0;           // finds that were known, met again
  std::optional<Failure> failure;  // of the first scene that was not drawn
};

struct FuzzReport {
  std::vector<FuzzedRenderer> renderers;         // in the order of those given
  std::size_t scenes = 0;                        // of which all renderers were asked
  std::map<std::string, std::size_t> by_family;  // kMutated among them
  // By renderer, worst first.
  std::vector<Find> finds;
  bool stopped = false;
};

// Throws what a renderer's `make` throws.
FuzzReport fuzz(const std::vector<FuzzRenderer>& renderers, const FuzzOptions& options);

}  // namespace edgecase
