// SPDX-License-Identifier: MIT
#include "profile/coverage/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "generate/random_scenes.h"
#include "profile/evidence/inference.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

constexpr std::array kKinds = {PrimitiveKind::point, PrimitiveKind::triangle, PrimitiveKind::line};
// Shares of the number of random scenes of a kind.
constexpr std::size_t kWideLineShare = 10;
constexpr std::size_t kSharedEdgeShare = 4;
// How many scenes tell the inferred choice and a rival apart, if there are so many, and how often
// they are chosen anew by what the renderer drew of the last.
constexpr std::size_t kTellingScenes = 8;
constexpr int kTellingRounds = 6;

using Observations = std::vector<Observation>;

template <class MakeScene>
Observations observations_of(std::size_t count, const std::string& family, MakeScene make) {
  Observations result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i].id = scene_id(family, i);
    result[i].scene = make(i);
  }
  return result;
}

template <class Probe>
Observations observations_of(const std::vector<Probe>& probes, const std::string& family) {
  return observations_of(probes.size(), family, [&](std::size_t i) { return probes[i].scene; });
}

// All scenes for measuring coverage.
struct CoverageScenes {
  std::vector<DiamondProbe> diamonds;
  std::vector<EdgeProbe> edges;
  std::vector<JointProbe> joints;
  std::vector<SharedEdgeProbe> shared_edges;
  std::vector<ClipProbe> clips;

  std::array<Observations, 3> random;  // in the order of kKinds
  Observations wide_lines;
  Observations random_shared_edges;
  Observations seen_diamonds;
  Observations seen_edges;
  Observations seen_joints;
  Observations seen_shared_edges;
  Observations seen_clips;
  Observations seen_unclipped;

  explicit CoverageScenes(const Question& question)
      : diamonds(diamond_probes(question.surface)),
        edges(edge_probes(question.surface)),
        joints(joint_probes(question.surface)),
        shared_edges(shared_edge_probes(question.surface)),
        clips(clip_probes(question.surface)) {
    const std::uint64_t seed = question.seed;
    const Surface surface = question.surface;
    const std::size_t count = question.scenes_per_kind;
    for (std::size_t k = 0; k < kKinds.size(); ++k)
      random[k] = observations_of(count, name_of(kKinds[k]), [&](std::size_t i) {
        return random_scene({seed, kKinds[k], surface}, i);
      });
    wide_lines = observations_of(count / kWideLineShare, "wide-line",
                                 [&](std::size_t i) { return random_wide_line(seed, surface, i); });
    random_shared_edges =
        observations_of(count / kSharedEdgeShare, "shared-edge",
                        [&](std::size_t i) { return shared_edge_scene(seed, surface, i); });
    seen_diamonds = observations_of(diamonds, "diamond-probe");
    seen_edges = observations_of(edges, "edge-probe");
    seen_joints = observations_of(joints, "joint-probe");
    seen_shared_edges = observations_of(shared_edges, "shared-edge-probe");
    seen_clips = observations_of(clips, "clip-probe");
    seen_unclipped = observations_of(clips.size(), "unclipped-probe",
                                     [&](std::size_t i) { return clips[i].unclipped; });
  }

  // Clipping is a trait of its own: what it moves is no counter-example.
  std::vector<Observations*> unclipped() {
    std::vector<Observations*> result;
    for (Observations& observations : random) result.push_back(&observations);
    for (Observations* observations : {&wide_lines, &random_shared_edges, &seen_diamonds,
                                       &seen_edges, &seen_joints, &seen_shared_edges})
      result.push_back(observations);
    return result;
  }
  std::vector<Observations*> all() {
    std::vector<Observations*> result = unclipped();
    result.push_back(&seen_clips);
    result.push_back(&seen_unclipped);
    return result;
  }
};

bool is_one_primitive(const Draw& draw) {
  return draw.vertices.size() == static_cast<std::size_t>(vertices_of(kind_of(draw.primitive)));
}

// What is inferred, beside each other alternative of one rule and what was as good, and which
// scenes tell the two apart.
class Rivals {
 public:
  Rivals(PrimitiveKind kind, const Inference& inference) : own_(inference.choice.of(kind)) {
    for (const InferredRule& rule : inference.rules)
      for (const RuleChoices& other : choices_by_alternative(inference.choice, rule.rule))
        add(other.of(kind));
    for (const RuleChoices& other : inference.equals) add(other.of(kind));
  }

