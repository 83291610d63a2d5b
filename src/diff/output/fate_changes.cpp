// SPDX-License-Identifier: MIT
#include "diff/output/fate_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "diff/values/location_causes.h"

namespace edgecase {
namespace {

template <class Predicate>
bool any_draw(const Scene& scene, const Predicate& predicate) {
  return std::ranges::any_of(scene.draws, predicate);
}

class Catalogue {
 public:
  explicit Catalogue(const FateChoice& chosen) : chosen_(chosen) {}

  // `at`: where in a choice the rule's alternative is held.
  template <class Range, class At>
  void add(const char* rule, const Range& all, const At& at) {
    for (const auto alternative : all) {
      FateChoice held = chosen_;
      if (at(held) == alternative) continue;
      changes.push_back({rule, fmt::format("{}={}", rule, name_of(alternative)),
                         [at, alternative](FateChoice& choice) { at(choice) = alternative; }});
    }
  }

  std::vector<FateChange> changes;

 private:
  const FateChoice& chosen_;
};

bool has_stencil_test(const Scene& scene) {
  return scene.target.stencil != StencilFormat::none &&
         any_draw(scene, [](const Draw& draw) { return draw.operations.stencil.has_value(); });
}

bool has_depth_test(const Scene& scene) {
  return scene.target.depth != DepthFormat::none && any_draw(scene, [](const Draw& draw) {
           return draw.operations.depth.function != CompareFunction::always;
         });
}

bool masks_depths(const Scene& scene) {
  return scene.target.depth != DepthFormat::none &&
         any_draw(scene, [](const Draw& draw) { return !draw.operations.depth.write; });
}

void add_tests(const Scene& scene, Catalogue& catalogue) {
  if (has_depth_test(scene))
    catalogue.add("depth.test", values_of<DepthTestMethod>(),
                  [](FateChoice& c) -> DepthTestMethod& { return c.output.depth; });
  if (masks_depths(scene))
    catalogue.add("depth.mask", std::array{DepthMaskMethod::as_set, DepthMaskMethod::ignored},
                  [](FateChoice& c) -> DepthMaskMethod& { return c.output.depth_mask; });
  if (!has_stencil_test(scene)) return;
  catalogue.add("stencil.test", values_of<StencilMethod>(),
                [](FateChoice& c) -> StencilMethod& { return c.output.stencil; });
  catalogue.add("polygon.facing", values_of<FacingMethod>(),
                [](FateChoice& c) -> FacingMethod& { return c.facing; });
}

void add_blending(const Scene& scene, Catalogue& catalogue) {
  const auto is_masked = [](const Draw& draw) {
    return std::ranges::any_of(draw.operations.color_mask, [](bool on) { return !on; });
  };
  if (any_draw(scene, is_masked))
    catalogue.add("color.mask", std::array{ColorMaskMethod::as_set, ColorMaskMethod::ignored},
                  [](FateChoice& c) -> ColorMaskMethod& { return c.output.blend.mask; });
  if (!any_draw(scene, [](const Draw& draw) { return draw.operations.blending.has_value(); }))
    return;
  catalogue.add("blend.equation", values_of<BlendMethod>(),
                [](FateChoice& c) -> BlendMethod& { return c.output.blend.method; });
  catalogue.add("blend.rounding", values_of<BlendRounding>(),
                [](FateChoice& c) -> BlendRounding& { return c.output.blend.rounding; });
}

void add_samples(const Scene& scene, Catalogue& catalogue) {
  if (scene.target.samples == 1) return;
  if (any_draw(scene, [](const Draw& draw) { return draw.multisampling.alpha_to_coverage; }))
    catalogue.add("sample.alpha-to-coverage", values_of<AlphaToCoverage>(),
                  [](FateChoice& c) -> AlphaToCoverage& { return c.alpha; });
  if (any_draw(scene, [](const Draw& draw) { return !draw.multisampling.enabled; }))
    catalogue.add("sample.enable", values_of<MultisampleSwitch>(),
                  [](FateChoice& c) -> MultisampleSwitch& { return c.without; });
  if (scene.target.depth != DepthFormat::none)
    catalogue.add("sample.depth", values_of<DepthLocation>(),
                  [](FateChoice& c) -> DepthLocation& { return c.locations.depth; });
}

}  // namespace

std::vector<FateChange> fate_changes_beside(const FateChoice& chosen, const Scene& scene) {
  Catalogue catalogue(chosen);
  add_tests(scene, catalogue);
  add_blending(scene, catalogue);
  add_samples(scene, catalogue);
  return std::move(catalogue.changes);
}

std::vector<FateChange> fate_changes_of(const std::string& rule, const FateChoice& chosen,
                                        const Scene& scene) {
  std::vector<FateChange> changes = fate_changes_beside(chosen, scene);
  std::erase_if(changes, [&](const FateChange& change) { return change.rule != rule; });
  return changes;
}

int ruling_on_fate(const std::string& rule) {
  static const std::map<std::string, int> rulings = {
      {"framebuffer.unorm8", 10}, {"framebuffer.order", 11}, {"framebuffer.depth", 18},
      {"sample.depth", 18},       {"sample.enable", 35},     {"sample.alpha-to-coverage", 33},
      {"blend.equation", 37},     {"blend.rounding", 37},    {"depth.test", 39},
      {"polygon.facing", 40},     {"stencil.test", 41},      {"color.mask", 41},
      {"depth.mask", 41},         {"fragment.once", 7}};
  const auto found = rulings.find(rule);
  return found != rulings.end() ? found->second : 0;
}

}  // namespace edgecase
