// SPDX-License-Identifier: MIT
#include "casefile/scene/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "casefile/json/numbers.h"
#include "casefile/json/text.h"
#include "casefile/scene/forms.h"
#include "casefile/scene/patterns.h"
#include "model/scene_faults.h"

namespace edgecase {

namespace {

// Over all pixels of a target: one for each pixel of the largest.
constexpr int kMaxTargetSamples = 1 << 24;
// Within a pixel: 0 to below 1.
constexpr FixedRange kWithinPixel{Fixed(), Fixed::from_raw(Fixed::kOne - 1)};

constexpr const char* kMask = "sample_mask";

Point read_position(const Place& place, Findings& findings) {
  if (!expect_count(place, "a sample position", 2, findings)) return {};
  const auto read = [&](std::size_t index, const char* what) {
    return read_coordinate(place.child(index), what, kWithinPixel, findings).value_or(Fixed());
  };
  return {read(0, "x of a sample"), read(1, "y of a sample")};
}

SamplePositions read_positions(const Place& place, int samples, Findings& findings) {
  SamplePositions positions;
  if (!expect_kind(place, JsonKind::array, "sample_positions", findings)) return positions;
  const std::size_t count = place.node->children.size();
  if (samples > 0 && count != static_cast<std::size_t>(samples))
    findings.add(
        place,
        fmt::format("sample_positions has {} points, and the target {} samples", count, samples),
        fmt::format("write {} points [x, y]", samples));
  for (std::size_t i = 0; i < count; ++i)
    positions.push_back(read_position(place.child(i), findings));
  return positions;
}

// These would have no effect, and ignored keys would seem to be tested.
void refuse_of_one_sample(const ObjectReader& state, Findings& findings) {
  for (const std::string& name : multisampling_keys())
    if (const auto place = state.find(name))
      findings.add_key(*place,
                       fmt::format("{} is for several samples, and the target has 1", quote(name)),
                       "write \"samples\": 4 into the target, or remove the key");
}

}  // namespace

std::vector<std::string> multisampling_keys() {
  std::vector<std::string> keys = keys_of<Multisampling>();
  keys.emplace_back(kMask);
  return keys;
}

void read_samples(const ObjectReader& object, TargetFields& fields, Findings& findings) {
  Target& target = fields.target;
  if (const auto samples = object.find("samples"))
    target.samples = read_integer(*samples, "samples", {1, kMaxSamples}, findings).value_or(0);
  const int all = target.width * target.height * target.samples;  // at most 2^28
  if (all > kMaxTargetSamples)
    findings.add(*object.find("samples"),
                 fmt::format("{} x {} pixels of {} samples are {} samples", target.width,
                             target.height, target.samples, all),
                 fmt::format("use fewer samples or a smaller target: {} samples at most in all",
                             kMaxTargetSamples));
  const auto surface = object.find("surface");
  if (surface && target.samples > 1 && target.surface == Surface::window)
    findings.add(*surface, "a window's samples cannot be chosen",
                 "write \"fbo\", or \"samples\": 1");
  fields.positions_place = object.find("sample_positions");
  if (!fields.positions_place) return;
  if (target.samples == 1)
    findings.add_key(*fields.positions_place,
                     "\"sample_positions\" is for several samples, and the target has 1",
                     "write \"samples\", the number of points, or remove the key");
  else
    target.sample_positions = read_positions(*fields.positions_place, target.samples, findings);
}

Multisampling read_multisampling(const ObjectReader& state, int samples, Findings& findings) {
  Multisampling result;
  if (samples == 1) {
    refuse_of_one_sample(state, findings);
    return result;
  }
  read_fields(state, findings, result);
  const int bits = samples > 0 ? samples : kMaxSamples;
  if (const auto mask = state.find(kMask))
    if (const auto value = read_integer(*mask, kMask, {0, (1 << bits) - 1}, findings))
      result.mask = static_cast<std::uint32_t>(*value);
  return result;
}

namespace {

constexpr const char* kSupersample = "supersample";
const Keys kSupersampleKeys{
    {},
    {"grid", "jittered", "n-rooks", "random", "samples", "seed", "weights", "kernel", "radius"},
    {}};
const std::vector<std::string> kPatterns{"grid", "jittered", "n-rooks", "random", "samples"};
constexpr int kMaxCount = static_cast<int>(kMaxPasses);
constexpr int kMaxWeight = static_cast<int>(kMaxPassWeight);

constexpr FixedRange kRoundPixel{Fixed::from_integer(kLeastPlace),
                                 Fixed::from_integer(kLargestPlace)};
constexpr FixedRange kRadii{Fixed::from_raw(1), kMaxRadius};

// The only key that names a pattern; nothing, and a finding, if there is not exactly one.
std::optional<Place> find_pattern(const Place& place, const ObjectReader& object,
                                  Findings& findings) {
  std::vector<std::string> given;
  for (const std::string& name : kPatterns)
    if (object.find(name)) given.push_back(name);
  if (given.size() == 1) return object.find(given[0]);
  findings.add(place,
               given.empty() ? std::string("supersample has no pattern")
                             : fmt::format("supersample has all of {}", join_names(given)),
               "give exactly one of " + join_names(kPatterns));
  return std::nullopt;
}

void refuse_beside(const ObjectReader& object, const char* key, const std::string& pattern,
                   const char* remedy, Findings& findings) {
  if (const auto place = object.find(key))
    findings.add_key(*place, fmt::format("{} has no use beside {}", quote(key), quote(pattern)),
                     remedy);
}

std::optional<std::uint64_t> read_seed(const Place& place, const ObjectReader& object,
                                       const std::string& pattern, Findings& findings) {
  const auto given = object.find("seed");
  if (!given) {
    findings.add(place, fmt::format("{} lacks a seed", quote(pattern)), "add \"seed\": 1");
    return std::nullopt;
  }
  const auto seed = read_integer(*given, "a seed", {0, kMaxSeed}, findings);
  if (!seed) return std::nullopt;
  return static_cast<std::uint64_t>(*seed);
}

// A pattern that is given by its size.
Pattern read_sized(const Place& place, const Place& size, const ObjectReader& object,
                   Findings& findings) {
  const std::string& name = size.node->name;
  const bool cells = name == "grid" || name == "jittered";
  const auto n = read_integer(size, name, {1, cells ? kMaxSide : kMaxCount}, findings);
  if (name == "grid") {
    refuse_beside(object, "seed", name, "remove it: nothing of a grid is random", findings);
    return n ? grid_pattern(*n) : Pattern{};
  }
  const auto seed = read_seed(place, object, name, findings);
  if (!n || !seed) return {};
  if (name == "jittered") return jittered_pattern(*n, *seed);
  return name == "n-rooks" ? n_rooks_pattern(*n, *seed) : random_pattern(*n, *seed);
}

Pattern read_listed(const Place& place, FixedRange range, Findings& findings) {
  if (!expect_kind(place, JsonKind::array, "samples", findings)) return {};
  const std::size_t count = place.node->children.size();
  if (count < 1 || count > kMaxPasses) {
    findings.add(place, fmt::format("samples has {} points", count),
                 fmt::format("write 1 to {} points [x, y]", kMaxPasses));
    return {};
  }
  Pattern pattern;
  for (std::size_t i = 0; i < count; ++i) {
    const Place at = place.child(i);
    if (!expect_count(at, "a sample", 2, findings)) continue;
    const auto x = read_coordinate(at.child(0), "x of a sample", range, findings);
    const auto y = read_coordinate(at.child(1), "y of a sample", range, findings);
    if (x && y) pattern.push_back({*x, *y});
  }
  return pattern;
}

// Reads one weight for each pass; without weights each counts 1.
void read_weights(const Place& place, Supersampling& passes, Findings& findings) {
  if (!expect_kind(place, JsonKind::array, "weights", findings)) return;
  const std::size_t count = place.node->children.size();
  if (count != passes.size()) {
    findings.add(place, fmt::format("weights has {} numbers, and samples {}", count, passes.size()),
                 "write a weight for each sample");
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
    passes[i].weight = read_integer(place.child(i), "a weight", {1, kMaxWeight}, findings)
                           .value_or(static_cast<int>(passes[i].weight));
}

// The filter of a file; `given`: whether the file has one.
struct GivenFilter {
  ReconstructionFilter filter;
  bool given = false;
};

GivenFilter read_filter(const ObjectReader& object, Findings& findings) {
  GivenFilter result;
  ReconstructionFilter& filter = result.filter;
  const auto kernel = object.find("kernel");
  if (kernel) read_plain(*kernel, "a kernel", {}, findings, filter.kernel);
  if (filter.kernel != Kernel::box) filter.radius = Fixed::from_integer(1);
  const auto radius = object.find("radius");
  if (radius)
    filter.radius = read_coordinate(*radius, "a radius", kRadii, findings).value_or(filter.radius);
  result.given = kernel.has_value() || radius.has_value();
  return result;
}

// The passes of a pattern without a filter; each counts 1.
Supersampling as_listed(const Pattern& pattern) {
  Supersampling passes;
  for (const Point at : pattern) passes.push_back({at, 1});
  return passes;
}

Supersampling read_passes(const Place& place, const ObjectReader& object, Findings& findings) {
  const auto pattern = find_pattern(place, object, findings);
  const GivenFilter given = read_filter(object, findings);
  if (!pattern) return {};
  const std::string& name = pattern->node->name;
  const auto weights = object.find("weights");
  if (name != "samples") {
    refuse_beside(object, "weights", name, "remove it, or list the samples", findings);
    return filtered(read_sized(place, *pattern, object, findings), given.filter);
  }
  refuse_beside(object, "seed", name, "remove it: the samples are listed", findings);
  if (weights && given.given) {
    findings.add_key(*weights, "\"weights\" stands beside a kernel, which gives weights itself",
                     "keep one of them");
    return {};
  }
  if (given.given) return filtered(read_listed(*pattern, kWithinPixel, findings), given.filter);
  const std::size_t before = findings.size();
  Supersampling passes = as_listed(read_listed(*pattern, kRoundPixel, findings));
  if (weights && findings.size() == before) read_weights(*weights, passes, findings);
  return passes;
}

}  // namespace

void read_supersample(const ObjectReader& object, TargetFields& fields, Findings& findings) {
  fields.supersample_place = object.find(kSupersample);
  if (!fields.supersample_place) return;
  const Place& place = *fields.supersample_place;
  if (fields.target.samples > 1)
    findings.add_key(place,
                     fmt::format("\"supersample\" draws to one sample, and the target has {}",
                                 fields.target.samples),
                     "remove it, or \"samples\"");
  const std::size_t before = findings.size();
  const ObjectReader own(place, kSupersample, kSupersampleKeys, findings);
  if (findings.size() != before) return;  // an unknown key may be a misspelt pattern
  fields.supersampling = read_passes(place, own, findings);
  if (findings.size() != before) return;
  const std::size_t count = fields.supersampling.size();
  if (count == 0)
    findings.add(place, "no sample of the pattern lies within the kernel's radius",
                 "use a larger radius");
  if (count > kMaxPasses)
    findings.add(place, fmt::format("supersample stands for {} passes", count),
                 fmt::format("use {} samples at most, those of neighbouring pixels that the "
                             "kernel reaches included",
                             kMaxPasses));
}

void check_pass_work(const Scene& scene, const TargetFields& fields, Findings& findings) {
  if (const auto fault = fault_of_passes(scene))
    findings.add(*fields.supersample_place, fault->text, fault->remedy);
}

void check_no_drawing(const TargetFields& fields, const Place& drawing, Findings& findings) {
  if (fields.supersample_place)
    findings.add(drawing, "a drawing does not tell the passes of a supersampled case apart",
                 "remove it, or give the pass a case of its own");
}

}  // namespace edgecase
