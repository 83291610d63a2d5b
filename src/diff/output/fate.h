// SPDX-License-Identifier: MIT
//
// Fate: what becomes of a sample of the target as fragments meet it one after another.
//
//   fragment -> alpha to coverage -> stencil test -> depth test -> blending -> colour mask -> write
//
// A state holds what exact stores and, beside it, all that may be stored. Where the outcome of a
// step is open, both are followed, and a sample has a set of states: it must agree with one of them
// in all planes at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "diff/coverage/vertex_latitude.h"
#include "diff/values/value_diff.h"
#include "exact/interval.h"
#include "model/fragment_operations.h"
#include "model/rendering.h"
#include "rules/choices.h"
#include "rules/output/blending.h"

namespace edgecase {

// ---------------------------------------------------------------------------------------- arrivals
//
// A renderer's own fragments as one sample of the target meets them, each with all that decides
// what becomes of it.

// Do these choices have all that lies between a fragment and the target as the specification has
// it, as far as it does not leave it open?
bool is_standard(const RuleChoices& choice);

struct Arrival {
  const Fragment* fragment = nullptr;
  const FragmentOperations* operations = nullptr;
  // As exact has them, and all that they may be; before conversion to the target's formats.
  std::array<double, 4> color{};
  std::array<Interval, 4> permitted_color{};
  double depth = 0;
  Interval permitted_depth;
  std::optional<double> told_depth;  // where the sample has the depth that the renderer told
  bool writes_depth = true;          // where the draw does
  bool front_facing = true;
  bool may_face_otherwise = false;
  // By alpha to coverage: as the choice has it, and as ruling 33 permits.
  bool is_kept = true;
  bool may_be_kept = true;
  bool may_be_dropped = false;
};

class Arrivals {
 public:
  explicit Arrivals(const ValueContext& context);

  // Of the fragments of a pixel, which are in drawing order, those that cover a sample.
  std::vector<Arrival> at(std::span<const Fragment> at_pixel, int sample,
                          const RuleChoices& choice) const;

 private:
  void set_depth(Arrival& arrival, int sample, const RuleChoices& choice) const;
  void set_depth_without_multisampling(Arrival& arrival) const;
  void set_facing(Arrival& arrival, const RuleChoices& choice) const;
  void set_kept(Arrival& arrival, std::span<const Fragment> at_pixel, int sample,
                const RuleChoices& choice) const;
  FacingLatitude facing_of(const Fragment& fragment) const;

  const ValueContext& context_;
  mutable std::vector<std::optional<FacingLatitude>> facings_;  // by primitive
};

// -------------------------------------------------------------------------------------------- fate

// What came of the last fragment.
enum class FateStep : unsigned char { none, dropped, stencil_failed, depth_failed, passed };

struct FateState {
  Rgba8 color{};
  Rgba8Range permitted_color{};
  double depth = 0;
  Interval permitted_depth;
  std::optional<double> source;  // what the depth was converted from, where that was told
  std::uint8_t stencil = 0;
  std::uint32_t hits = 0;
  bool blended = false;  // something that is stored came of blending
  FateStep last = FateStep::none;
};

// Which outcomes of a step are followed: the one that exact has, all that the specification
// permits, or any.
enum class FateScope : unsigned char { exact, permitted, any };

struct FateFreedom {
  FateScope depth_test = FateScope::exact;
  FateScope stencil_test = FateScope::exact;  // permits nothing else
  FateScope facing = FateScope::exact;
  FateScope alpha = FateScope::exact;
};
inline constexpr FateFreedom kAllPermitted{FateScope::permitted, FateScope::exact,
                                           FateScope::permitted, FateScope::permitted};

// More states than this are merged, those of equal stencil and hits into what holds them all.
inline constexpr std::size_t kMostStates = 64;

class Replay {
 public:
  // Refers to the target.
  Replay(const Target& target, const OutputChoice& output, FateFreedom freedom)
      : target_(target), output_(output), freedom_(freedom) {}

  FateState cleared() const;
  // What the states become by one more fragment.
  std::vector<FateState> after(const std::vector<FateState>& states, const Arrival& arrival) const;
  // From the clear values on. With no freedom, one state.
  std::vector<FateState> run(std::span<const Arrival> arrivals) const;

 private:
  struct Outcomes {
    bool pass = false;
    bool fail = false;
  };

  void add_after(const FateState& state, const Arrival& arrival,
                 std::vector<FateState>& next) const;
  void add_tested(const FateState& state, const Arrival& arrival, bool front_facing,
                  std::vector<FateState>& next) const;
  Outcomes stencil_outcomes(const FateState& state, const StencilFace& face) const;
  Outcomes depth_outcomes(const FateState& state, const Arrival& arrival) const;
  FateState written(FateState state, const Arrival& arrival) const;
  std::vector<FateState> written_depths(FateState state, const Arrival& arrival) const;
  bool compares_unconverted() const {
    return freedom_.depth_test == FateScope::permitted &&
           output_.depth == DepthTestMethod::unconverted;
  }

  const Target& target_;
  const OutputChoice output_;
  const FateFreedom freedom_;
};

// What a renderer says that a sample holds; a plane that it does not tell is left out.
struct StoredSample {
  const std::uint8_t* color = nullptr;  // 4 codes
  std::optional<double> depth;
  std::optional<std::uint8_t> stencil;
  std::optional<std::uint32_t> hits;
};

// The planes that are looked at.
struct FatePlanes {
  bool color = true;
  bool depth = true;
  bool stencil = true;
  bool hits = true;
};

// Is what is stored one of the things that the state permits?
bool agrees(const FateState& state, const StoredSample& stored, DepthFormat format,
            FatePlanes planes = {});
bool any_agrees(std::span<const FateState> states, const StoredSample& stored, DepthFormat format,
                FatePlanes planes = {});
// Is it what exact has?
bool has_color(const FateState& state, const StoredSample& stored);
bool is_exact(const FateState& state, const StoredSample& stored);

}  // namespace edgecase
