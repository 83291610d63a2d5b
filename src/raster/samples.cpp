// SPDX-License-Identifier: MIT
#include "raster/samples.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

#include "raster/attributes.h"
#include "raster/coverage_stages.h"
#include "raster/rasterizer.h"
#include "rules/choices.h"

namespace edgecase {

namespace {

struct PixelMask {
  PixelPosition pixel;
  std::uint32_t mask;
};

// The mask of covered samples of each pixel, sorted by row, then column.
std::vector<PixelMask> masks_of(const SampleCoverage& coverage) {
  std::vector<PixelMask> bits;
  for (std::size_t s = 0; s < coverage.size(); ++s)
    for (PixelPosition pixel : coverage[s]) bits.push_back({pixel, std::uint32_t{1} << s});
  std::ranges::sort(bits, {},
                    [](const PixelMask& mask) { return std::pair(mask.pixel.y, mask.pixel.x); });
  std::vector<PixelMask> masks;
  for (const PixelMask& bit : bits) {
    if (masks.empty() || masks.back().pixel != bit.pixel) masks.push_back({bit.pixel, 0});
    masks.back().mask |= bit.mask;
  }
  return masks;
}

// Draws the fragments of one primitive.
class MultisampledPrimitive {
 public:
  MultisampledPrimitive(Rendering& rendering, const FragmentStage& stage, const Target& target,
                        const ScenePrimitive& primitive, const RuleChoices& choices,
                        Details details)
      : rendering_(rendering),
        stage_(stage),
        target_(target),
        primitive_(primitive),
        choices_(choices),
        details_(details),
        use_(primitive.state->multisampling),
        sampling_(sampling_of(primitive, target, choices.of(primitive.kind))),
        attributes_(attributes_of(primitive, choices, target)),
        shaded_(attributes_),
        front_facing_(is_front_facing(primitive, target, choices.of(primitive.kind))) {
    use_.enabled = sampling_ == Unsampled::by_each_sample;
    if (fragment_depth_is_zero(primitive.state->multisampling, locations()))
      shaded_.depth.values.fill(0);
  }

  void draw(PixelPosition pixel, std::uint32_t mask) {
    if (sampling_ != Unsampled::by_each_sample) {
      draw_single_sampled(pixel, mask);
    } else if (runs_per_sample(use_, rendering_.samples, choices_.samples.rate)) {
      for (std::uint32_t rest = mask & running(pixel); rest != 0; rest &= rest - 1)
        draw_invocation(pixel, {primitive_.kind, rest & (~rest + 1), true});
    } else {
      draw_invocation(pixel, {primitive_.kind, mask, false});
    }
  }

 private:
  const LocationChoice& locations() const { return choices_.values.locations; }
  bool heeds_others() const {
    return edgecase::heeds_others(use_, rendering_.samples, choices_.samples);
  }
  std::vector<double> alphas_at(PixelPosition pixel) const {
    return alphas_of_samples(primitive_, attributes_, pixel, rendering_.sample_positions,
                             locations());
  }
  // The samples of a pixel for which the shader runs, provided it runs for each covered one.
  std::uint32_t running(PixelPosition pixel) const {
    return heeds_others() ? runs_by_others(alphas_at(pixel)) : ~std::uint32_t{0};
  }

  void draw_single_sampled(PixelPosition pixel, std::uint32_t coverage) {
    const Point centre = pixel_centre(pixel.x, pixel.y);
    const CoverageChoice& choice = choices_.of(primitive_.kind);
    const Point place = attribute_place(primitive_, target_, choice, pixel);
    const Fragment fragment = shaded(pixel, coverage, {place, centre, centre});
    const bool first_alone = choice.multisample_switch == MultisampleSwitch::depth_of_first;
    for (int sample = 0; sample < rendering_.samples; ++sample)
      write(fragment, sample, centre_of_pixel(), sample == 0 || !first_alone);
  }

  void draw_invocation(PixelPosition pixel, const Invocation& invocation) {
    const SamplePositions& positions = rendering_.sample_positions;
    const Fragment fragment = shaded(
        pixel, invocation.coverage,
        {place_in(pixel, attribute_location(use_.location, invocation, positions, locations())),
         place_in(pixel, fragment_depth_location(invocation, positions, locations())),
         place_in(pixel, coordinates_location(invocation, positions))});
    std::uint32_t written = invocation.coverage;
    if (use_.alpha_to_coverage)
      written &= heeds_others() ? mask_by_others(alphas_at(pixel))
                                : alpha_mask(fragment.color[3], rendering_.samples,
                                             choices_.samples.alpha_to_coverage);
    for (; written != 0; written &= written - 1) {
      const int sample = std::countr_zero(written);
      write(fragment, sample,
            sample_depth_location(primitive_.kind, positions[static_cast<std::size_t>(sample)],
                                  locations()));
    }
  }

  // Adds the fragment, and its details, to the rendering.
  const Fragment& shaded(PixelPosition pixel, std::uint32_t coverage, const ShadingPlaces& places) {
    Fragment fragment = shade(primitive_, shaded_, pixel, places);
    fragment.coverage = coverage;
    if (details_.coordinates) {
      fragment.detail = static_cast<int>(rendering_.details.size());
      rendering_.details.emplace_back().coordinates = coordinates_at(shaded_, places);
    }
    return rendering_.fragments.emplace_back(fragment);
  }

