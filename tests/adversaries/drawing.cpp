// SPDX-License-Identifier: MIT
#include "tests/adversaries/drawing.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "model/sampling.h"
#include "tests/adversaries/buffers.h"
#include "tests/adversaries/textures.h"

namespace edgecase::adversary {
namespace {

constexpr Place kCentre{kPixel / 2, kPixel / 2};

// Of as many samples, none in the same row or column.
std::vector<Place> pattern(int samples) {
  std::vector<Place> places;
  for (int s = 0; s < samples; ++s)
    places.push_back({(2 * s + 1) * kPixel / (2 * samples),
                      (2 * ((s * 5 + 3) % samples) + 1) * kPixel / (2 * samples)});
  return places;
}

class Drawing {
 public:
  Drawing(const Scene& scene, const Freedoms& freedoms)
      : scene_(scene),
        freedoms_(freedoms),
        shaper_(scene, freedoms),
        values_(scene, freedoms),
        textures_(scene, freedoms),
        size_(static_cast<std::size_t>(scene.target.width) *
              static_cast<std::size_t>(scene.target.height)),
        buffers_(scene, freedoms, size_ * static_cast<std::size_t>(scene.target.samples)) {
    const Target& target = scene.target;
    if (target.samples == 1) {
      samples_ = {kCentre};
    } else if (target.sample_positions.empty()) {
      samples_ = pattern(target.samples);
    } else {
      for (const Point& p : target.sample_positions) samples_.push_back({p.x.raw(), p.y.raw()});
    }
  }

  Rendering finish() {
    for (const ScenePrimitive& primitive : shaper_.primitives()) draw_primitive(primitive);
    Rendering& r = rendering_;
    r.width = scene_.target.width;
    r.height = scene_.target.height;
    r.samples = scene_.target.samples;
    if (r.samples > 1)
      for (const Place& p : samples_)
        r.sample_positions.push_back({Fixed::from_raw(p.x), Fixed::from_raw(p.y)});
    buffers_.tell(r);
    if (!freedoms_.tells_less) r.mip_chains = textures_.generated();
    sort_fragments(r);
    return std::move(r);
  }

 private:
  void draw_primitive(const ScenePrimitive& primitive) {
    set_arithmetic(freedoms_.arithmetic);
    const Shape shape = shaper_.shape_of(primitive);
    // The areas of a fan's slivers make any number of 1 part in 10^5: no ruling bounds that.
    if (shape.is_cut && freedoms_.arithmetic != Arithmetic::exact)
      set_arithmetic(Arithmetic::binary32);
    if (shape.pieces.empty()) return;
    const bool multisampled = is_multisampled(*shape.draw, scene_.target);
    if (!multisampled && primitive.kind == PrimitiveKind::line) {
      for (const LinePixel& p : shaper_.line_pixels(shape))
        write(shape, shape.pieces[0], p.pixel, 1, p.valued_at, at(p.pixel, kCentre));
      return;
    }
    const PixelBounds box = extent(shape);
    for (int y = box.y_min; y <= box.y_max; ++y)
      for (int x = box.x_min; x <= box.x_max; ++x) {
        if (multisampled)
          draw_samples(shape, {x, y});
        else if (const Piece* piece = shaper_.piece_at(shape, at({x, y}, kCentre)))
          write(shape, *piece, {x, y}, 1, at({x, y}, kCentre), at({x, y}, kCentre));
      }
  }

  PixelBounds extent(const Shape& shape) const {
    std::int64_t reach = 2 * kPixel;
    if (shape.primitive->kind == PrimitiveKind::point) reach += shape.draw->point_size.raw();
    if (shape.primitive->kind == PrimitiveKind::line) reach += shape.draw->line_width.raw();
    std::int64_t left = INT64_MAX, low = INT64_MAX, right = INT64_MIN, high = INT64_MIN;
    for (const Piece& piece : shape.pieces)
      for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(shape.primitive->kind));
           ++i) {
        const Place p = piece.corners[i].place;
        left = std::min(left, p.x), right = std::max(right, p.x), low = std::min(low, p.y),
        high = std::max(high, p.y);
      }
    const auto pixel = [](std::int64_t n) {
      return static_cast<int>(std::clamp<std::int64_t>(n >> 16, -100000, 100000));
    };
    return common_part(shape.bounds, {pixel(left - reach), pixel(low - reach), pixel(right + reach),
                                      pixel(high + reach)});
  }

  static Place at(PixelPosition pixel, Place within) {
    return {pixel.x * kPixel + within.x, pixel.y * kPixel + within.y};
  }

