// SPDX-License-Identifier: MIT
//
// Arrivals: a renderer's own fragments as one sample of the target meets them, each with all that
// decides what becomes of it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "diff/coverage/facing_latitude.h"
#include "diff/values/value_diff.h"
#include "exact/interval.h"
#include "model/fragment_operations.h"
#include "model/rendering.h"
#include "rules/choices.h"

namespace edgecase {

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

}  // namespace edgecase
