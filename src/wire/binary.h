// SPDX-License-Identifier: MIT
//
// Values as bytes, for a reader that was built together with the writer and runs on the same
// machine: numbers as in memory, preceded by their count where it varies. The bytes carry no types.
//
// Each type is described once, by a function `carry(io, value)` that names its members in order: a
// Writer reads them from the value, and a Reader stores into them. A Reader throws a Refusal if
// bytes are missing; its caller checks whether values make sense.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/renderer.h"
#include "model/rendering_fields.h"
#include "model/scene_fields.h"
#include "wire/json_values.h"

namespace edgecase::wire {

// Types that are sent as they lie in memory.
template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

// T is U or const U.
template <class T, class U>
concept Of = std::same_as<std::remove_const_t<T>, U>;

class Writer {
 public:
  static constexpr bool kReads = false;

  explicit Writer(std::string& out) : out_(out) {}
  void bytes(const void* from, std::size_t count) {
    out_.append(static_cast<const char*>(from), count);
  }
  // Writes the number of elements that follow.
  std::size_t size(std::size_t count) {
    const std::uint64_t number = count;
    bytes(&number, sizeof(number));
    return count;
  }

 private:
  std::string& out_;
};

class Reader {
 public:
  static constexpr bool kReads = true;

  explicit Reader(std::string_view bytes) : left_(bytes) {}
  void bytes(void* to, std::size_t count) {
    if (count > left_.size()) throw Refusal("the message ends too early");
    if (count > 0) std::memcpy(to, left_.data(), count);
    left_.remove_prefix(count);
  }
  // Reads the number of elements that follow, of at least `least` bytes each.
  std::size_t size(std::size_t least) {
    std::uint64_t number = 0;
    bytes(&number, sizeof(number));
    if (number > left_.size() / least) throw Refusal("the message ends too early");
    return static_cast<std::size_t>(number);
  }
  std::string_view left() const { return left_; }

 private:
  std::string_view left_;
};

template <class Io, class T>
requires Plain<std::remove_const_t<T>>
void carry(Io& io, T& value) {
  io.bytes(&value, sizeof(value));
}

template <class Io, class T>
void carry_elements(Io& io, T* elements, std::size_t count) {
  if constexpr (Plain<std::remove_const_t<T>>)
    io.bytes(elements, count * sizeof(T));
  else
    for (std::size_t i = 0; i < count; ++i) carry(io, elements[i]);
}

template <class Io, class T, std::size_t N>
void carry(Io& io, std::array<T, N>& values) {
  carry_elements(io, values.data(), N);
}
template <class Io, class T, std::size_t N>
void carry(Io& io, const std::array<T, N>& values) {
  carry_elements(io, values.data(), N);
}

// Carries a vector or a string.
template <class Io, class Sequence>
void carry_sequence(Io& io, Sequence& values) {
  using T = typename Sequence::value_type;
  if constexpr (Io::kReads)
    values.resize(io.size(Plain<T> ? sizeof(T) : 1));
  else
    io.size(values.size());
  carry_elements(io, values.data(), values.size());
}

template <class Io, Of<std::string> T>
void carry(Io& io, T& text) {
  carry_sequence(io, text);
}
template <class Io, class T>
void carry(Io& io, std::vector<T>& values) {
  carry_sequence(io, values);
}
template <class Io, class T>
void carry(Io& io, const std::vector<T>& values) {
  carry_sequence(io, values);
}

template <class T>
void carry(Writer& io, const std::optional<T>& value) {
  const bool is_there = value.has_value();
  carry(io, is_there);
  if (is_there) carry(io, *value);
}
template <class T>
void carry(Reader& io, std::optional<T>& value) {
  bool is_there = false;
  carry(io, is_there);
  if (is_there) carry(io, value.emplace(T{}));
}

template <class Key, class T>
void carry(Writer& io, const std::map<Key, T>& values) {
  io.size(values.size());
  for (const auto& [key, value] : values) {
    carry(io, key);
    carry(io, value);
  }
}
template <class Key, class T>
void carry(Reader& io, std::map<Key, T>& values) {
  for (std::size_t left = io.size(1); left > 0; --left) {
    Key key{};
    carry(io, key);
    carry(io, values[std::move(key)]);
  }
}

// Carries one member after the other.
template <class Io, class... Members>
void carry_all(Io& io, Members&... members) {
  (carry(io, members), ...);
}

template <class Io, Of<std::pair<double, double>> T>
void carry(Io& io, T& pair) {
  carry_all(io, pair.first, pair.second);
}

// Scenes and renderings; a scene goes field by field (model/scene_fields.h).
inline void carry(Writer& io, const Fixed& value) {
  const std::int64_t raw = value.raw();
  carry(io, raw);
}
inline void carry(Reader& io, Fixed& value) {
  std::int64_t raw = 0;
  carry(io, raw);
  value = Fixed::from_raw(raw);
}

template <class Io, Of<Point> T>
void carry(Io& io, T& point) {
  carry_all(io, point.x, point.y);
}

template <class Io, class T>
requires HasFields<std::remove_const_t<T>>
void carry(Io& io, T& noun);

inline void carry(Writer& io, const std::shared_ptr<const Texture>& texture) {
  carry(io, *texture);
}
inline void carry(Reader& io, std::shared_ptr<const Texture>& texture) {
  auto read = std::make_shared<Texture>();
  carry(io, *read);
  texture = std::move(read);
}

template <class Io, class T>
requires HasFields<std::remove_const_t<T>>
void carry(Io& io, T& noun) {
  for_each_field<std::remove_const_t<T>>([&](const auto& field) { carry(io, noun.*field.member); });
}

template <class Io, Of<DerivativeValues> T>
void carry(Io& io, T& derivatives) {
  bool has_any = derivatives.has_any();
  carry(io, has_any);
  for (std::size_t i = 0; i < kDerivatives && has_any; ++i) carry(io, derivatives[i]);
}

template <class Io, Of<RendererInfo> T>
void carry(Io& io, T& info) {
  carry_all(io, info.vendor, info.version, info.device, info.subpixel_bits, info.traits);
}

}  // namespace edgecase::wire