  // `location` of the sample's depth, within the pixel.
  void write(const Fragment& fragment, int sample, Point location, bool writes_depth = true) {
    ExactFragment written{fragment.color, fragment.depth, front_facing_, writes_depth};
    if (target_.depth != DepthFormat::none)
      written.depth =
          middle(depth_exact(attributes_, place_in({fragment.x, fragment.y}, location)));
    stage_.draw(written, primitive_.state->operations,
                rendering_.sample_index(fragment.x, fragment.y, sample));
  }

  Rendering& rendering_;
  const FragmentStage& stage_;
  const Target& target_;
  const ScenePrimitive& primitive_;
  const RuleChoices& choices_;
  const Details details_;
  Multisampling use_;
  Unsampled sampling_;
  PrimitiveAttributes attributes_;
  PrimitiveAttributes shaded_;  // the shader's inputs
  bool front_facing_;
};

}  // namespace

std::vector<double> alphas_of_samples(const ScenePrimitive& primitive,
                                      const PrimitiveAttributes& attributes, PixelPosition pixel,
                                      const SamplePositions& positions,
                                      const LocationChoice& locations) {
  const AttributeLocation qualifier = primitive.state->multisampling.location;
  std::vector<double> alphas;
  for (std::size_t s = 0; s < positions.size(); ++s) {
    const Invocation invocation{primitive.kind, std::uint32_t{1} << s, true};
    const Point place = attribute_location(qualifier, invocation, positions, locations);
    alphas.push_back(middle(color_exact(attributes, 3, place_in(pixel, place), pixel)));
  }
  return alphas;
}

bool heeds_others(const Multisampling& use, int samples, const SampleChoice& choice) {
  return use.alpha_to_coverage &&
         choice.alpha_to_coverage == AlphaToCoverage::above_quotient_of_others &&
         runs_per_sample(use, samples, choice.rate);
}

void draw_multisampled(Rendering& rendering, const FragmentStage& stage, const Target& target,
                       const ScenePrimitive& primitive, const RuleChoices& choices, Details details,
                       const SampleCoverage& coverage) {
  MultisampledPrimitive drawn(rendering, stage, target, primitive, choices, details);
  for (const auto& [pixel, mask] : masks_of(coverage)) drawn.draw(pixel, mask);
}

void resolve_samples(Rendering& rendering, ResolveMethod method) {
  const std::size_t plane = rendering.pixels.size();
  std::vector<std::uint8_t> values(static_cast<std::size_t>(rendering.samples));
  for (std::size_t i = 0; i < plane; ++i) {
    for (std::size_t s = 0; s < values.size(); ++s)
      values[s] = rendering.sample_pixels[s * plane + i];
    rendering.pixels[i] = resolved(values, method);
  }
}

namespace {

using Components = std::array<double, 4>;

// The colours that each pass shows, pixel by pixel.
class ShownColors {
 public:
  ShownColors(const Target& target, std::span<const Rendering> passes)
      : passes_(passes), next_(passes.size()) {
    std::copy(target.clear.begin(), target.clear.end(), clear_.begin());
  }

  // The colour in pass k; pixels must be queried in order.
  const Components& at(std::size_t k, int x, int y) {
    const auto& fragments = passes_[k].fragments;
    const Components* shown = &clear_;
    std::size_t& next = next_[k];
    for (; next < fragments.size() && fragments[next].x == x && fragments[next].y == y; ++next)
      shown = &fragments[next].color;
    return *shown;
  }

 private:
  std::span<const Rendering> passes_;
  std::vector<std::size_t> next_;  // for each pass, the first fragment not yet consumed
  Components clear_{};
};

}  // namespace

void for_each_shown(const Scene& scene, std::span<const Rendering> passes,
                    const std::function<void(std::span<const double>)>& visit) {
  ShownColors colors(scene.target, passes);
  std::array<std::vector<double>, 4> shown;
  for (auto& values : shown) values.resize(passes.size());
  for (int y = 0; y < scene.target.height; ++y) {
    for (int x = 0; x < scene.target.width; ++x) {
      for (std::size_t k = 0; k < passes.size(); ++k) {
        const Components& color = colors.at(k, x, y);
        for (std::size_t c = 0; c < color.size(); ++c) shown[c][k] = color[c];
      }
      for (const auto& values : shown) visit(values);
    }
  }
}

std::vector<double> accumulated_image(const Scene& scene, std::span<const Rendering> passes,
                                      Accumulation choice) {
  std::vector<double> image;
  for_each_shown(scene, passes, [&](std::span<const double> shown) {
    image.push_back(accumulated(shown, scene.supersampling, choice));
  });
  return image;
}

Rendering draw_passes(const Scene& scene, const ResolvedPolicy& policy, DrawPass draw) {
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k)
    rendering.passes.push_back(draw(pass_of(scene, k), policy, {}));
  const RuleChoices& choices = policy.on(scene.target.surface);
  rendering.accumulated = accumulated_image(scene, rendering.passes, choices.samples.accumulation);
  rendering.pixels.reserve(rendering.accumulated.size());
  for (const double component : rendering.accumulated)
    rendering.pixels.push_back(to_unorm8(component));
  return rendering;
}

}  // namespace edgecase
