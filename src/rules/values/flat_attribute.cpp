// SPDX-License-Identifier: MIT
#include "rules/values/flat_attribute.h"

namespace edgecase {

std::size_t provoking_index(const ScenePrimitive& primitive, ProvokingChoice choice) {
  const bool first = choice == ProvokingChoice::first ||
                     (choice == ProvokingChoice::as_set &&
                      primitive.state->provoking_vertex == ProvokingVertex::first);
  return static_cast<std::size_t>(first ? primitive.provoking_first : primitive.provoking_last);
}

Rule flat_attribute_rule() {
  return {RuleId::attribute_flat,
          "A flat attribute has the value of the provoking vertex, unchanged",
          "13 (flat shading)",
          "none",
          "",
          {},
          {{8,
            "Flat attributes are copied, not computed: any other value than that of the provoking "
            "vertex, to the bit, is a violation."}}};
}

Rule provoking_vertex_rule() {
  return {RuleId::attribute_provoking_vertex,
          "The provoking vertex is the one that the convention in force names",
          "13 (flat shading)",
          "none where the convention can be set, as in OpenGL",
          "as-set",
          alternatives_of<ProvokingChoice>(),
          {}};
}

}  // namespace edgecase
