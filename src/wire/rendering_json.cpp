// SPDX-License-Identifier: MIT
//
// Pixels and fragments are the bulk of all messages and need no escaping: formatting them straight
// into the text is several times faster than building a tree of JSON values.
#include "wire/rendering_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "model/rendering_fields.h"
#include "wire/json_values.h"

namespace edgecase {

namespace {

using wire::Output;

// A double as the shortest decimal that reads back as the same double.
void write_number(Output out, double value) {
  if (!wire::write_not_finite(out, value)) fmt::format_to(out, "{}", value);
}

std::string numbers_json(const std::vector<double>& numbers) {
  fmt::memory_buffer text;
  const Output out(text);
  text.push_back('[');
  for (const double number : numbers) {
    if (text.size() > 1) text.push_back(',');
    write_number(out, number);
  }
  text.push_back(']');
  return fmt::to_string(text);
}

template <std::size_t N>
void write_numbers(Output out, const std::array<double, N>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    *out++ = i == 0 ? '[' : ',';
    write_number(out, numbers[i]);
  }
  *out++ = ']';
}

template <std::size_t N>
void write_reported(Output out, const char* key,
                    const std::optional<std::array<double, N>>& numbers) {
  if (!numbers) return;
  fmt::format_to(out, ",\"{}\":", key);
  write_numbers(out, *numbers);
}

// Writes several as an object of those that are reported.
void write_reported(Output out, const char* key, const DerivativeValues& derivatives) {
  if (!is_reported(derivatives)) return;
  fmt::format_to(out, ",\"{}\":", key);
  char before = '{';
  for (std::size_t i = 0; i < kDerivatives; ++i) {
    if (!derivatives[i]) continue;
    fmt::format_to(out, "{}\"{}\":", before, kNames<Derivative>[i].name);
    write_numbers(out, *derivatives[i]);
    before = ',';
  }
  *out++ = '}';
}

void write_detail(Output out, const FragmentDetail& detail) {
  for_each_field<FragmentDetail>(
      [&](const auto& field) { write_reported(out, field.key, detail.*field.member); });
}

void write_fragment(Output out, const Rendering& rendering, const Fragment& fragment) {
  fmt::format_to(out, R"({{"x":{},"y":{},"primitive":{},"coverage":{})", fragment.x, fragment.y,
                 fragment.primitive, fragment.coverage);
  if (fragment.has_depth) {
    fmt::format_to(out, ",\"depth\":");
    write_number(out, fragment.depth);
  }
  if (fragment.has_color) {
    fmt::format_to(out, ",\"color\":");
    write_numbers(out, fragment.color);
  }
  if (fragment.detail >= 0)
    write_detail(out, rendering.details[static_cast<std::size_t>(fragment.detail)]);
  *out++ = '}';
}

}  // namespace

std::string fragments_json(const Rendering& rendering) {
  fmt::memory_buffer text;
  const Output out(text);
  text.push_back('[');
  for (const Fragment& fragment : rendering.fragments) {
    if (text.size() > 1) text.push_back(',');
    write_fragment(out, rendering, fragment);
  }
  text.push_back(']');
  return fmt::to_string(text);
}

std::string pixels_json(const Rendering& rendering) {
  return fmt::format("[{}]", fmt::join(rendering.pixels, ","));
}

std::string sample_positions_json(const Rendering& rendering) {
  fmt::memory_buffer text;
  wire::write_positions(Output(text), rendering.sample_positions);
  return fmt::to_string(text);
}

std::string sample_pixels_json(const Rendering& rendering) {
  return fmt::format("[{}]", fmt::join(rendering.sample_pixels, ","));
}

std::string depths_json(const Rendering& rendering) {
  return numbers_json(rendering.depths);
}

std::string stencils_json(const Rendering& rendering) {
  return fmt::format("[{}]", fmt::join(rendering.stencils, ","));
}

std::string accumulated_json(const Rendering& rendering) {
  return numbers_json(rendering.accumulated);
}

std::string hits_json(const Rendering& rendering) {
  return fmt::format("[{}]", fmt::join(rendering.hits, ","));
}

std::string passes_json(const Rendering& rendering) {
  std::string text = "[";
  for (const Rendering& pass : rendering.passes) {
    if (text.size() > 1) text += ',';
    text += "{\"pixels\":" + pixels_json(pass) + ",\"fragments\":" + fragments_json(pass);
    if (!pass.depths.empty()) text += ",\"depths\":" + depths_json(pass);
    if (!pass.mip_chains.empty()) text += ",\"mip_chains\":" + mip_chains_json(pass);
    if (!pass.hits.empty()) text += ",\"hits\":" + hits_json(pass);
    text += '}';
  }
  return text + "]";
}

std::string mip_chains_json(const Rendering& rendering) {
  fmt::memory_buffer text;
  const Output out(text);
  text.push_back('{');
  for (const auto& [texture, levels] : rendering.mip_chains) {
    fmt::format_to(out, "{}\"{}\":[", text.size() > 1 ? "," : "", texture);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (i > 0) text.push_back(',');
      wire::write_level(out, levels[i]);
    }
    text.push_back(']');
  }
  text.push_back('}');
  return fmt::to_string(text);
}

std::string rendering_json(const std::string& id, const Rendering& rendering) {
  const std::string positions = rendering.sample_positions.empty()
                                    ? ""
                                    : ",\"sample_positions\":" + sample_positions_json(rendering);
  const std::string samples =
      rendering.sample_pixels.empty() ? "" : ",\"sample_pixels\":" + sample_pixels_json(rendering);
  const std::string depths =
      rendering.depths.empty() ? "" : ",\"depths\":" + depths_json(rendering);
  const std::string stencils =
      rendering.stencils.empty() ? "" : ",\"stencils\":" + stencils_json(rendering);
  const std::string chains =
      rendering.mip_chains.empty() ? "" : ",\"mip_chains\":" + mip_chains_json(rendering);
  const std::string passes = rendering.passes.empty()
                                 ? ""
                                 : ",\"accumulated\":" + accumulated_json(rendering) +
                                       ",\"passes\":" + passes_json(rendering);
  return fmt::format(
      R"({{"id":{},"width":{},"height":{},"samples":{},"fragments":{},"pixels":{}{}{}{}{}{}{}}})",
      nlohmann::json(id).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace),
      rendering.width, rendering.height, rendering.samples, fragments_json(rendering),
      pixels_json(rendering), positions, samples, depths, stencils, chains, passes);
}

}  // namespace edgecase
