// SPDX-License-Identifier: MIT
#include "casefile/policy_reader.h"

#include <utility>

#include "casefile/fields.h"
#include "casefile/text_file.h"

namespace edgecase {
namespace {

const Keys kPolicyKeys{{"name"}, {"$schema", "why", "latitude", "rules", "surfaces"}, {}};
const Keys kSurfaceKeys{{}, {"fbo", "window"}, {}};

void read_policy(const JsonNode& root, std::span<const KnownRule> known, Findings& findings,
                 Policy& policy) {
  const ObjectReader object({&root, ""}, "a policy", kPolicyKeys, findings);
  if (const auto place = object.find("$schema")) read_text(*place, "$schema", {}, findings);
  if (const auto place = object.find("why")) read_text(*place, "why", {0, 10000, true}, findings);
  if (const auto place = object.find("name"))
    policy.name = read_text(*place, "a policy's name", {1, 100}, findings).value_or("");
  if (const auto place = object.find("latitude")) {
    const auto latitude = read_choice(*place, "latitude", {{"opengl", "none"}, {}}, findings);
    policy.latitude = latitude == "none" ? Latitude::none : Latitude::opengl;
  }
  if (const auto place = object.find("rules")) policy.rules = read_choices(*place, known, findings);
  if (const auto place = object.find("surfaces")) {
    const ObjectReader surfaces(*place, "surfaces", kSurfaceKeys, findings);
    for (const Surface surface : {Surface::fbo, Surface::window})
      if (const auto choices = surfaces.find(name_of(surface)))
        policy.surfaces[surface] = read_choices(*choices, known, findings);
  }
}

}  // namespace

LoadedPolicy load_policy(const std::filesystem::path& file, std::span<const KnownRule> known) {
  TextFile read = read_text_file(file, kMaxFileBytes);
  if (read.text) return load_policy_text(*read.text, file, known);
  LoadedPolicy loaded;
  loaded.diagnostics.push_back(
      {file.generic_string(), 0, "", std::move(read.message), std::move(read.remedy)});
  return loaded;
}

LoadedPolicy load_policy_text(const std::string& text, const std::filesystem::path& file,
                              std::span<const KnownRule> known) {
  Findings findings(file.generic_string());
  JsonDocument document = parse_json(text, findings.file());
  for (Diagnostic& diagnostic : document.diagnostics) findings.add(std::move(diagnostic));
  Policy policy;
  if (document.root) read_policy(*document.root, known, findings, policy);
  LoadedPolicy loaded;
  loaded.diagnostics = findings.take();
  if (loaded.diagnostics.empty()) loaded.value = std::move(policy);
  return loaded;
}

}  // namespace edgecase
