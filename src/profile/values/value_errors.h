// SPDX-License-Identifier: MIT
//
// Value errors: how far the values of a renderer's fragments are from the exact ones, by primitive
// type and mode. Nothing hides in an average: a histogram, the two largest errors with their
// scenes, and what is beyond ruling 9 stand beside it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exact/interval.h"
#include "exact/pixel.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "profile/values/value_scenes.h"
#include "rules/choices.h"

namespace edgecase {

// What of a fragment is compared.
enum class ValueKind { color, depth, inverse_w };

// One component of one fragment that errs.
struct ValueExample {
  std::string id;  // of the scene that it was found in: "triangle smooth/00042"
  Scene scene;     // that scene, or its primitive alone where that shows the same
  int primitive = 0;
  PixelPosition pixel;
  int component = 0;  // of a colour; 0 otherwise
  double exact = 0;   // the double nearest to it
  double rendered = 0;
  double ulp = 0;       // error in distances of neighbouring float32 numbers at the exact value
  double relative = 0;  // error as a share of the range over the primitive's vertices
  // What ruling 9 allows, where it was asked.
  std::optional<Interval> permitted;
};

struct ValueErrors {
  std::string attribute;  // "triangle smooth", "line depth", …
  ValueKind kind = ValueKind::color;
  // Exact by OpenGL's own rules, or by those that the renderer is found to follow instead.
  bool as_found = false;
  std::size_t fragments = 0;
  std::size_t components = 0;   // for which exact is a number
  std::size_t correct = 0;      // components that are correctly rounded
  std::size_t not_numbers = 0;  // NaN and infinity: in no other figure but `beyond`
  double ulp_sum = 0;
  std::map<int, std::size_t> histogram;  // of those not correctly rounded, by floor(log2(ULP))
  std::size_t beyond = 0;                // components outside ruling 9 (as_found: not asked)
  // Components of triangles for which that was not asked: where very many are far off, the search
  // over all moves of the vertices is made for some of them only.
  std::size_t not_asked = 0;
  std::size_t searches = 0;
  std::optional<ValueExample> worst_ulp;
  std::optional<ValueExample> worst_relative;
  std::optional<ValueExample> smallest_beyond;  // least target, then least primitive

  double mean_ulp() const;
  // The least power of two, 2^n ULP, below which the errors of so large a share of the numbers lie;
  // none where that many are correctly rounded.
  std::optional<int> log2_bound(double share) const;
};

// Counts the errors of one surface.
class ValueErrorTable {
 public:
  // `found`: what the renderer was found to follow. `bits`: as in ruling 4.
  ValueErrorTable(const RuleChoices& found, int bits);

  // The rendering of one scene of a mode.
  void add(const ValueMode& mode, const std::string& id, const Scene& scene,
           const Rendering& rendering);

  // In the order in which modes were added.
  std::vector<ValueErrors>& rows() { return rows_; }

 private:
  ValueErrors& row(const std::string& attribute, ValueKind kind, bool as_found);

  RuleChoices lawful_;
  RuleChoices found_;
  int bits_;
  std::vector<ValueErrors> rows_;
};

// What a fragment tells; nothing where it does not.
std::optional<double> told(const Rendering& rendering, const Fragment& fragment, ValueKind kind,
                           int component);

}  // namespace edgecase
