// SPDX-License-Identifier: MIT
#include "rules/coverage/tie_rule.h"

#include <fmt/format.h>

#include <vector>

namespace edgecase {
namespace {

using Kind = TieRule::Kind;

constexpr TieRule kTieRules[] = {
    {"left-bottom", Kind::perturbed, 1, 0, 0, 1},
    {"left-top", Kind::perturbed, 1, 0, 0, -1},
    {"right-bottom", Kind::perturbed, -1, 0, 0, 1},
    {"right-top", Kind::perturbed, -1, 0, 0, -1},
    {"bottom-left", Kind::perturbed, 0, 1, 1, 0},
    {"bottom-right", Kind::perturbed, 0, 1, -1, 0},
    {"top-left", Kind::perturbed, 0, -1, 1, 0},
    {"top-right", Kind::perturbed, 0, -1, -1, 0},
    {"open", Kind::open, 0, 0, 0, 0},
    {"closed", Kind::closed, 0, 0, 0, 0},
};

// "+e" or "-e^2": one component of the move.
std::string component(int first, int second) {
  const int direction = first != 0 ? first : second;
  return fmt::format("{}{}", direction > 0 ? "+" : "-", first != 0 ? "e" : "e^2");
}

std::string meaning_of(const TieRule& rule) {
  if (rule.kind == Kind::open) return "boundaries never count as inside";
  if (rule.kind == Kind::closed) return "boundaries always count as inside";
  return fmt::format("a sample on a boundary moves by ({}, {}), y up",
                     component(rule.first_x, rule.second_x),
                     component(rule.first_y, rule.second_y));
}

}  // namespace

std::span<const TieRule> all_tie_rules() {
  return kTieRules;
}

const TieRule* find_tie_rule(std::string_view name) {
  for (const TieRule& rule : kTieRules)
    if (name == rule.name) return &rule;
  return nullptr;
}

const TieRule& open_ties() {
  static const TieRule& rule = *find_tie_rule("open");
  return rule;
}

const TieRule& closed_ties() {
  static const TieRule& rule = *find_tie_rule("closed");
  return rule;
}

std::vector<Alternative> tie_alternatives(std::span<const TieRule> rules, Openness perturbed,
                                          Openness open_and_closed) {
  std::vector<Alternative> result;
  for (const TieRule& rule : rules)
    result.push_back({std::string(rule.name),
                      rule.kind == Kind::perturbed ? perturbed : open_and_closed,
                      meaning_of(rule)});
  return result;
}

namespace {

std::vector<DiamondBoundary> make_boundaries() {
  std::vector<DiamondBoundary> result;
  for (const TieRule& rule : all_tie_rules()) result.push_back({rule.name, &rule, 0, 0});
  const unsigned lower = kLowerLeftEdge | kLowerRightEdge | kBottomCorner;
  result.push_back({"direct3d", nullptr, lower, lower | kRightCorner});
  const unsigned edges = kLowerLeftEdge | kLowerRightEdge | kUpperLeftEdge | kUpperRightEdge;
  const unsigned scotty = edges | kLeftCorner | kBottomCorner;
  result.push_back({"scotty3d", nullptr, scotty, scotty});
  return result;
}

}  // namespace

std::span<const DiamondBoundary> all_diamond_boundaries() {
  static const std::vector<DiamondBoundary> boundaries = make_boundaries();
  return boundaries;
}

const DiamondBoundary* find_diamond_boundary(std::string_view name) {
  for (const DiamondBoundary& boundary : all_diamond_boundaries())
    if (boundary.name == name) return &boundary;
  return nullptr;
}

}  // namespace edgecase
