// SPDX-License-Identifier: MIT
//
// Replays the per-fragment operations: a sample of the target meets one fragment after another.
//
//   fragment -> alpha to coverage -> stencil test -> depth test -> blending -> colour mask -> write
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
#include <utility>
#include <vector>

#include "diff/coverage/facing_latitude.h"
#include "diff/values/value_diff.h"
#include "exact/interval.h"
#include "model/fragment_operations.h"
#include "model/rendering.h"
#include "rules/choices.h"
#include "rules/output/blending.h"

namespace edgecase {

// ---------------------------------------------------------------------------------------- arrivals
//
// A renderer's own fragments in the order in which one sample of the target meets them, each with
// everything that decides its outcome.

// True if these choices follow the specification in everything between a fragment and the target,
// or choose what it leaves open.
bool is_standard(const RuleChoices& choice);

// What a replay keeps: what exact has, or also everything that is permitted, which costs more than
// the rest.
enum class Tracked : unsigned char { exact, permitted };

struct Arrival {
  const Fragment* fragment = nullptr;
  const FragmentOperations* operations = nullptr;
  // What exact has, and all that is permitted, if that is tracked; before conversion to the
  // target's formats.
  std::array<double, 4> color{};
  std::array<Interval, 4> permitted_color{};
  double depth = 0;
  Interval permitted_depth;
  std::optional<double> reported_depth;  // if the sample has the depth that the renderer reported
  bool writes_depth = true;              // if the draw does
  bool front_facing = true;
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

// The outcome of the last fragment.
enum class OperationsStep : unsigned char { none, dropped, stencil_failed, depth_failed, passed };

struct SampleState {
  Rgba8 color{};
  Rgba8Range permitted_color{};  // this and the next: if the permitted is tracked
  Interval permitted_depth;
  double depth = 0;
  std::optional<double> source;  // the depth before conversion, if it was reported
  std::uint8_t stencil = 0;
  std::uint32_t hits = 0;
  bool blended = false;  // something that is stored is the result of blending
  OperationsStep last = OperationsStep::none;
  // Under StencilMethod::once_a_draw: the draw that changed the stencil value last.
  const FragmentOperations* operated = nullptr;
};

// The outcomes of a step that are followed: exact's, all that the specification permits, or any.
enum class OutcomeScope : unsigned char { exact, permitted, any };

struct OperationsFreedom {
  OutcomeScope depth_test = OutcomeScope::exact;
  OutcomeScope stencil_test = OutcomeScope::exact;  // no other is permitted
  OutcomeScope facing = OutcomeScope::exact;
  OutcomeScope alpha = OutcomeScope::exact;
};
inline constexpr OperationsFreedom kAllPermitted{OutcomeScope::permitted, OutcomeScope::exact,
                                                 OutcomeScope::permitted, OutcomeScope::permitted};

// Above this count, states of equal stencil and hits are merged into one that permits all they do.
inline constexpr std::size_t kMostStates = 64;

class Replay {
 public:
  // Keeps a reference to the target. `tracked`: that of the arrivals, or less; a replay with any
  // freedom needs all.
  Replay(const Target& target, const OutputChoice& output, OperationsFreedom freedom,
         Tracked tracked = Tracked::permitted)
      : target_(target), output_(output), freedom_(freedom), tracked_(tracked) {}

  SampleState cleared() const;
  // The states after one more fragment.
  std::vector<SampleState> after(std::vector<SampleState> states, const Arrival& arrival) const;
  // The states after all fragments, from the clear values on. With no freedom, one state.
  std::vector<SampleState> run(std::span<const Arrival> arrivals) const;
  // The state after one more fragment that has passed all tests, which leaves its stencil value.
  SampleState written(SampleState state, const Arrival& arrival) const;

 private:
  struct Outcomes {
    bool pass = false;
    bool fail = false;
  };

  void add_after(const SampleState& state, const Arrival& arrival,
                 std::vector<SampleState>& next) const;
  void add_tested(const SampleState& state, const Arrival& arrival, bool front_facing,
                  std::vector<SampleState>& next) const;
  Outcomes stencil_outcomes(const SampleState& state, const StencilFace& face) const;
  Outcomes depth_outcomes(const SampleState& state, const Arrival& arrival) const;
  void step(std::vector<SampleState>& states, const Arrival& arrival,
            std::vector<SampleState>& next) const;
  void set_permitted_color(const Arrival& arrival, SampleState& state) const;
  bool has_either_depth(const SampleState& state, const Arrival& arrival) const;
  bool compares_unconverted() const {
    return freedom_.depth_test == OutcomeScope::permitted &&
           output_.depth == DepthTestMethod::unconverted;
  }

  const Target& target_;
  const OutputChoice output_;
  const OperationsFreedom freedom_;
  const Tracked tracked_;
};

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
bool agrees(const SampleState& state, const StoredSample& stored, DepthFormat format,
            ComparedPlanes planes = {});
bool any_agrees(std::span<const SampleState> states, const StoredSample& stored, DepthFormat format,
                ComparedPlanes planes = {});
// True if what is stored equals exact's.
bool has_color(const SampleState& state, const StoredSample& stored);
bool is_exact(const SampleState& state, const StoredSample& stored);

}  // namespace edgecase
