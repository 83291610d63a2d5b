// SPDX-License-Identifier: MIT
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "model/scene_faults.h"
#include "wire/json_values.h"
#include "wire/scene_json.h"

namespace edgecase::wire {

using nlohmann::json;

namespace {

// The keys of a noun's object.
template <HasFields Noun>
std::vector<const char*> keys_of() {
  std::vector<const char*> keys;
  for_each_row<Noun>([&](const auto& field, const auto&) {
    using Value = typename std::remove_cvref_t<decltype(field)>::Type;
    if constexpr (!std::is_same_v<Value, Supersampling>) keys.push_back(field.key);
  });
  if constexpr (std::is_same_v<Noun, Target>) keys.push_back(kSupersampling);
  return keys;
}

std::int64_t whole(double limit) {
  return static_cast<std::int64_t>(limit);
}

// Checks for one level, or a whole chain of the right sizes.
void check_levels(const Texture& texture, const Path& path) {
  const TextureLevel& base = texture.levels[0];
  if (texture.dimensions == 1 && base.height != 1)
    throw Refusal(fmt::format("{}/0/height is {}, but a one-dimensional texture has 1", path.text(),
                              base.height));
  const std::size_t count = texture.levels.size();
  const auto all = static_cast<std::size_t>(level_count(base.width, base.height));
  if (texture.generated && count != 1)
    throw Refusal(
        fmt::format("{} has {} levels, but generated ones are not given", path.text(), count));
  if (count != 1 && count != all)
    throw Refusal(
        fmt::format("{} has {} levels, but a whole chain has {}", path.text(), count, all));
  for (std::size_t i = 1; i < count; ++i) {
    const TextureLevel& level = texture.levels[i];
    const int width = level_size(base.width, static_cast<int>(i));
    const int height = level_size(base.height, static_cast<int>(i));
    if (level.width != width || level.height != height)
      throw Refusal(fmt::format("{}/{} is {}x{}, but this level must be {}x{}", path.text(), i,
                                level.width, level.height, width, height));
  }
}

[[noreturn]] void refuse(const SceneFault& fault, const Path& path) {
  throw Refusal(fmt::format("{}: {}", path.text(), fault.text));
}

// Refuses a scene whose passes are too much work or move a vertex out of range.
void check_passes(const Scene& scene, const Path& path) {
  if (const auto fault = fault_of_passes(scene)) refuse(*fault, path);
  for (std::size_t k = 0; k < scene.supersampling.size(); ++k)
    for (const Draw& draw : scene.draws)
      for (const Vertex& vertex : draw.vertices)
        if (!is_in_range(moved_vertex(vertex, shift_of(scene.supersampling[k]), scene.viewport)))
          throw Refusal(Path(path, k).text() + " moves a vertex out of its range");
  if (!scene.supersampling.empty() && has_fragment_operations(scene))
    throw Refusal(path.text() + " is there, but the scene has fragment operations");
}

// Reads the fields of a scene in an order in which each only depends on earlier ones.
class SceneReader {
 public:
  Scene read(const json& value, const Path& path) {
    read_object(value, path, scene_);
    check_passes(scene_, {{path, "target"}, kSupersampling});
    return std::move(scene_);
  }

 private:
  template <HasFields Noun>
  void read_object(const json& value, const Path& path, Noun& noun) {
    static const std::vector<const char*> kKeys = keys_of<Noun>();
    require_object(value, path, kKeys);
    for_each_row<Noun>([&](const auto& field, const auto& part_of) {
      auto& part = part_of(noun).*field.member;
      const json* found = optional_member(value, field.key);
      if (found == nullptr && (field.is_left_out || may_be_absent(part))) return;
      const json& given = found != nullptr ? *found : member(value, path, field.key);
      read(given, {path, field.key}, field.limits, part);
    });
  }

  template <class Value>
  bool may_be_absent(const Value&) const {
    return false;
  }
  template <class Value>
  bool may_be_absent(const std::optional<Value>&) const {
    return true;
  }
  bool may_be_absent(const SamplePositions&) const { return true; }
  bool may_be_absent(const std::vector<std::shared_ptr<const Texture>>&) const { return true; }
  bool may_be_absent(const Multisampling&) const { return scene_.target.samples == 1; }
  bool may_be_absent(const Supersampling&) const { return true; }

