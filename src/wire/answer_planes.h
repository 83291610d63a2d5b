// SPDX-License-Identifier: MIT
//
// The planes of an answer (pixels, stencils, hits, depths, ...), for use in src/wire only. They are
// nearly all of its line, and a JSON value takes sixteen bytes for each number while an array of
// them grows: a picture of 4096 x 4096 pixels would take three gigabytes. So planes are read to
// their own type of number as the line is parsed, and lie in the document as binary values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "wire/json_values.h"

namespace edgecase::wire {

// As parse_text. An array under the key of a plane, in the line or in one of its passes, becomes a
// binary value; what a plane cannot hold is refused with its place.
nlohmann::json parse_answer_text(std::string_view line);

// Such a plane, which must have `size` elements; value types are those of Rendering. Refuses what
// is no array.
template <class Number>
std::vector<Number> read_plane(const nlohmann::json& value, const Path& path, std::size_t size);
extern template std::vector<std::uint8_t> read_plane(const nlohmann::json&, const Path&,
                                                     std::size_t);
extern template std::vector<std::uint32_t> read_plane(const nlohmann::json&, const Path&,
                                                      std::size_t);
extern template std::vector<double> read_plane(const nlohmann::json&, const Path&, std::size_t);

}  // namespace edgecase::wire
