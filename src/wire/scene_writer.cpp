// SPDX-License-Identifier: MIT
//
// A scene is written twice per request, by the sender and by the receiver, who checks the digest,
// and hundreds of thousands of times to measure a driver: it is formatted straight into the text.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "wire/json_values.h"
#include "wire/scene_json.h"

namespace edgecase::wire {

using nlohmann::json;

namespace {

constexpr const char* kTextureCoordinates = "texture_coordinates";
constexpr Limits kPositive{static_cast<double>(std::numeric_limits<float>::denorm_min())};

float read_w(const json& value, const Path& path) {
  return read_float32(value, path, kPositive, "a float32 value of more than 0");
}

// Whether `numerator * w / divisor` is exactly a float32 number. A fused multiply-add rounds only
// once, and only an exact zero gives zero, so it detects rounding errors of both products.
bool is_float32_quotient(double numerator, float w, double divisor) {
  const auto quotient = static_cast<float>(numerator * static_cast<double>(w) / divisor);
  return std::fma(numerator, static_cast<double>(w), -(static_cast<double>(quotient) * divisor)) ==
         0;
}

void check_products(const Vertex& vertex, const Path& path, const Viewport& viewport) {
  // Twice the distance from the viewport's centre.
  const double x = 2 * (vertex.position.x.to_double() - viewport.x) - viewport.width;
  const double y = 2 * (vertex.position.y.to_double() - viewport.y) - viewport.height;
  if (!is_float32_quotient(x, vertex.w, viewport.width) ||
      !is_float32_quotient(y, vertex.w, viewport.height) ||
      !is_float32_quotient(vertex.z.to_double(), vertex.w, 1))
    throw Refusal(
        fmt::format("{} has a position whose clip coordinates are no float32 values", path.text()));
}

// Multiples of 2^(e-30), with 2^e the power of two at or below the largest magnitude, not 0.
ClipPosition read_clip(const json& value, const Path& path) {
  require_array(value, path, 4);
  ClipPosition clip;
  float* const parts[] = {&clip.x, &clip.y, &clip.z, &clip.w};
  for (std::size_t i = 0; i < 4; ++i) *parts[i] = read_float32(value[i], {path, i});
  const double unit = unit_of(clip);
  if (std::ranges::all_of(parts, [](const float* part) { return *part == 0; }))
    throw Refusal(path.text() + " is 0 in all four");
  for (std::size_t i = 0; i < 4; ++i) {
    const double steps = static_cast<double>(*parts[i]) / unit;
    if (steps != std::trunc(steps))
      throw Refusal(fmt::format("{} is {}, but it must be a multiple of 2^{}", Path(path, i).text(),
                                value[i].dump(), std::ilogb(unit)));
  }
  return clip;
}

// The multiple of 2^-16 nearest to z/w; ties go up.
Fixed nearest_depth(const ClipPosition& clip) {
  const double unit = unit_of(clip);
  const auto steps = [&](float value) {
    return static_cast<std::int64_t>(static_cast<double>(value) / unit);
  };
  return nearest_point({steps(clip.z), 0, steps(clip.w)}).x;
}

// A vertex outside the clip volume has the position 0.
void check_position(const Vertex& vertex, const Path& path, const Viewport& viewport) {
  const bool inside = is_in_clip_volume(*vertex.clip);
  const Point nearest = inside ? nearest_point(window_position(*vertex.clip, viewport)) : Point();
  const Fixed depth = inside ? nearest_depth(*vertex.clip) : Fixed();
  if (vertex.position == nearest && vertex.z == depth) return;
  throw Refusal(fmt::format("{} is [{},{},{}], but its clip coordinates make it [{},{},{}]",
                            path.text(), vertex.position.x.to_double(),
                            vertex.position.y.to_double(), vertex.z.to_double(),
                            nearest.x.to_double(), nearest.y.to_double(), depth.to_double()));
}

}  // namespace

void write_vertex(Output out, const Vertex& vertex, bool is_textured) {
  fmt::format_to(out, R"({{"position":[)");
  write_number(out, vertex.position.x.to_double());
  *out++ = ',';
  write_number(out, vertex.position.y.to_double());
  *out++ = ',';
  write_number(out, vertex.z.to_double());
  *out++ = ']';
  if (vertex.clip) {
    fmt::format_to(out, R"(,"clip":)");
    const ClipPosition& clip = *vertex.clip;
    write_numbers(out, std::array{clip.x, clip.y, clip.z, clip.w});
  } else if (vertex.w != 1) {
    fmt::format_to(out, R"(,"w":)");
    write_number(out, static_cast<double>(vertex.w));
  }
  fmt::format_to(out, R"(,"color":)");
  write_numbers(out, vertex.color);
  if (is_textured) {
    fmt::format_to(out, R"(,"texture_coordinates":)");
    write_numbers(out, vertex.texture_coordinates);
  }
  *out++ = '}';
}

Vertex read_vertex(const json& value, const Path& path, const Viewport& viewport,
                   bool is_textured) {
  require_object(value, path, {"position", "w", "clip", "color", kTextureCoordinates});
  const json& position = member(value, path, "position");
  const Path at(path, "position");
  require_array(position, at, 3);
  Vertex vertex;
  vertex.position.x = read_fixed(position[0], {at, std::size_t{0}});
  vertex.position.y = read_fixed(position[1], {at, std::size_t{1}});
  vertex.z = read_fixed(position[2], {at, std::size_t{2}});
  vertex.color = read_float32s<4>(member(value, path, "color"), {path, "color"});
  const json* clip = optional_member(value, "clip");
  const json* w = optional_member(value, "w");
  if (clip != nullptr && w != nullptr) throw Refusal(path.text() + " has both \"clip\" and \"w\"");
  if (clip != nullptr) {
    vertex.clip = read_clip(*clip, {path, "clip"});
    vertex.w = vertex.clip->w;
    check_position(vertex, at, viewport);
  } else if (w != nullptr) {
    vertex.w = read_w(*w, {path, "w"});
    check_products(vertex, path, viewport);
  }
  if (is_textured)
    vertex.texture_coordinates =
        read_float32s<2>(member(value, path, kTextureCoordinates), {path, kTextureCoordinates});
  else if (value.contains(kTextureCoordinates))
    throw Refusal(path.text() + " has \"texture_coordinates\", but its draw has no texture");
  return vertex;
}

namespace {

class SceneWriter {
 public:
  SceneWriter(fmt::memory_buffer& text, const Scene& scene)
      : text_(text), out_(text), scene_(scene) {}

