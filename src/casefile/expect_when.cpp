// SPDX-License-Identifier: MIT
#include "casefile/expect_when.h"

#include <fmt/format.h>

#include <algorithm>

#include "casefile/text.h"

namespace edgecase {
namespace {

void read_variant(const Place& place, const Variants& variants, Findings& findings, When& when) {
  if (!expect_kind(place, JsonKind::string, "a variant", findings)) return;
  std::vector<std::string> parts;
  for (const Image& image : variants.images)
    if (image.kind != VariantKind::none) parts.push_back(image.part());
  when.variant = place.node->text;
  if (std::find(parts.begin(), parts.end(), when.variant) != parts.end()) return;
  findings.add(place, fmt::format("the file has no variant {}", quote(when.variant)),
               parts.empty() ? "add \"variants\"" : suggest_names(when.variant, parts));
}

void read_member(const Place& place, const Sweep& sweep, Findings& findings, When& when) {
  std::vector<std::string> names{"variant"};
  for (std::size_t a = 0; a < sweep.axes.size(); ++a) {
    names.push_back(sweep.axes[a].name);
    if (sweep.axes[a].name != place.node->name) continue;
    if (const auto value = read_value_of(place, sweep.axes[a], findings))
      when.values.emplace_back(a, *value);
    return;
  }
  findings.add_key(place, fmt::format("the file has no axis {}", quote(place.node->name)),
                   suggest_names(place.node->name, names));
}

void read_when(const Place& place, const Sweep& sweep, const Variants& variants, Findings& findings,
               When& when) {
  when.place = place;
  when.given = true;
  if (!expect_kind(place, JsonKind::object, "when", findings)) return;
  if (place.node->children.empty())
    findings.add(place, "when is empty", "name an axis and its value, or remove it");
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place member = place.child(i);
    if (member.node->duplicate) continue;
    if (member.node->name == "variant")
      read_variant(member, variants, findings, when);
    else
      read_member(member, sweep, findings, when);
  }
}

}  // namespace

std::vector<When> read_conditions(const Place& expect, const Sweep& sweep, const Variants& variants,
                                  Findings& findings) {
  std::vector<When> result;
  if (expect.node->kind != JsonKind::array) return result;
  for (std::size_t i = 0; i < expect.node->children.size(); ++i) {
    When when;
    when.place = expect.child(i);
    const JsonNode& drawing = *when.place.node;
    const Place item = when.place;
    for (std::size_t k = 0; drawing.kind == JsonKind::object && k < drawing.children.size(); ++k)
      if (drawing.children[k].name == "when" && !drawing.children[k].duplicate)
        read_when(item.child(k), sweep, variants, findings, when);
    result.push_back(std::move(when));
  }
  return result;
}

bool holds(const When& when, const Sweep& sweep, const Combination& combination,
           const Image& image) {
  if (!when.given) return image.kind == VariantKind::none && combination == base_of(sweep);
  return image.part() == when.variant &&
         std::all_of(when.values.begin(), when.values.end(),
                     [&](const auto& value) { return combination[value.first] == value.second; });
}

}  // namespace edgecase
