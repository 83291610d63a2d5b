// SPDX-License-Identifier: MIT
//
// A scene is written twice per request, by the sender and by the receiver, who checks the digest,
// and hundreds of thousands of times to measure a driver: it is formatted straight into the text.
#include <string_view>

#include "wire/json_values.h"
#include "wire/scene_json.h"

namespace edgecase::wire {
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
    for_each_field<Noun>([&](const auto& field) {
      const auto& value = noun.*field.member;
      using Value = std::remove_cvref_t<decltype(value)>;
      if (is_absent(value) || (field.is_left_out && value == standard.*field.member)) return;
      if constexpr (HasFields<Value>) {
        if (field.key == nullptr) return write_members(value);
      }
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