  // 14.3.1 and 14.3.1.1.
  void draw_samples(const Shape& shape, PixelPosition pixel) {
    const Multisampling& use = shape.draw->multisampling;
    const int n = scene_.target.samples;
    std::uint32_t mask = 0;
    std::array<const Piece*, kMaxSamples> pieces{};
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      if ((use.mask >> s & 1) == 0 && freedoms_.crime != "masks ignored") continue;
      Place within = samples_[s];
      if (freedoms_.coverage_elsewhere)
        within = {(within.x + kPixel / 3) % kPixel, (within.y + kPixel / 5) % kPixel};
      pieces[s] = shaper_.piece_at(shape, at(pixel, within));
      if (pieces[s] != nullptr) mask |= 1U << s;
    }
    if (mask == 0) return;
    if (freedoms_.crime == "a sample too few" && std::popcount(mask) == n) mask &= mask - 1;
    const int first = std::countr_zero(mask), last = 31 - std::countl_zero(mask);
    const bool each = use.location == AttributeLocation::sample || freedoms_.shades_each_sample ||
                      least_invocations(use, n) > 1;
    if (each && freedoms_.crime != "shaded once") {
      for (int s = first; s <= last; ++s)
        if ((mask >> s & 1) != 0) {
          const Place place = at(pixel, samples_[static_cast<std::size_t>(s)]);
          write(shape, *pieces[static_cast<std::size_t>(s)], pixel, 1U << s, place, place);
        }
      return;
    }
    const auto chosen = static_cast<std::size_t>(freedoms_.attributes_anywhere ? last : first);
    Place place = at(pixel, kCentre);
    const std::uint64_t luck =
        hash(static_cast<std::uint64_t>(place.x), static_cast<std::uint64_t>(place.y));
    if (use.location == AttributeLocation::centroid) {
      if (std::popcount(mask) < n || freedoms_.attributes_anywhere)
        place = at(pixel, samples_[chosen]);
      if (freedoms_.crime == "centroids at the centre") place = at(pixel, kCentre);
    } else if (freedoms_.attributes_anywhere) {
      place = at(pixel, {static_cast<std::int64_t>(luck % kPixel),
                         static_cast<std::int64_t>((luck >> 20) % kPixel)});
    }
    if (freedoms_.crime == "attributes beside the pixel") place.x += kPixel;
    const Place coordinates =
        freedoms_.attributes_anywhere ? at(pixel, samples_[chosen]) : at(pixel, kCentre);
    write(shape, *pieces[chosen], pixel, mask, place, coordinates);
  }

  // One invocation of the shader. `valued`: where attributes are taken; `seen`: gl_FragCoord.
  void write(const Shape& shape, const Piece& piece, PixelPosition pixel, std::uint32_t mask,
             Place valued, Place seen) {
    const Draw& draw = *shape.draw;
    Fragment fragment;
    fragment.x = pixel.x;
    fragment.y = pixel.y;
    fragment.primitive = shape.primitive->index;
    fragment.coverage = mask;
    fragment.color = values_.attribute(shape, piece, valued);
    fragment.depth = values_.depth(shape, piece, seen);
    FragmentDetail detail;
    if (scene_.details.coordinates) {
      detail.coordinates = {static_cast<double>(seen.x) / kPixel,
                            static_cast<double>(seen.y) / kPixel, fragment.depth,
                            values_.inverse_w(shape, piece, seen)};
      if (freedoms_.crime == "coordinates by one unit")
        detail.coordinates->front() = static_cast<double>(
            std::nextafter(static_cast<float>(detail.coordinates->front()), 9e9F));
    }
    const bool one_sample = scene_.target.samples == 1;
    std::array<Values4, kDerivatives> derivatives{};
    if ((scene_.details.derivatives || draw.texture) && one_sample)
      derivatives = values_.derivatives(shape, piece, pixel);
    if (draw.texture) {
      const Values4 coordinates = fragment.color;
      const LookedUp found =
          textures_.look_up(*draw.texture, coordinates, derivatives[0], derivatives[1]);
      fragment.color = found.color;
      if (scene_.details.texture) {
        detail.texture_coordinates = {coordinates[0], coordinates[1]};
        if (!freedoms_.tells_less) detail.level_of_detail = found.queried;
      }
      for (auto& one : derivatives) one[2] = one[3] = 0;
    }
    for (std::size_t i = 0; i < kDerivatives && scene_.details.derivatives && one_sample; ++i)
      detail.derivatives[i] = derivatives[i];
    if (scene_.details.any()) {
      fragment.detail = static_cast<int>(rendering_.details.size());
      rendering_.details.push_back(detail);
    }
    rendering_.fragments.push_back(fragment);
    store(shape, piece, fragment, seen);
  }

  void store(const Shape& shape, const Piece& piece, const Fragment& fragment, Place seen) {
    const Draw& draw = *shape.draw;
    const bool multisampled = is_multisampled(draw, scene_.target);
    const std::uint32_t mask =
        multisampled ? fragment.coverage & kept(draw, fragment) : (1U << samples_.size()) - 1;
    const PixelPosition pixel{fragment.x, fragment.y};
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      if ((mask >> s & 1) == 0) continue;
      const bool own = multisampled || freedoms_.own_depths;
      const double depth = samples_.size() == 1 || !own
                               ? values_.depth(shape, piece, seen)
                               : values_.depth(shape, piece, at(pixel, samples_[s]));
      buffers_.meet(
          s * size_ +
              static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(scene_.target.width) +
              static_cast<std::size_t>(pixel.x),
          draw, shape.front, fragment.color, depth);
    }
  }

  // 17.3.1.
  std::uint32_t kept(const Draw& draw, const Fragment& fragment) const {
    const auto n = static_cast<std::uint32_t>(samples_.size());
    const std::uint32_t all = (1U << n) - 1;
    if (!draw.multisampling.alpha_to_coverage) return all;
    const double alpha = std::clamp(fragment.color[3], 0.0, 1.0), many = alpha * n;
    double count = std::floor(many + 0.5);
    if (freedoms_.alpha_rounding < 0) count = std::floor(many);
    if (freedoms_.alpha_rounding > 0) count = std::ceil(many);
    if (freedoms_.crime == "alpha 1 keeps all but one") count = std::min(count, n - 1.0);
    const std::uint32_t first = (1U << static_cast<std::uint32_t>(count)) - 1;
    if (!freedoms_.dithered_alpha) return first;
    const auto turn = static_cast<std::uint32_t>(
        hash(static_cast<std::uint64_t>(fragment.x), static_cast<std::uint64_t>(fragment.y)) % n);
    return ((first << turn) | (first >> (n - turn))) & all;
  }

  const Scene& scene_;
  const Freedoms& freedoms_;
  Shaper shaper_;
  Values values_;
  Textures textures_;
  std::size_t size_;
  Buffers buffers_;
  std::vector<Place> samples_;
  Rendering rendering_;
};