  void write(const Scene& scene) { write_object(scene); }

 private:
  void put(std::string_view part) { text_.append(part.data(), part.data() + part.size()); }

  template <HasFields Noun>
  void write_object(const Noun& noun) {
    text_.push_back('{');
    write_members(noun);
    text_.push_back('}');
  }

  template <HasFields Noun>
  void write_members(const Noun& noun) {
    static const Noun standard;
    for_each_row<Noun>([&](const auto& field, const auto& part) {
      const auto& value = part(noun).*field.member;
      using Value = std::remove_cvref_t<decltype(value)>;
      if (is_absent(value) || (field.is_left_out && value == part(standard).*field.member)) return;
      // The passes of a supersampled scene are written in its target.
      if constexpr (!std::is_same_v<Value, Supersampling>) {
        write_key(field.key);
        write(value);
      }
    });
  }

  void write_key(std::string_view key) {
    if (text_[text_.size() - 1] != '{') text_.push_back(',');
    text_.push_back('"');
    put(key);
    put("\":");
  }

  template <class Items, class Write>
  void write_list(const Items& items, Write write_item) {
    text_.push_back('[');
    bool is_first = true;
    for (const auto& item : items) {
      if (!is_first) text_.push_back(',');
      is_first = false;
      write_item(item);
    }
    text_.push_back(']');
  }

