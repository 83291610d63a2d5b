// SPDX-License-Identifier: MIT
#include "run/separation.h"

#include <algorithm>
#include <vector>

#include "model/policy.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

constexpr const char* kCoverageRules[] = {
    "point.ownership",    "point.offset",       "point.snap",         "point.row-order",
    "line.algorithm",     "line.diamond-exit",  "line.width",         "line.snap",
    "line.row-order",     "triangle.algorithm", "triangle.fill-rule", "triangle.snap",
    "triangle.row-order", "line.multisampled",  "sample.positions",   "sample.enable",
    "sample.mask",        "clip.volume",        "polygon.facing"};

// What is drawn of a scene.
struct Drawn {
  std::vector<SampleCoverage> covered;  // by each primitive
  std::vector<double> depths;           // of samples, where a draw does without GL_MULTISAMPLE
  friend bool operator==(const Drawn&, const Drawn&) = default;
};

bool is_switched_off(const Scene& scene) {
  return scene.target.samples > 1 && std::ranges::any_of(scene.draws, [](const Draw& draw) {
           return !draw.multisampling.enabled;
         });
}

Drawn drawn_under(const Scene& scene, const Policy& policy) {
  const RuleChoices choices = resolve(policy, scene.target.surface);
  Drawn drawn;
  for (const ScenePrimitive& primitive : primitives_of(scene))
    drawn.covered.push_back(
        covered_samples(primitive, scene.target, choices.of(primitive.kind), SamplePositions{}));
  if (is_switched_off(scene)) drawn.depths = rasterize(scene, policy).depths;
  return drawn;
}

Policy policy_with(const std::string& rule, const std::string& alternative) {
  Policy policy;
  policy.rules[rule] = alternative;
  return policy;
}

void count_case(const Scene& scene, SeparationMatrix& matrix) {
  std::vector<Drawn> drawn;
  for (const std::string& alternative : matrix.alternatives)
    drawn.push_back(drawn_under(scene, policy_with(matrix.rule, alternative)));
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t j = 0; j < drawn.size(); ++j)
      if (drawn[i] != drawn[j]) ++matrix.cases[i][j];
}

bool has_tie(const Scene& scene) {
  Policy open;
  Policy closed;
  for (const char* rule : {"point.ownership", "line.diamond-exit", "triangle.fill-rule"}) {
    open.rules[rule] = "open";
    closed.rules[rule] = "closed";
  }
  return drawn_under(scene, open) != drawn_under(scene, closed);
}

SeparationMatrix empty_matrix(const std::string& id) {
  SeparationMatrix matrix;
  matrix.rule = id;
  for (const Alternative& alternative : find_rule(id)->alternatives)
    matrix.alternatives.push_back(alternative.name);
  const std::size_t size = matrix.alternatives.size();
  matrix.cases.assign(size, std::vector<std::size_t>(size, 0));
  return matrix;
}

}  // namespace

std::size_t SeparationMatrix::least() const {
  std::size_t result = static_cast<std::size_t>(-1);
  for (std::size_t i = 0; i < alternatives.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) result = std::min(result, cases[i][j]);
  return result;
}

Separation measure_separation(const std::vector<Case>& cases) {
  Separation result;
  result.cases = cases.size();
  for (const char* rule : kCoverageRules) result.matrices.push_back(empty_matrix(rule));
  for (const Case& one : cases) {
    if (has_tie(one.scene)) ++result.with_ties;
    for (SeparationMatrix& matrix : result.matrices) count_case(one.scene, matrix);
  }
  return result;
}

}  // namespace edgecase