// A supersampled scene: the passes, and their mean in float32.
Rendering accumulated(const Scene& scene, const Freedoms& freedoms) {
  Rendering image;
  image.width = scene.target.width;
  image.height = scene.target.height;
  const std::size_t size = image.pixel_index(0, image.height);
  std::vector<float> sums(4 * size);
  float whole = 0;
  for (const ShadingPass& pass : scene.supersampling) whole += static_cast<float>(pass.weight);
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k) {
    const Scene moved = pass_of(scene, k);
    Drawing drawing(moved, freedoms);
    image.passes.push_back(drawing.finish());
    std::vector<std::array<double, 4>> shown(size);
    for (auto& color : shown)
      std::copy(scene.target.clear.begin(), scene.target.clear.end(), color.begin());
    std::vector<int> last(size, -1);
    for (const Fragment& fragment : image.passes.back().fragments) {
      const std::size_t at = image.pixel_index(fragment.x, fragment.y);
      if (fragment.primitive >= last[at]) last[at] = fragment.primitive, shown[at] = fragment.color;
    }
    const auto weight = static_cast<float>(scene.supersampling[k].weight);
    for (std::size_t i = 0; i < 4 * size; ++i) {
      const auto color = static_cast<float>(shown[i / 4][i % 4]);
      sums[i] +=
          freedoms.conversion == Conversion::nearest ? color * weight : color * (weight / whole);
    }
  }
  for (const float sum : sums) {
    const double mean =
        static_cast<double>(freedoms.conversion == Conversion::nearest ? sum / whole : sum);
    image.accumulated.push_back(freedoms.crime == "means off by 1 in 10^5" ? mean * 1.00001 : mean);
    image.pixels.push_back(static_cast<std::uint8_t>(
        std::nearbyint(converted(freedoms, image.accumulated.back(), 255) * 255)));
  }
  return image;
}

}  // namespace

Rendering draw(const Scene& scene, const Freedoms& freedoms) {
  set_arithmetic(freedoms.arithmetic);
  if (!scene.supersampling.empty()) return accumulated(scene, freedoms);
  return Drawing(scene, freedoms).finish();
}

}  // namespace edgecase::adversary