  bool are_told() const {
    return std::ranges::all_of(rivals_,
                               [](const Rival& rival) { return rival.told >= kTellingScenes; });
  }
  // Whether the scene, of one primitive, tells a rival that has not been told often enough.
  bool tells(const Scene& scene) {
    const auto primitives = primitives_of(scene);
    const auto own = covered_pixels(primitives[0], scene.target, own_);
    bool is_telling = false;
    for (Rival& rival : rivals_) {
      if (rival.told >= kTellingScenes) continue;
      if (covered_pixels(primitives[0], scene.target, rival.choice) == own) continue;
      ++rival.told;
      is_telling = true;
    }
    return is_telling;
  }

 private:
  struct Rival {
    CoverageChoice choice;
    std::size_t told = 0;
  };

  void add(const CoverageChoice& choice) {
    const auto is_it = [&](const Rival& rival) { return rival.choice == choice; };
    if (choice != own_ && std::ranges::none_of(rivals_, is_it)) rivals_.push_back({choice});
  }

  CoverageChoice own_;
  std::vector<Rival> rivals_;
};

class CoverageMeasurement {
 public:
  CoverageMeasurement(const Question& question, SceneDrawing& drawing, SurfaceFindings& findings)
      : question_(question),
        surface_(question.surface),
        scenes_(question),
        drawing_(drawing),
        findings_(findings) {}

  void run() {
    for (Observations* observations : scenes_.all()) drawing_.observe(*observations);
    infer_choices();
    for (const Observations& observations : scenes_.random) {
      findings_.random_scenes += observations.size();
      findings_.with_ties += static_cast<std::size_t>(std::ranges::count_if(
          observations, [](const Observation& one) { return has_tie(one.scene); }));
    }
    ask_probes();
    ask_provoking();
    for (Observations* observations : scenes_.unclipped())
      findings_.observations.push_back(std::move(*observations));
  }

 private:
  void adopt(const Inference& inference) {
    for (const InferredRule& rule : inference.rules)
      findings_.adopt(
          {rule.rule, rule.alternative, rule.rate, rule.runner_up, rule.runner_up_rate});
  }

  // The evidence for a kind of primitive: the random scenes, and clip probes inside a large
  // viewport, the only ones with vertices left of and below the target.
  std::vector<const Observation*> scenes_for(PrimitiveKind kind) const {
    std::vector<const Observation*> result;
    for (std::size_t k = 0; k < kKinds.size(); ++k)
      if (kKinds[k] == kind)
        for (const Observation& observation : scenes_.random[k]) result.push_back(&observation);
    for (const Observation& observation : scenes_.seen_unclipped) {
      const Draw& draw = observation.scene.draws[0];
      const bool plain = draw.line_width == Fixed::from_integer(1);
      if (kind_of(draw.primitive) == kind && plain && observation.scene.draws.size() == 1 &&
          is_one_primitive(draw))
        result.push_back(&observation);
    }
    return result;
  }

  // Random scenes beside those that were drawn, in which the choice and a rival of it draw
  // otherwise than each other; none if all that can be told is.
  Observations telling_scenes(std::size_t k, const Inference& inference) {
    Rivals rivals(kKinds[k], inference);
    for (const Observation& seen : scenes_.random[k])
      if (seen.failure.empty()) rivals.tells(seen.scene);
    Observations telling;
    for (std::size_t i = question_.scenes_per_kind;
         i < question_.searched_scenes && !rivals.are_told(); ++i) {
      if (are_telling_[k].contains(i)) continue;
      Scene scene = random_scene({question_.seed, kKinds[k], surface_}, i);
      if (!rivals.tells(scene)) continue;
      are_telling_[k].insert(i);
      telling.push_back({scene_id(name_of(kKinds[k]), i), std::move(scene), {}, {}, {}, {}});
    }
    drawing_.observe(telling);
    return telling;
  }

