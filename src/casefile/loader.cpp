// SPDX-License-Identifier: MIT
#include "casefile/loader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "casefile/case_reader.h"
#include "casefile/expectation.h"
#include "casefile/json/fields.h"
#include "casefile/json/json_document.h"
#include "casefile/json/text.h"
#include "casefile/mesh/mesh.h"
#include "casefile/scene/samples.h"
#include "casefile/scene/textures.h"
#include "casefile/sweep/sweep.h"
#include "casefile/sweep/variants.h"
#include "model/case.h"

namespace edgecase {
namespace {

// Collects the faults of all cases of one file, so that each is reported once.
//
// A fault of every combination of a sweep is one of the file. Any other fault is reported with the
// values of the axes, or the image, of its first case and the number of others.

class FaultSheet {
 public:
  // Adds the findings of one combination; `label` names it: "dx=0.5, dy=1".
  void add(std::vector<Diagnostic> faults, const std::string& label) { add(faults, label, false); }
  // The same for an image of a combination: "dx=0.5, dy=1, octant=3".
  void add_of_image(std::vector<Diagnostic> faults, const std::string& label) {
    add(faults, label, true);
  }

  bool empty() const { return entries_.empty(); }
  // Whether there are enough faults that reading more cases would not help.
  bool full() const { return entries_.size() >= kMost; }

  // Hands over all faults; `combinations` is the number that were read.
  void move_to(Findings& findings, std::size_t combinations);

 private:
  static constexpr std::size_t kMost = 20;
  void add(std::vector<Diagnostic>& faults, const std::string& label, bool image);

