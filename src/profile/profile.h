// SPDX-License-Identifier: MIT
//
// Profile: the policy that a renderer is measured to follow, with the evidence.
//
//   coverage -> clipping -> values -> textures -> multisampled targets -> fragment operations
//     -> counter-examples, clusters
//
// Traits are measured, regardless of a renderer's claims: one that reports 4 sub-pixel bits and
// rounds to 8 has 8 in its profile. Results that no combination of catalogued alternatives draws
// stay counter-examples, sorted into clusters with their smallest scenes; nothing is forced to fit.
#pragma once

#include <fmt/format.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/policy.h"
#include "model/renderer.h"
#include "model/scene.h"
#include "profile/evidence/findings.h"
#include "results/clusters.h"

namespace edgecase {

// Counter-examples that share a cause, or a rule and kind.
struct ProfileCluster {
  Cluster cluster;
  Scene smallest;
};

struct SurfaceProfile {
  Surface surface = Surface::fbo;
  std::string unavailable;  // why nothing could be measured; otherwise empty
  SurfaceFindings findings;
  std::size_t illegal_scenes = 0;        // with something outside the specification
  std::vector<ProfileCluster> clusters;  // of deviations from the profile, and of what is illegal
};

struct Profile {
  RendererInfo renderer;
  std::uint64_t seed = 1;
  std::size_t scenes_per_kind = 0;
  std::vector<SurfaceProfile> surfaces;
  Policy policy;  // the argument of `--policy`
};

struct MeasureOptions {
  std::string name;  // of the renderer, for the policy
  std::uint64_t seed = 1;
  std::size_t scenes_per_kind = 100;  // random scenes of each primitive type and surface
  // Of each as well; those are drawn that tell apart what the others do not.
  std::size_t searched_scenes = 20'000;
  std::vector<Surface> surfaces = {Surface::fbo, Surface::window};
  int jobs = 2;
  std::function<void(std::size_t done, std::size_t total)> progress;  // scenes; from any thread
  const std::atomic<bool>* stop = nullptr;
};

// Measures all surfaces in parallel, each with its own renderer. Equal renderers, seeds and numbers
// of scenes give equal profiles, whatever the number of threads. Throws MeasurementStopped once
// `stop` is true.
Profile measure(const MakeRenderer& make_renderer, const MeasureOptions& options);

// A profile as text for people, as JSON, and as a policy file.

// The renderer, then per surface: traits, tables of evidence, ownership tables, and clusters of
// counter-examples (at most `most_clusters` per surface, then the number of others).
std::string profile_text(const Profile& profile, std::size_t most_clusters);

// At most ten lines: the renderer and the measurement; for each surface how many traits hold in
// every scene, the three that are followed least, and what is outside the specification; then the
// rules that decide coverage.
std::string profile_summary(const Profile& profile);

// {"tool", "renderer", "seed", "scenes_per_kind", "policy", "surfaces": [{"surface", "traits",
// "tables", "clusters", …}]}, indented; equal profiles give equal bytes. The smallest scene of a
// cluster is the text of a case file if one can express it. NaN and infinity are null.
std::string profile_json(const Profile& profile, const std::string& tool);

// A file for casefile/policy_reader.h: the profile as a policy with OpenGL's latitude, and the
// measured rates as its "why".
std::string policy_text(const Profile& profile);

// Parts of the text: tables, each line with its worst scenes. Empty if nothing was measured.
std::string value_errors_text(std::span<const ValueErrors> rows);
std::string level_residuals_text(std::span<const LevelResiduals> rows);
std::string sample_profile_text(const SampleProfile& samples);
std::string output_profile_text(const OutputProfile& output);

// The lines of a text under construction.
using Buffer = fmt::memory_buffer;
template <class... Args>
void print(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}
// What is said of a trait: the alternative that yields at least nine in ten of what was asked, with
// its share, though it may not yield all; else kNoneKnown with the share of the closest. A trait
// that is no alternative is said as it is.
struct ToldTrait {
  std::string alternative;
  Rate rate;
};
inline constexpr const char* kNoneKnown = "none known";
ToldTrait told(const Trait& trait);

// "8 sub-pixel bits are reported".
std::string words_of_bits(const RendererInfo& renderer);
void print_renderer(Buffer& out, const Profile& profile);  // the first line of both texts

// The same parts of the JSON.
nlohmann::ordered_json value_errors_json(std::span<const ValueErrors> rows);
nlohmann::ordered_json level_residuals_json(std::span<const LevelResiduals> rows);
nlohmann::ordered_json sample_profile_json(const SampleProfile& samples);
nlohmann::ordered_json output_profile_json(const OutputProfile& output);

}  // namespace edgecase