  void read(const json& value, const Path& path, Limits, bool& flag) {
    flag = read_bool(value, path);
  }
  void read(const json& value, const Path& path, Limits limits, int& number) {
    number = static_cast<int>(read_integer(value, path, whole(limits.low), whole(limits.high)));
  }
  void read(const json& value, const Path& path, Limits limits, std::uint8_t& number) {
    number =
        static_cast<std::uint8_t>(read_integer(value, path, whole(limits.low), whole(limits.high)));
  }
  void read(const json& value, const Path& path, Limits limits, float& number) {
    number = read_float32(value, path, limits);
  }
  // A width or a size, which must exceed its lower limit.
  void read(const json& value, const Path& path, Limits limits, Fixed& thickness) {
    thickness = read_fixed(value, path);
    if (thickness.to_double() <= limits.low || thickness.to_double() > limits.high)
      throw Refusal(fmt::format("{} is {}, but it must be more than {} and at most {}", path.text(),
                                value.dump(), limits.low, limits.high));
  }
  template <HasNames Enum>
  void read(const json& value, const Path& path, Limits, Enum& name) {
    name = read_name<Enum>(value, path);
  }
  template <std::size_t N>
  void read(const json& value, const Path& path, Limits limits, std::array<float, N>& numbers) {
    numbers = read_float32s<N>(value, path, limits);
  }
  template <class Item, std::size_t N>
  void read(const json& value, const Path& path, Limits limits, std::array<Item, N>& items) {
    require_array(value, path, N);
    for (std::size_t i = 0; i < N; ++i) read(value[i], {path, i}, limits, items[i]);
  }
  template <class Item>
  void read(const json& value, const Path& path, Limits limits, std::vector<Item>& items) {
    require_array(value, path, value.size());
    for (std::size_t i = 0; i < value.size(); ++i)
      read(value[i], {path, i}, limits, items.emplace_back());
  }
  template <class Value>
  void read(const json& value, const Path& path, Limits limits, std::optional<Value>& part) {
    read(value, path, limits, part.emplace());
  }
  template <HasFields Noun>
  void read(const json& value, const Path& path, Limits, Noun& noun) {
    read_object(value, path, noun);
  }

  // [x, y, width, height]; the limits apply to the size.
  void read(const json& value, const Path& path, Limits limits, Viewport& box) {
    require_array(value, path, 4);
    const Limits corner{-limits.high, limits.high};
    read(value[0], {path, std::size_t{0}}, corner, box.x);
    read(value[1], {path, std::size_t{1}}, corner, box.y);
    read(value[2], {path, std::size_t{2}}, limits, box.width);
    read(value[3], {path, std::size_t{3}}, limits, box.height);
  }
  void read(const json& value, const Path& path, Limits, DepthRange& range) {
    const auto ends = read_float32s<2>(value, path, kUnitInterval);
    range = {ends[0], ends[1]};
  }
  void read(const json& value, const Path& path, Limits, SamplePositions& positions) {
    positions = read_positions(value, path, scene_.target.samples);
  }

  void read(const json& value, const Path& path, Limits, Target& target) {
    read_object(value, path, target);
    if (const json* passes = optional_member(value, kSupersampling))
      read_passes(*passes, {path, kSupersampling});
  }

  // [[x, y, weight], ...], 1 to kMaxPasses entries.
  void read_passes(const json& value, const Path& path) {
    if (scene_.target.samples != 1)
      throw Refusal(path.text() + " is there, but the target has several samples");
    require_array(value, path, value.size());
    if (value.empty() || value.size() > kMaxPasses)
      throw Refusal(fmt::format("{} has {} elements, but it must have 1 to {}", path.text(),
                                value.size(), kMaxPasses));
    for (std::size_t k = 0; k < value.size(); ++k) {
      const Path at(path, k);
      require_array(value[k], at, 3);
      scene_.supersampling.push_back(
          {{read_place(value[k][0], {at, std::size_t{0}}),
            read_place(value[k][1], {at, std::size_t{1}})},
           read_integer(value[k][2], {at, std::size_t{2}}, 1, kMaxPassWeight)});
    }
  }
  static Fixed read_place(const json& value, const Path& path) {
    const Fixed place = read_fixed(value, path);
    if (place < Fixed::from_integer(-1) || place > Fixed::from_integer(2))
      throw Refusal(fmt::format("{} is {}, but it must be -1 to 2", path.text(), value.dump()));
    return place;
  }
  void read(const json&, const Path&, Limits, Supersampling&) {}  // its key is in the target

