// SPDX-License-Identifier: MIT
//
// Pixels and fragments are the bulk of everything that travels, and have nothing to escape: they
// are formatted straight into the text, several times faster than through a tree of JSON values.
#include "wire/rendering_json.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace edgecase {

namespace {

using Output = std::back_insert_iterator<fmt::memory_buffer>;

// A double as the shortest decimal that reads back as the same double.
void write_number(Output out, double value) {
  if (std::isnan(value)) {
    fmt::format_to(out, "\"nan\"");
  } else if (std::isinf(value)) {
    fmt::format_to(out, "\"{}inf\"", value > 0 ? "" : "-");
  } else {
    fmt::format_to(out, "{}", value);
  }
}

void write_fragment(Output out, const Fragment& fragment) {
  fmt::format_to(out, R"({{"x":{},"y":{},"primitive":{},"coverage":{})", fragment.x, fragment.y,
                 fragment.primitive, fragment.coverage);
  if (fragment.has_depth) {
    fmt::format_to(out, ",\"depth\":");
    write_number(out, fragment.depth);
  }
  if (fragment.has_color) {
    fmt::format_to(out, ",\"color\":");
    for (std::size_t i = 0; i < fragment.color.size(); ++i) {
      *out++ = i == 0 ? '[' : ',';
      write_number(out, fragment.color[i]);
    }
    *out++ = ']';
  }
  *out++ = '}';
}

}  // namespace

std::string fragments_json(const Rendering& rendering) {
  fmt::memory_buffer text;
  const Output out(text);
  text.push_back('[');
  for (const Fragment& fragment : rendering.fragments) {
    if (text.size() > 1) text.push_back(',');
    write_fragment(out, fragment);
  }
  text.push_back(']');
  return fmt::to_string(text);
}

std::string pixels_json(const Rendering& rendering) {
  return fmt::format("[{}]", fmt::join(rendering.pixels, ","));
}

std::string rendering_json(const std::string& id, const Rendering& rendering) {
  return fmt::format(
      R"({{"id":{},"width":{},"height":{},"samples":{},"fragments":{},"pixels":{}}})",
      nlohmann::json(id).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace),
      rendering.width, rendering.height, rendering.samples, fragments_json(rendering),
      pixels_json(rendering));
}

}  // namespace edgecase
