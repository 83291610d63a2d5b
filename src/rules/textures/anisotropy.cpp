// SPDX-License-Identifier: MIT
#include "rules/textures/anisotropy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/elementary.h"
#include "rules/textures/directed.h"

namespace edgecase {
namespace {

struct Axes {
  bool along_x;  // true if the vector along x is the longer one
  Interval longer;
  Interval shorter;
};

double middle(Interval value) {
  return std::isinf(value.high) ? value.high : value.low + (value.high - value.low) / 2;
}

Axes axes_of(const Footprint& footprint) {
  const auto [x, y] = lengths(footprint);
  if (middle(x) > middle(y)) return {true, x, y};
  return {false, y, x};
}

Interval divided(Interval value, double by) {
  return {Down::quotient(value.low, by), Up::quotient(value.high, by)};
}

// The number of lookups: a whole number of at least 1, even if max_anisotropy is NaN.
int probe_count(const Axes& axes, float max_anisotropy) {
  const double longer = middle(axes.longer);
  const double shorter = middle(axes.shorter);
  const double most = std::floor(static_cast<double>(max_anisotropy));
  if (longer == shorter) return 1;
  return static_cast<int>(std::min(std::ceil(longer / shorter), most));
}

ProbeRow equal_probes(const Axes& axes, float max_anisotropy) {
  const int count = probe_count(axes, max_anisotropy);
  ProbeRow row{axes.along_x, divided(axes.longer, count), {}};
  for (int i = 1; i <= count; ++i)
    row.probes.push_back({static_cast<double>(i) / (count + 1) - 0.5, divided(1, count)});
  return row;
}

ProbeRow gaussian_probes(const Axes& axes) {
  constexpr int kCount = 5;
  const Interval fifth = divided(axes.longer, kCount);
  ProbeRow row{axes.along_x,
               {std::max(axes.shorter.low, fifth.low), std::max(axes.shorter.high, fifth.high)},
               {}};
  Interval sum = 0;
  for (int i = -2; i <= 2; ++i) {
    const Interval weight = around(exponential(-8.0 * i * i / (kCount * kCount)), kPlacesOfLibrary);
    row.probes.push_back({static_cast<double>(i) / kCount, weight});
    sum = sum + weight;
  }
  for (Probe& probe : row.probes) probe.weight = probe.weight / sum;
  return row;
}

}  // namespace

ProbeRow probes(const Footprint& footprint, float max_anisotropy, Anisotropy choice,
                ScaleFactor isotropic) {
  if (choice == Anisotropy::none || !(max_anisotropy > 1))
    return {.scale_factor = scale_factor(footprint, isotropic), .probes = {{0, 1}}};
  const Axes axes = axes_of(footprint);
  return choice == Anisotropy::extension ? equal_probes(axes, max_anisotropy)
                                         : gaussian_probes(axes);
}

Rule anisotropy_rule() {
  Rule rule;
  rule.id = RuleId::texture_anisotropy;
  rule.title = "Anisotropic filters look up several times along the longer vector of a footprint";
  rule.spec = "8.14.1, with EXT_texture_filter_anisotropic";
  rule.latitude = "the implementation chooses the method, on levels that it may use (ruling 23)";
  rule.standard = "extension";
  rule.alternatives = alternatives_of<Anisotropy>();
  rule.rulings = {
      {23,
       "Anisotropy: the maximum that a sampler sets is a request, and the method an example; the "
       "catalogued method that comes closest is reported. Any method may access mip levels only "
       "if the minification filter uses them, and none outside base_level to max_level (8.14). "
       "So if the maximum is more than 1, a level accessed is one of these levels, and if each "
       "of them has one colour, each component of the result lies between the least and the "
       "largest of them; lambda' may be anything."},
      {57,
       "Anisotropy: a component beyond the least and the largest of the texels that a filter may "
       "access is contested where levels are of many colours: no mean leads there, but filters "
       "with negative weights do, and the scheme is the implementation's (8.14)."}};
  return rule;
}

}  // namespace edgecase