  // Draws more scenes until none is left that could tell more.
  Inference infer_from(std::size_t k) {
    Inference inference;
    for (int round = 0;; ++round) {
      inference = infer({kKinds[k], findings_.found, OpenRules::coverage}, scenes_for(kKinds[k]));
      if (round == kTellingRounds) return inference;
      Observations telling = telling_scenes(k, inference);
      if (telling.empty()) return inference;
      std::ranges::move(telling, std::back_inserter(scenes_.random[k]));
    }
  }

  void infer_choices() {
    for (std::size_t k = 0; k < kKinds.size(); ++k) {
      CoverageChoice& choice = kKinds[k] == PrimitiveKind::point  ? findings_.found.points
                               : kKinds[k] == PrimitiveKind::line ? findings_.found.lines
                                                                  : findings_.found.triangles;
      // Lines that are areas decide ties like triangles.
      if (kKinds[k] == PrimitiveKind::line) choice.ties = findings_.found.triangles.ties;
      const Inference inference = infer_from(k);
      choice = inference.choice.of(kKinds[k]);
      adopt(inference);
    }
    std::vector<const Observation*> wide_lines;
    for (const Observation& observation : scenes_.wide_lines) wide_lines.push_back(&observation);
    const Inference wide =
        infer({PrimitiveKind::line, findings_.found, OpenRules::width}, wide_lines);
    findings_.found.lines = wide.choice.lines;
    adopt(wide);
  }

  void add(std::vector<Trait> traits) {
    std::move(traits.begin(), traits.end(), std::back_inserter(findings_.traits));
  }
  void add(std::vector<OwnershipTable> tables) {
    std::move(tables.begin(), tables.end(), std::back_inserter(findings_.tables));
  }

  void ask_probes() {
    const Seen<DiamondProbe> diamonds{scenes_.diamonds, scenes_.seen_diamonds};
    add({diamond_trait(diamonds, findings_.found.lines)});
    add(diamond_tables(diamonds));
    const Seen<EdgeProbe> edges{scenes_.edges, scenes_.seen_edges};
    add({edge_trait(edges, findings_.found.triangles)});
    add(edge_tables(edges));
    add(joint_traits({scenes_.joints, scenes_.seen_joints}, findings_.found.lines));
    std::vector<const Observation*> shared;
    for (const Observations* observations :
         {&scenes_.seen_shared_edges, &scenes_.random_shared_edges})
      for (const Observation& observation : *observations) shared.push_back(&observation);
    add({shared_edge_trait(shared, drawing_.latitude_bits())});
    add(clip_traits({scenes_.clips, scenes_.seen_clips}, scenes_.seen_unclipped));
  }

  void ask_provoking() {
    const std::vector<Scene> scenes = provoking_probes(surface_);
    std::vector<std::optional<Rendering>> renderings(scenes.size());
    drawing_.draw(
        "probe", scenes,
        [&](std::size_t i, Rendering rendering) { renderings[i] = std::move(rendering); },
        Counted::nothing);
    const Trait trait = provoking_trait(scenes, renderings);
    findings_.traits.push_back(trait);
    if (trait.alternative != name_of(ProvokingChoice::as_set))
      findings_.choices[name_of(trait.id.rule)] = trait.alternative;
    parse_name(trait.alternative, findings_.found.values.provoking);
  }

  const Question& question_;
  Surface surface_;
  CoverageScenes scenes_;
  std::array<std::set<std::size_t>, 3> are_telling_;  // indices of the random scenes drawn beside
  SceneDrawing& drawing_;
  SurfaceFindings& findings_;
};

std::size_t scene_count(std::size_t scenes_per_kind) {
  return kKinds.size() * scenes_per_kind + scenes_per_kind / kWideLineShare +
         scenes_per_kind / kSharedEdgeShare + diamond_probes(Surface::fbo).size() +
         edge_probes(Surface::fbo).size() + joint_probes(Surface::fbo).size() +
         shared_edge_probes(Surface::fbo).size() + 2 * clip_probes(Surface::fbo).size();
}

}  // namespace

const Subject kCoverageSubject{
    scene_count, [](const Question& question, SceneDrawing& drawing, SurfaceFindings& findings) {
      CoverageMeasurement(question, drawing, findings).run();
    }};

}  // namespace edgecase
