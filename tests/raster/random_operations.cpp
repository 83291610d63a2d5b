// SPDX-License-Identifier: MIT
#include "tests/raster/random_operations.h"

namespace edgecase {
namespace {

template <class Value>
Value any_to(RandomScenes& random, Value last) {
  return static_cast<Value>(random.below(static_cast<int>(last) + 1));
}

bool one_in(RandomScenes& random, int count) {
  return random.below(count) == 0;
}

// Small values, at either end.
std::uint8_t stencil_value(RandomScenes& random) {
  return static_cast<std::uint8_t>(random.below(5) - 2);
}

std::uint8_t mask(RandomScenes& random) {
  return one_in(random, 3) ? static_cast<std::uint8_t>(random.below(256)) : std::uint8_t{0xff};
}

// Half of all comparisons pass always.
CompareFunction comparison(RandomScenes& random) {
  return one_in(random, 2) ? CompareFunction::always : any_to(random, CompareFunction::always);
}

StencilFace face(RandomScenes& random) {
  StencilFace result;
  result.function = comparison(random);
  result.reference = stencil_value(random);
  result.read_mask = mask(random);
  result.write_mask = mask(random);
  for (StencilOperation* operation : {&result.fail, &result.depth_fail, &result.pass})
    *operation = any_to(random, StencilOperation::invert);
  return result;
}

// Some of them over, in either form.
BlendTerm term(RandomScenes& random) {
  if (one_in(random, 4))
    return {BlendEquation::add, one_in(random, 2) ? BlendFactor::src_alpha : BlendFactor::one,
            BlendFactor::one_minus_src_alpha};
  BlendTerm result;
  result.equation = any_to(random, BlendEquation::max);
  result.source = any_to(random, BlendFactor::src_alpha_saturate);
  result.destination = any_to(random, BlendFactor::src_alpha_saturate);
  return result;
}

Color constant(RandomScenes& random) {
  Color result;
  for (float& component : result) component = static_cast<float>(random.below(9)) / 8;
  return result;
}

// Some of them beyond 0 to 1, some halfway between two codes.
float component(RandomScenes& random) {
  if (one_in(random, 8)) return random.below(2) == 0 ? -0.25F : 1.5F;
  if (one_in(random, 2)) return static_cast<float>(random.below(9)) / 8;
  return static_cast<float>(random.below(10001)) / 10000;
}

}  // namespace

FragmentOperations random_operations(RandomScenes& random) {
  FragmentOperations operations;
  if (!one_in(random, 4)) operations.stencil = {face(random), face(random)};
  operations.depth = {comparison(random), !one_in(random, 3)};
  if (!one_in(random, 3))
    operations.blending = Blending{term(random), term(random), constant(random)};
  if (one_in(random, 3))
    for (bool& written : operations.color_mask) written = one_in(random, 2);
  return operations;
}

void give_operations(Scene& scene, RandomScenes& random) {
  Target& target = scene.target;
  target.depth = any_to(random, DepthFormat::depth32f);
  if (target.depth != DepthFormat::depth16)
    target.stencil = any_to(random, StencilFormat::stencil8);
  target.clear = constant(random);
  target.clear_depth = one_in(random, 2) ? 1 : static_cast<float>(random.below(9)) / 8;
  target.clear_stencil = stencil_value(random);
  for (Draw& draw : scene.draws) {
    draw.operations = random_operations(random);
    draw.front_face = any_to(random, FrontFace::cw);
    const bool level = one_in(random, 2);
    const auto height = [&] { return Fixed::from_raw((random.below(9) - 4) * Fixed::kOne / 4); };
    const Fixed all = height();
    for (Vertex& vertex : draw.vertices) {
      vertex.z = level ? all : height();
      for (float& value : vertex.color) value = component(random);
    }
  }
}

}  // namespace edgecase
