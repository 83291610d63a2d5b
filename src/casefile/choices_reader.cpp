// SPDX-License-Identifier: MIT
#include "casefile/choices_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "casefile/case_reader.h"
#include "casefile/text.h"

namespace edgecase {
namespace {

void check_alternative(const Place& place, const std::string& alternative, const KnownRule& rule,
                       Findings& findings) {
  const auto& names = rule.alternatives;
  if (std::find(names.begin(), names.end(), alternative) == names.end())
    findings.add(place, fmt::format("rule {} has no alternative {}", rule.id, quote(alternative)),
                 suggest_names(alternative, names));
}

}  // namespace

bool check_rule_id(const Place& place, std::span<const KnownRule> known, Findings& findings) {
  const std::string& id = place.node->name;
  if (!is_rule_id(id)) {
    findings.add_key(place, fmt::format("{} is no rule's id", quote(id)),
                     "write an id like line.diamond-exit; `edgecase rules` lists them");
    return false;
  }
  std::vector<std::string> ids;
  for (const KnownRule& rule : known) ids.push_back(rule.id);
  if (ids.empty() || std::find(ids.begin(), ids.end(), id) != ids.end()) return true;
  findings.add_key(place, fmt::format("there is no rule {}", quote(id)), suggest_names(id, ids));
  return false;
}

Choices read_choices(const Place& place, std::span<const KnownRule> known, Findings& findings) {
  Choices choices;
  if (!expect_kind(place, JsonKind::object, "a choice of alternatives", findings)) return choices;
  for (std::size_t i = 0; i < place.node->children.size(); ++i) {
    const Place choice = place.child(i);
    const std::string& id = choice.node->name;
    if (choice.node->duplicate) continue;
    const auto alternative =
        read_text(choice, fmt::format("the alternative of {}", quote(id)), {1, 200}, findings);
    if (!check_rule_id(choice, known, findings) || !alternative) continue;
    const auto rule = std::find_if(known.begin(), known.end(),
                                   [&](const KnownRule& candidate) { return candidate.id == id; });
    if (rule != known.end()) check_alternative(choice, *alternative, *rule, findings);
    choices[id] = *alternative;
  }
  return choices;
}

}  // namespace edgecase
