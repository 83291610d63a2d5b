// SPDX-License-Identifier: MIT
//
// Scenes and renderings as bytes (wire/binary.h): a scene field by field (model/scene_fields.h).
// For src/wire alone.
#pragma once

#include <memory>

#include "model/renderer.h"
#include "model/scene_fields.h"
#include "wire/binary.h"

namespace edgecase::wire {

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

template <class Io, Of<RendererInfo> T>
void carry(Io& io, T& info) {
  carry_all(io, info.vendor, info.version, info.device, info.subpixel_bits, info.traits);
}

template <class Io, Of<FragmentDetail> T>
void carry(Io& io, T& detail) {
  const auto carry_told = [&](auto& is_told, auto& numbers) {
    carry(io, is_told);
    if (is_told) carry(io, numbers);
  };
  carry_told(detail.has_coordinates, detail.coordinates);
  for (std::size_t i = 0; i < kDerivatives; ++i)
    carry_told(detail.has_derivative[i], detail.derivatives[i]);
  carry_told(detail.has_texture_coordinates, detail.texture_coordinates);
  carry_told(detail.has_level_of_detail, detail.level_of_detail);
}

}  // namespace edgecase::wire