  struct Entry {
    Diagnostic fault;
    std::string label;      // of its first case
    bool image = false;     // whether the first case is an image
    std::size_t count = 0;  // the number of its cases
  };
  std::vector<Entry> entries_;
  std::map<std::string, std::size_t> index_;  // by text of the fault
};

void FaultSheet::add(std::vector<Diagnostic>& faults, const std::string& label, bool image) {
  for (Diagnostic& fault : faults) {
    const auto [found, fresh] = index_.emplace(to_string(fault), entries_.size());
    if (fresh) entries_.push_back({std::move(fault), label, image, 0});
    ++entries_[found->second].count;
  }
}

void FaultSheet::move_to(Findings& findings, std::size_t combinations) {
  for (Entry& entry : entries_) {
    if (entry.image || entry.count < combinations) {
      const std::string more =
          entry.count == 1 ? "" : fmt::format(", and in {} more", entry.count - 1);
      entry.fault.message += fmt::format(" (with {}{})", entry.label, more);
    }
    findings.add(std::move(entry.fault));
  }
  entries_.clear();
  index_.clear();
}

// From one file to its cases: every combination of its sweep, and every image of each.
//
// Each combination is substituted into the tree of the file and read by the ordinary reader, so
// that an expanded case gets the same checks as a written one. Images are made from what was read.
//
// Ids: PATH for a file without sweep and variants. Otherwise PATH, then ":AXIS=VALUE" for every
// axis in the order of the file, then ":reverse", ":winding", ":octant=1" to ":octant=7" or
// ":translate=3,2" for an image. Unspecified colours are derived from that id.

// The product of a file's cases and its size in bytes, which limits the cost of a hostile sweep.
constexpr std::size_t kMaxExpandedBytes = std::size_t{64} << 20;

struct CaseOrigin {
  std::filesystem::path file;
  std::string id;  // of the file: path without suffix
  std::string_view text;
  std::span<const std::string> known_rules;
};

std::optional<Place> member_of(const JsonNode& root, std::string_view name) {
  const Place place{&root, ""};
  for (std::size_t i = 0; root.kind == JsonKind::object && i < root.children.size(); ++i)
    if (root.children[i].name == name) return place.child(i);
  return std::nullopt;
}

// The cases that a file stands for.
struct Plan {
  Sweep sweep;
  Variants variants{{}, {Image{}}};
  std::vector<When> conditions;
};

Plan read_plan(const JsonNode& root, Findings& findings) {
  Plan plan;
  if (const auto place = member_of(root, "sweep")) plan.sweep = read_sweep(*place, findings);
  if (const auto place = member_of(root, "variants"))
    plan.variants = read_variants(*place, findings);
  if (!findings.empty()) return plan;  // conditions on faulty axes would only add misleading faults
  if (const auto place = member_of(root, "expect"))
    plan.conditions = read_conditions(*place, plan.sweep, plan.variants, findings);
  return plan;
}

void check_size(const Plan& plan, const JsonNode& root, std::size_t bytes, Findings& findings) {
  const std::size_t combinations = count_combinations(plan.sweep);
  const std::size_t images = plan.variants.images.size();
  const std::size_t cases = combinations * images;
  auto place = member_of(root, "sweep");
  if (!place) place = member_of(root, "variants");
  if (!place) return;
  if (cases > kMaxCases) {
    findings.add(*place,
                 fmt::format("the file stands for {} cases, {} combinations with {} images each",
                             cases, combinations, images),
                 fmt::format("write {} cases at most, in several files if need be", kMaxCases));
  } else if (cases * bytes > kMaxExpandedBytes) {
    findings.add(*place, fmt::format("the file stands for {} cases of {} bytes each", cases, bytes),
                 "use fewer values, or a smaller file");
  }
}

// The tree, which is copied for every combination, without the lists that were read already.
JsonNode without_lists(const JsonNode& root) {
  JsonNode result = root;
  for (JsonNode& member : result.children)
    if (member.name == "sweep" || member.name == "variants" || member.name == "expect")
      member.children.clear();
  return result;
}

// A mask shows covered samples, but not by which of several primitives.
void check_primitives(const Place& drawing, std::size_t count, Findings& findings) {
  if (count != 1)
    findings.add(drawing,
                 fmt::format("\"masks\" is of one primitive, and the case draws {}", count),
                 "give each primitive a case of its own, or leave the drawing out");
}

class Expansion {
 public:
  Expansion(const JsonNode& root, const CaseOrigin& origin, Plan plan, Findings& findings)
      : root_(root),
        scene_(without_lists(root)),
        origin_(origin),
        plan_(std::move(plan)),
        findings_(findings),
        meshes_(origin.file),
        textures_(origin.file) {}

  std::vector<Case> run();
  // The names of all cases, and the first one; nothing if that one has faults.
  std::optional<FileOutline> outline();
  // Reads the file as written, to find other faults although its sweep is unusable.
  void read_as_written();

 private:
  CaseName name_of(const Combination& combination, const Image& image) const;
  // Adds a combination's case and the given images of it.
  void expand(const Combination& combination, std::span<const Image> images);
  void expand_images(const CaseFields& fields, const Combination& combination,
                     std::span<const Image> images);
  Case make_case(const CaseFields& fields, const Combination& combination, const Image& image,
                 Findings& findings);
  void gather_notes(Findings& findings);
  void check_conditions();