  // Distinct names, at least one: a scene without details omits the key.
  void read(const json& value, const Path& path, Limits, Details& details) {
    require_array(value, path, value.size());
    if (value.empty()) throw Refusal(path.text() + " must have an element");
    for (std::size_t i = 0; i < value.size(); ++i) {
      const Path at(path, i);
      const std::string& name = read_string(value[i], at);
      bool* detail = nullptr;
      for_each_field<Details>([&](const auto& field) {
        if (name == field.key) detail = &(details.*field.member);
      });
      if (detail == nullptr) refuse_name(name, at);
      if (*detail) throw Refusal(fmt::format("{} names \"{}\" again", at.text(), name));
      *detail = true;
    }
  }

  void read(const json& value, const Path& path, Limits,
            std::vector<std::shared_ptr<const Texture>>& textures) {
    require_array(value, path, value.size());
    if (value.empty()) throw Refusal(path.text() + " must have an element");
    for (std::size_t i = 0; i < value.size(); ++i) {
      Texture texture;
      texture_ = &texture;
      read_object(value[i], {path, i}, texture);
      check_levels(texture, {{path, i}, "levels"});
      textures.push_back(std::make_shared<const Texture>(std::move(texture)));
    }
  }
  void read(const json& value, const Path& path, Limits, std::vector<TextureLevel>& levels) {
    levels = read_levels(value, path, texture_->format);
  }

  void read(const json& value, const Path& path, Limits, Draw& draw) {
    draw_ = &draw;
    if (scene_.target.samples == 1 && value.contains("multisampling"))
      throw Refusal(path.text() + " has \"multisampling\", but the target has one sample");
    read_object(value, path, draw);
  }
  // A mask of all samples becomes the default mask of Multisampling.
  void read(const json& value, const Path& path, Limits, Multisampling& multisampling) {
    read_object(value, path, multisampling);
    if (multisampling.mask == all_samples()) multisampling.mask = Multisampling().mask;
  }
  void read(const json& value, const Path& path, Limits, std::uint32_t& mask) {
    mask = static_cast<std::uint32_t>(read_integer(value, path, 0, all_samples()));
  }
  std::uint32_t all_samples() const { return (1U << scene_.target.samples) - 1; }

  void read(const json& value, const Path& path, Limits, TextureUse& use) {
    if (scene_.textures.empty())
      throw Refusal(path.text() + " is there, but the scene has no textures");
    read_object(value, path, use);
    const Texture& texture = *scene_.textures[use.texture];
    for (const SceneFault& fault : faults_of(use.sampler, &texture)) refuse(fault, path);
  }
  void read(const json& value, const Path& path, Limits, std::size_t& texture) {
    const auto last = static_cast<std::int64_t>(scene_.textures.size()) - 1;
    texture = static_cast<std::size_t>(read_integer(value, path, 0, last));
  }
  void read(const json& value, const Path& path, Limits, Lookup& lookup) {
    static const std::vector<const char*> kKeys = keys_of<Lookup>();
    require_object(value, path, kKeys);
    for_each_field<Lookup>([&](const auto& field) {
      if (takes(lookup.kind, field.key)) {
        read(member(value, path, field.key), {path, field.key}, field.limits, lookup.*field.member);
      } else if (value.contains(field.key)) {
        throw Refusal(fmt::format("{} has \"{}\", which a lookup of kind \"{}\" does not take",
                                  path.text(), field.key, name_of(lookup.kind)));
      }
    });
  }

  void read(const json& value, const Path& path, Limits, std::vector<Vertex>& vertices) {
    require_array(value, path, value.size());
    if (!is_vertex_count(draw_->primitive, value.size()))
      throw Refusal(fmt::format("{} has {} vertices, which make no whole {}", path.text(),
                                value.size(), name_of(draw_->primitive)));
    for (std::size_t i = 0; i < value.size(); ++i)
      vertices.push_back(
          read_vertex(value[i], {path, i}, scene_.viewport, draw_->texture.has_value()));
  }

  Scene scene_;
  const Texture* texture_ = nullptr;  // the texture whose levels are being read
  const Draw* draw_ = nullptr;        // the draw whose vertices are being read
};

}  // namespace

Scene read_scene(const json& value, const Path& path) {
  return SceneReader().read(value, path);
}

}  // namespace edgecase::wire
