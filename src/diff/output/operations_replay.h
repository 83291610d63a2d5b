// SPDX-License-Identifier: MIT
//
// Replays the per-fragment operations: a sample of the target meets one fragment after another.
//
//   fragment -> facing, alpha to coverage -> rules/output/fragment_outcome.h
//
// A state has what exact stores and everything that may be stored. If the outcome of a step is
// open, both outcomes are followed, so a sample has a set of states: it must agree with one of them
// in all planes at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "diff/coverage/facing_latitude.h"
#include "diff/values/value_diff.h"
#include "exact/interval.h"
#include "model/rendering.h"
#include "rules/choices.h"
#include "rules/output/fragment_outcome.h"

namespace edgecase {

// ---------------------------------------------------------------------------------------- arrivals
//
// A renderer's own fragments in the order in which one sample of the target meets them, each with
// everything that decides its outcome.

// True if these choices follow the specification in everything between a fragment and the target,
// or choose what it leaves open.
bool is_standard(const RuleChoices& choice);

// What is asked of arrivals: what exact has, or also all that is permitted, which costs more than
// the rest.
enum class Tracked : unsigned char { exact, permitted };

struct Arrival {
  const Fragment* fragment = nullptr;
  const FragmentOperations* operations = nullptr;
  PermittedFragment values;  // a depth is `reported` if the sample has the one that was reported
  bool may_face_otherwise = false;
  bool is_unsampled = false;  // of a draw without GL_MULTISAMPLE, on a target of several samples
  // By alpha to coverage: under the choice, and as ruling 33 permits.
  bool is_kept = true;
  bool may_be_kept = true;
  bool may_be_dropped = false;
};

class Arrivals {
 public:
  explicit Arrivals(const ValueContext& context);

  // The fragments of a pixel, given in drawing order, that cover a sample. Valid until the next
  // call, which costs nothing if it asks for the same ones.
  const std::vector<Arrival>& at(std::span<const Fragment> at_pixel, int sample,
                                 const RuleChoices& choice, Tracked tracked) const;

 private:
  Arrival arrival_of(const Fragment& fragment, std::span<const Fragment> at_pixel, int sample,
                     const RuleChoices& choice, Tracked tracked) const;
  void set_depth(Arrival& arrival, int sample, const RuleChoices& choice, Tracked tracked) const;
  void set_depth_without_multisampling(Arrival& arrival, Tracked tracked) const;
  void set_facing(Arrival& arrival, const RuleChoices& choice) const;
  void set_kept(Arrival& arrival, std::span<const Fragment> at_pixel, int sample,
                const RuleChoices& choice) const;
  FacingLatitude facing_of(const Fragment& fragment) const;

  // What decides on the arrivals of a sample.
  struct Asked {
    const Fragment* first = nullptr;
    std::size_t fragments = 0;
    int sample = -1;
    MultisampleSwitch multisample_switch{};
    FacingMethod facing{};
    LocationChoice locations;
    AlphaToCoverage alpha{};
    Tracked tracked{};
    friend bool operator==(const Asked&, const Asked&) = default;
  };

  const ValueContext& context_;
  mutable std::vector<std::optional<FacingLatitude>> facings_;  // by primitive
  mutable Asked asked_;
  mutable std::vector<Arrival> answer_;  // to asked_
};

// ------------------------------------------------------------------------------------------ states

// Above this count, states of equal stencil and hits are merged into one that permits all they do.
inline constexpr std::size_t kMostStates = 64;

// The states after one more fragment.
std::vector<PermittedSample> states_after(const PermittedSample& state, const Arrival& arrival,
                                          const OutputRules& by);
// The states after all fragments, from the clear values on. With no freedom, one state.
std::vector<PermittedSample> replayed(std::span<const Arrival> arrivals, const OutputRules& by);

// Exact's outcome of one fragment. `sample` becomes what exact stores after it.
FragmentOutcome arrive(const Arrival& arrival, const OutputRules& by, ExactSample& sample);

// The contents of a sample as a renderer reports them; a plane that it does not report is left out.
struct StoredSample {
  const std::uint8_t* color = nullptr;  // 4 codes
  std::optional<double> depth;
  std::optional<std::uint8_t> stencil;
  std::optional<std::uint32_t> hits;
};

// The planes that are compared.
struct ComparedPlanes {
  bool color = true;
  bool depth = true;
  bool stencil = true;
  bool hits = true;
};

// True if the state permits what is stored.
bool agrees(const PermittedSample& state, const StoredSample& stored, DepthFormat format,
            ComparedPlanes planes = {});
bool any_agrees(std::span<const PermittedSample> states, const StoredSample& stored,
                DepthFormat format, ComparedPlanes planes = {});
// True if what is stored equals exact's.
bool has_color(const ExactSample& exact, const StoredSample& stored);
bool is_exact(const ExactSample& exact, const StoredSample& stored);

}  // namespace edgecase