  const JsonNode& root_;
  const JsonNode scene_;  // the tree into which combinations are substituted
  const CaseOrigin& origin_;
  Plan plan_;
  Findings& findings_;
  MeshShelf meshes_;
  TextureShelf textures_;
  FaultSheet sheet_;
  std::set<std::string> notes_;  // already reported
  std::set<std::size_t> used_;   // drawings that apply to some case
  std::vector<Case> cases_;
};

std::vector<Case> Expansion::run() {
  const std::vector<Combination> combinations = all_combinations(plan_.sweep);
  std::size_t read = 0;
  for (; read < combinations.size() && !sheet_.full(); ++read)
    expand(combinations[read], plan_.variants.images);
  if (sheet_.empty()) check_conditions();
  sheet_.move_to(findings_, read);
  if (read < combinations.size())
    findings_.add(*member_of(root_, "sweep"),
                  fmt::format("only {} of {} combinations were read, since so much is wrong", read,
                              combinations.size()),
                  "put the other faults right first");
  return std::move(cases_);
}

std::optional<FileOutline> Expansion::outline() {
  const std::vector<Combination> combinations = all_combinations(plan_.sweep);
  expand(combinations.front(), {});
  if (!sheet_.empty()) return std::nullopt;
  FileOutline outline{{}, std::move(cases_.front())};
  for (const Combination& combination : combinations)
    for (const Image& image : plan_.variants.images)
      outline.names.push_back(name_of(combination, image));
  return outline;
}

void Expansion::read_as_written() {
  read_case_fields(root_, origin_.known_rules, meshes_, textures_, findings_);
  const auto expect = member_of(root_, "expect");
  if (!expect || expect->node->kind != JsonKind::array) return;
  Target unknown;
  unknown.samples = 0;
  for (std::size_t i = 0; i < expect->node->children.size(); ++i)
    read_drawing(expect->child(i), unknown, origin_.file.parent_path(), findings_);
}

CaseName Expansion::name_of(const Combination& combination, const Image& image) const {
  CaseName name{origin_.id, parts_of(plan_.sweep, combination)};
  if (image.kind != VariantKind::none) name.parts.push_back(image.part());
  for (const std::string& part : name.parts) name.id += ":" + part;
  return name;
}

void Expansion::expand(const Combination& combination, std::span<const Image> images) {
  JsonNode tree = scene_;
  Findings findings(findings_.file());
  substitute(plan_.sweep, combination, tree, findings);
  const CaseFields fields =
      read_case_fields(tree, origin_.known_rules, meshes_, textures_, findings);
  if (findings.empty()) check_variants(plan_.variants, fields.draws, findings);
  Case base = make_case(fields, combination, Image{}, findings);
  const bool sound = findings.empty();
  gather_notes(findings);
  sheet_.add(findings.take(), fmt::format("{}", fmt::join(base.parts, ", ")));
  if (!sound) return;
  cases_.push_back(std::move(base));
  expand_images(fields, combination, images);
}

void Expansion::expand_images(const CaseFields& fields, const Combination& combination,
                              std::span<const Image> images) {
  for (const Image& image : images) {
    if (image.kind == VariantKind::none) continue;
    Findings findings(findings_.file());
    Case made = make_case(fields, combination, image, findings);
    sheet_.add_of_image(findings.take(), fmt::format("{}", fmt::join(made.parts, ", ")));
    cases_.push_back(std::move(made));
  }
}

Case Expansion::make_case(const CaseFields& fields, const Combination& combination,
                          const Image& image, Findings& findings) {
  Case result = fields.words;
  result.file = origin_.file;
  CaseName name = name_of(combination, image);
  result.id = std::move(name.id);
  result.parts = std::move(name.parts);
  TargetFields target = fields.target;
  std::vector<DrawFields> draws = fields.draws;
  if (fields.draws_place) apply_image(image, target, draws, *fields.draws_place, findings);
  std::vector<Place> drawings;
  for (std::size_t i = 0; i < plan_.conditions.size(); ++i) {
    if (!holds(plan_.conditions[i], plan_.sweep, combination, image)) continue;
    used_.insert(i);
    drawings.push_back(member_of(root_, "expect")->child(i));
    check_no_drawing(target, drawings.back(), findings);
    result.expect.push_back(
        read_drawing(drawings.back(), target.target, origin_.file.parent_path(), findings));
  }
  if (fields.draws_place)
    result.scene = complete_scene(target, draws, result.id, *fields.draws_place, findings);
  result.scene.details = fields.details;
  result.scene.textures = fields.textures;
  if (findings.empty()) check_pass_work(result.scene, target, findings);
  // The primitives of a faulty scene are unknown.
  const bool sound = findings.empty();
  for (std::size_t i = 0; sound && i < drawings.size(); ++i)
    if (!result.expect[i].masks.empty())
      check_primitives(drawings[i], primitives_of(result.scene).size(), findings);
  return result;
}

void Expansion::gather_notes(Findings& findings) {
  for (Diagnostic& note : findings.take_notes())
    if (notes_.insert(to_string(note)).second) findings_.note(std::move(note));
}

void Expansion::check_conditions() {
  for (std::size_t i = 0; i < plan_.conditions.size(); ++i)
    if (!used_.contains(i))
      findings_.add(plan_.conditions[i].place, "when holds for none of the file's cases",
                    "name values that occur together");
}

// The expansion of a file whose plan has no fault. `of_plan` gets the faults and notes of the plan.
Expansion expansion_of(const JsonNode& root, const CaseOrigin& origin, Findings& of_plan,
                       Findings& findings) {
  Plan plan = read_plan(root, of_plan);
  if (of_plan.empty()) check_size(plan, root, origin.text.size(), of_plan);
  return {root, origin, std::move(plan), findings};
}

// All cases of a file: combinations in the order of the sweep, the last axis fastest, each followed
// by its images. Faults are reported once, with the axes' values unless every combination has them.
// The result is incomplete if there are findings.
std::vector<Case> expand_cases(const JsonNode& root, const CaseOrigin& origin, Findings& findings) {
  Findings of_plan(findings.file());
  Expansion expansion = expansion_of(root, origin, of_plan, findings);
  const bool sound = of_plan.empty();
  for (Diagnostic& note : of_plan.take_notes()) findings.note(std::move(note));
  for (Diagnostic& fault : of_plan.take()) findings.add(std::move(fault));
  if (sound) return expansion.run();
  expansion.read_as_written();
  return {};
}

// The number of faults listed; more would not help.
constexpr std::size_t kMostFaults = 1000;

void shorten(std::vector<Diagnostic>& faults) {
  if (faults.size() <= kMostFaults) return;
  const std::size_t more = faults.size() - kMostFaults;
  faults.resize(kMostFaults);
  faults.push_back({faults.back().file, faults.back().line, "",
                    fmt::format("{} more faults are not listed", more), "put these right first"});
}

}  // namespace

LoadedCases load_cases(const std::filesystem::path& file, const std::string& id,
                       std::span<const std::string> known_rules) {
  const TextFile read = read_text_file(file, kMaxFileBytes);
  if (!read.text) return {{}, {unreadable(file, read)}, {}};
  return load_cases_text(*read.text, file, id, known_rules);
}

LoadedCases load_cases_text(const std::string& text, const std::filesystem::path& file,
                            const std::string& id, std::span<const std::string> known_rules) {
  Findings findings(file.generic_string());
  std::optional<JsonNode> root = parse_json(text, findings);
  LoadedCases loaded;
  if (root) loaded.cases = expand_cases(*root, {file, id, text, known_rules}, findings);
  loaded.notes = findings.take_notes();
  loaded.diagnostics = findings.take();
  shorten(loaded.diagnostics);
  if (!loaded.diagnostics.empty()) loaded.cases.clear();
  const SharedText source(text);
  for (Case& one : loaded.cases) one.source = source;
  return loaded;
}

std::optional<FileOutline> outline_cases(const std::filesystem::path& file, const std::string& id,
                                         std::span<const std::string> known_rules) {
  const TextFile read = read_text_file(file, kMaxFileBytes);
  if (!read.text) return std::nullopt;
  Findings findings(file.generic_string());
  const std::optional<JsonNode> root = parse_json(*read.text, findings);
  if (!root || !findings.empty()) return std::nullopt;
  const CaseOrigin origin{file, id, *read.text, known_rules};
  Expansion expansion = expansion_of(*root, origin, findings, findings);
  if (!findings.empty()) return std::nullopt;
  std::optional<FileOutline> outline = expansion.outline();
  if (outline) outline->first.source = *read.text;
  return outline;
}

}  // namespace edgecase