  // Whether a value is never written; the general case.
  template <class Value>
  bool is_absent(const Value&) const {
    return false;
  }
  template <class Value>
  bool is_absent(const std::optional<Value>& value) const {
    return !value.has_value();
  }
  bool is_absent(const SamplePositions& positions) const { return positions.empty(); }
  bool is_absent(const std::vector<std::shared_ptr<const Texture>>& textures) const {
    return textures.empty();
  }
  bool is_absent(const Multisampling&) const { return scene_.target.samples == 1; }

  void write(bool value) { put(value ? "true" : "false"); }
  void write(std::int64_t value) {
    const fmt::format_int digits(value);
    put({digits.data(), digits.size()});
  }
  void write(int value) { write(std::int64_t{value}); }
  void write(std::uint8_t value) { write(std::int64_t{value}); }
  void write(std::uint32_t value) { write(std::int64_t{value}); }
  void write(std::size_t value) { write(static_cast<std::int64_t>(value)); }
  void write(float value) { write_number(out_, static_cast<double>(value)); }
  void write(Fixed value) { write_number(out_, value.to_double()); }
  template <HasNames Enum>
  void write(Enum value) {
    text_.push_back('"');
    put(name_of(value));
    text_.push_back('"');
  }
  template <std::size_t N>
  void write(const std::array<float, N>& numbers) {
    write_numbers(out_, numbers);
  }
  template <class Item, std::size_t N>
  void write(const std::array<Item, N>& items) {
    write_list(items, [&](const Item& item) { write(item); });
  }
  template <class Item>
  void write(const std::vector<Item>& items) {
    write_list(items, [&](const Item& item) { write(item); });
  }
  template <class Value>
  void write(const std::optional<Value>& value) {
    write(*value);
  }
  template <HasFields Noun>
  void write(const Noun& noun) {
    write_object(noun);
  }

  void write(const Viewport& box) { write(std::array{box.x, box.y, box.width, box.height}); }
  void write(const DepthRange& range) { write(std::array{range.near, range.far}); }
  void write(const SamplePositions& positions) { write_positions(out_, positions); }
  void write(const std::shared_ptr<const Texture>& texture) { write(*texture); }
  void write(const TextureLevel& level) { write_level(out_, level); }

  void write(const Target& target) {
    text_.push_back('{');
    write_members(target);
    if (!scene_.supersampling.empty()) {
      write_key(kSupersampling);
      write_list(scene_.supersampling, [&](const ShadingPass& pass) {
        text_.push_back('[');
        write(pass.at.x);
        text_.push_back(',');
        write(pass.at.y);
        text_.push_back(',');
        write(pass.weight);
        text_.push_back(']');
      });
    }
    text_.push_back('}');
  }

  // The names of the requested details.
  void write(const Details& details) {
    text_.push_back('[');
    for_each_field<Details>([&](const auto& field) {
      if (!(details.*field.member)) return;
      if (text_[text_.size() - 1] != '[') text_.push_back(',');
      text_.push_back('"');
      put(field.key);
      text_.push_back('"');
    });
    text_.push_back(']');
  }

  // Bits of the mask beyond the target's samples are left out.
  void write(const Multisampling& multisampling) {
    Multisampling sent = multisampling;
    sent.mask &= (1U << scene_.target.samples) - 1;
    write_object(sent);
  }

  // Only the numbers that its kind takes.
  void write(const Lookup& lookup) {
    text_.push_back('{');
    for_each_field<Lookup>([&](const auto& field) {
      if (!takes(lookup.kind, field.key)) return;
      write_key(field.key);
      write(lookup.*field.member);
    });
    text_.push_back('}');
  }

  void write(const Draw& draw) {
    draw_ = &draw;
    write_object(draw);
  }
  void write(const std::vector<Vertex>& vertices) {
    write_list(vertices, [&](const Vertex& vertex) {
      write_vertex(out_, vertex, draw_->texture.has_value());
    });
  }

  fmt::memory_buffer& text_;
  Output out_;
  const Scene& scene_;
  const Draw* draw_ = nullptr;  // the draw whose vertices are being written
};

}  // namespace

void write_scene(fmt::memory_buffer& text, const Scene& scene) {
  SceneWriter(text, scene).write(scene);
}

}  // namespace edgecase::wire
