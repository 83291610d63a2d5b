// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "model/scene.h"
#include "model/text.h"
#include "profile/profile.h"

namespace edgecase {
namespace {

double ulp_of(const std::optional<ValueExample>& example) {
  return example ? example->ulp : 0;
}

double relative_of(const std::optional<ValueExample>& example) {
  return example ? example->relative : 0;
}

// "2^-1: 12, 2^0: 3": the errors in ULP, by the power of two at or below.
void print_histogram(Buffer& out, const ValueErrors& row) {
  if (row.histogram.empty()) return;
  print(out, "    errors by 2^n ULP:");
  const char* separator = " ";
  for (const auto& [exponent, count] : row.histogram) {
    print(out, "{}{}: {}", separator, exponent, count);
    separator = ", ";
  }
  print(out, "\n");
}

void print_example(Buffer& out, const char* what, ValueKind kind,
                   const std::optional<ValueExample>& found) {
  if (!found) return;
  print(out, "    {}: {} at pixel ({}, {}) is {:.9g}, drawn {:.9g}", what,
        component_name(kind, found->component), found->pixel.x, found->pixel.y, found->exact,
        found->rendered);
  if (found->permitted)
    print(out, ", permitted {:.9g} to {:.9g}", found->permitted->low, found->permitted->high);
  print(out, "; {} {}\n", found->id, scene_text(found->scene));
}

// "2^6": the power of two in ULP above the errors of 99 % of the components.
std::string most_of(const ValueErrors& row) {
  const std::optional<int> bound = row.log2_bound(0.99);
  return bound ? fmt::format("2^{}", *bound) : "0";
}

// "12+": there may be more.
std::string beyond_of(const ValueErrors& row) {
  if (row.as_found) return "-";
  return fmt::format("{}{}", row.beyond, row.not_asked > 0 ? "+" : "");
}

void print_row(Buffer& out, const ValueErrors& row) {
  print(out, "  {:<34}{:>10}  {:<9}{:>8}{:>11.4g}{:>13.4g}{:>13.4g}  ",
        row.attribute + (row.as_found ? " *" : ""), row.fragments,
        percent({row.correct, row.components}), most_of(row), row.mean_ulp(), ulp_of(row.worst_ulp),
        relative_of(row.worst_relative));
  print(out, "{:<8} {}\n", beyond_of(row), row.not_numbers);
  print_histogram(out, row);
  print_example(out, "largest in ULP", row.kind, row.worst_ulp);
  print_example(out, "largest of range", row.kind, row.worst_relative);
  print_example(out, "smallest beyond", row.kind, row.smallest_beyond);
}

const char* level_name_of(LevelSource source) {
  return source == LevelSource::query ? "textureQueryLod" : "looked up";
}

void print_found(Buffer& out, const LevelResiduals& row) {
  const FormulaResidual& found = row.found();
  print(out, "  {:<34}{:>10}{:>13.4g}{:>13.4g}  {}\n",
        fmt::format("{}, {}", row.ramp, level_name_of(row.source)), found.fragments, found.mean(),
        found.largest, found.largest <= kMostResidual ? "" : "BEYOND");
  if (!found.worst) return;
  const ResidualExample& worst = *found.worst;
  print(out, "    largest: pixel ({}, {}) reports {:.9g}, formula {:.9g}; {} {}\n", worst.pixel.x,
        worst.pixel.y, worst.reported, worst.formula, worst.id, scene_text(worst.scene));
}

// The mean and the largest residual of one formula over all rows of a source.
std::pair<double, double> over_all(std::span<const LevelResiduals> rows, LevelSource source,
                                   std::size_t formula) {
  FormulaResidual sum;
  for (const LevelResiduals& row : rows) {
    if (row.source != source) continue;
    const FormulaResidual& one = row.formulas[formula];
    sum.fragments += one.fragments;
    sum.sum += one.sum;
    sum.largest = std::max(sum.largest, one.largest);
  }
  return {sum.mean(), sum.largest};
}

void print_formulas(Buffer& out, std::span<const LevelResiduals> rows) {
  print(out, "  {:<60}{:>11}{:>11}{:>11}{:>11}\n", "all formulas, over all ramps", "query mean",
        "largest", "color mean", "largest");
  for (std::size_t i = 0; i < rows[0].formulas.size(); ++i) {
    const FormulaResidual& formula = rows[0].formulas[i];
    const auto [query_mean, query_largest] = over_all(rows, LevelSource::query, i);
    const auto [color_mean, color_largest] = over_all(rows, LevelSource::color, i);
    print(out, "  {:<60}{:>11.3g}{:>11.3g}{:>11.3g}{:>11.3g}\n",
          fmt::format("{} + {}{}", name_of(formula.scale_factor), name_of(formula.log2),
                      formula.is_found ? " (found)" : ""),
          query_mean, query_largest, color_mean, color_largest);
  }
}

void print_counts(Buffer& out, const SampleProfile& samples) {
  for (const AskedSamples& asked : samples.counts)
    print(out, "    {:>2} samples: {}\n", asked.samples,
          asked.refusal.empty() ? "made" : asked.refusal);
}

std::string interval_text(const SampleInterval& interval) {
  return fmt::format("{:g} to {:g}", interval.low.to_double(), interval.high.to_double());
}

void print_positions(Buffer& out, const MeasuredPositions& found) {
  if (found.positions.empty()) {
    print(out, "    positions of {} samples: none are reported\n", found.samples);
    return;
  }
  print(out, "    positions of {} samples, by sweeps of edges: {}\n", found.samples,
        found.placement.empty() ? "no placement that is catalogued" : found.placement);
  for (std::size_t s = 0; s < found.positions.size(); ++s) {
    const MeasuredPosition& one = found.positions[s];
    print(out, "      sample {:>2}: reported ({:g}, {:g}), ", s, one.reported.x.to_double(),
          one.reported.y.to_double());
    if (!one.is_measured)
      print(out, "found nowhere\n");
    else
      print(out, "found in x {}, y {}: {}\n", interval_text(one.x), interval_text(one.y),
            one.is_as_reported() ? "equal" : "NOT EQUAL");
  }
}

// "1", "4", "1 to 4"; "-" if there are no such pixels.
std::string invocations_text(const InvocationRow& row, int covered) {
  const auto found = row.invocations.find(covered);
  if (found == row.invocations.end()) return "-";
  const int least = found->second.begin()->first;
  const int most = found->second.rbegin()->first;
  return least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
}

std::string locations_text(const std::map<std::string, std::size_t>& locations) {
  if (locations.empty()) return "-";
  if (locations.size() == 1) return locations.begin()->first;
  std::vector<std::string> parts;
  for (const auto& [location, count] : locations)
    parts.push_back(fmt::format("{} {}", location, count));
  return fmt::format("{}", fmt::join(parts, ", "));
}

void print_invocations(Buffer& out, const SampleProfile& samples) {
  if (samples.invocations.empty()) return;
  print(out, "    {:<12}{:<11}{:<15}{:<13}{}\n", "asked for", "attribute", "at least for",
        "made for", "attributes are evaluated at");
  print(out, "    {:<12}{:<11}{:<15}{:<13}{}\n", "", "", "a whole pixel", "1 .. n covered", "");
  for (const InvocationRow& row : samples.invocations) {
    std::vector<std::string> made;
    for (int covered = 1; covered <= samples.samples; ++covered)
      made.push_back(invocations_text(row, covered));
    print(out, "    {:<12}{:<11}{:<15}{:<13}{}; partly covered: {}{}\n", row.asked, row.location,
          row.least, fmt::format("{}", fmt::join(made, " ")), locations_text(row.whole),
          locations_text(row.partial),
          row.is_violation() ? "; violation of rulings 29 and 30: not at the sample" : "");
  }
}

void print_alphas(Buffer& out, const SampleProfile& samples) {
  if (samples.alphas.empty()) return;
  print(out, "    alpha to coverage:");
  for (const AlphaRun& run : samples.alphas)
    print(out, " {:.9g} to {:.9g}: mask {:x};", run.first, run.last, run.mask);
  print(out, "\n");
}

constexpr std::size_t kMostTerms = 8;

// "at it 120 (0 to 0.5 of a step above it), +1 130 (0.5 to 0.99)"
void print_codes(Buffer& out, const CodeEvidence& evidence) {
  std::vector<std::string> parts;
  for (const auto& [distance, step] : evidence.steps)
    parts.push_back(fmt::format("{:+} {} (of {:.4f} to {:.4f} steps above)", distance, step.numbers,
                                step.least, step.largest));
  print(out, "    {:<10}{} numbers, from the code at or below them: {}\n", evidence.id,
        evidence.numbers, fmt::join(parts, ", "));
}

void print_unit(Buffer& out, const MeasuredUnit& unit) {
  const bool is_float = holds_floats(unit.format);
  const std::string of =
      is_float ? fmt::format("2^({} - 23)", unit.exponent) : std::string("the format's steps");
  print(out, "    {:<10}one unit of offset is {:.7g} to {:.7g} {}, {} depths\n",
        name_of(unit.format), unit.least, unit.largest, of, unit.depths);
}

void print_residual(Buffer& out, const BlendResidual& residual) {
  std::vector<std::string> off;
  for (const auto& [difference, values] : residual.off)
    off.push_back(fmt::format("{:+} {}", difference, values));
  print(out, "    {:<7}{:<18}{:<27}{:<27}{:>6} values, off by {}\n",
        residual.is_alpha ? "alpha" : "colour", name_of(residual.term.equation),
        name_of(residual.term.source), name_of(residual.term.destination), residual.values,
        fmt::join(off, ", "));
}

void print_blending(Buffer& out, const std::vector<BlendResidual>& residuals) {
  if (residuals.empty()) return;
  print(out, "  blended values that no alternative yields, by term, against the closest one:\n");
  const std::size_t shown = std::min(kMostTerms, residuals.size());
  for (std::size_t i = 0; i < shown; ++i) print_residual(out, residuals[i]);
  if (shown < residuals.size())
    print(out, "    and {} more terms; --json has all\n", residuals.size() - shown);
}

void print_traits(Buffer& out, const std::vector<Trait>& traits) {
  print(out, "  {:<38}{:<33}{:<26}{}\n", "rule or probe", "follows", "agreement", "runner-up");
  for (const Trait& trait : traits) {
    const auto& [alternative, rate] = told(trait);
    print(out, "  {:<38}{:<33}{:<26}", text_of(trait.id),
          trait.is_asked() ? alternative : "not asked",
          fmt::format("{} ({} of {})", percent(rate), rate.agreeing, rate.of));
    if (!trait.runner_up.empty() && trait.runner_up != alternative && trait.is_asked())
      print(out, "{} {}", trait.runner_up, percent(trait.runner_up_rate));
    if (trait.is_asked() && trait.is_undecided()) print(out, " (as good)");
    print(out, "\n");
    if (!trait.remark.empty()) print(out, "    {}\n", trait.remark);
  }
}

// '#' always drawn, '.' never, '?' sometimes, ' ' not tested.
char sign_of(const OwnershipTable::Cell& cell) {
  if (cell.of == 0) return ' ';
  if (cell.drawn == 0) return '.';
  return cell.drawn == cell.of ? '#' : '?';
}

void print_table(Buffer& out, const OwnershipTable& table) {
  print(out, "  {}: # drawn, . not drawn, ? now and then\n", table.title);
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    print(out, "    {:<24}{:>{}} {}\n", "", "|", c + 1, table.columns[c]);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    print(out, "    {:<24}", table.rows[r]);
    for (const OwnershipTable::Cell& cell : table.cells[r]) print(out, "{}", sign_of(cell));
    print(out, "\n");
  }
}

void print_clusters(Buffer& out, const SurfaceProfile& surface, std::size_t most) {
  if (surface.clusters.empty()) {
    print(out, "  Nothing differs from this profile, and nothing is outside the specification.\n");
    return;
  }
  print(out,
        "  What differs from this profile or is outside the specification ({}), what "
        "nothing catalogued explains first:\n",
        counted(surface.illegal_scenes, "scene is", "scenes are"));
  const std::size_t shown = std::min(most, surface.clusters.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const auto& [cluster, scene] = surface.clusters[i];
    print(out, "    {} {} in {}, {}\n      smallest: {}, pixel ({}, {})\n", cluster.disagreements,
          title_of(cluster), counted(cluster.cases, "scene", "scenes"),
          cluster.legality == Legality::illegal ? "NOT allowed" : describe(cluster.legality),
          scene_text(scene), cluster.x, cluster.y);
  }
  if (shown < surface.clusters.size())
    print(out, "    and {}; --json has all\n",
          counted(surface.clusters.size() - shown, "more cluster", "more clusters"));
}

void print_surface(Buffer& out, const SurfaceProfile& surface, std::size_t most_clusters) {
  if (!surface.unavailable.empty()) {
    print(out, "\n{}: not measured: {}\n", name_of(surface.surface), surface.unavailable);
    return;
  }
  const SurfaceFindings& findings = surface.findings;
  print(out, "\n{}: {} scenes, {} of the {} random ones with a tie\n", name_of(surface.surface),
        findings.drawn.scenes, percent({findings.with_ties, findings.random_scenes}),
        findings.random_scenes);
  if (findings.drawn.not_drawn > 0)
    print(out, "  {} not drawn, the first: {}\n",
          counted(findings.drawn.not_drawn, "scene was", "scenes were"),
          findings.drawn.first_failure);
  print_traits(out, findings.traits);
  print(out, "{}", value_errors_text(findings.values));
  print(out, "{}", level_residuals_text(findings.levels));
  print(out, "{}", sample_profile_text(findings.samples));
  print(out, "{}", output_profile_text(findings.output));
  for (const OwnershipTable& table : findings.tables) print_table(out, table);
  print_clusters(out, surface, most_clusters);
}

}  // namespace

std::string value_errors_text(std::span<const ValueErrors> rows) {
  Buffer out;
  if (rows.empty()) return "";
  print(out, "  {:<34}{:>10}  {:<9}{:>8}{:>11}{:>13}{:>13}  {:<8} {}\n", "values of fragments",
        "fragments", "correct", "99 % <", "mean ULP", "largest ULP", "of range", "beyond",
        "no numbers");
  for (const ValueErrors& row : rows) print_row(out, row);
  if (std::any_of(rows.begin(), rows.end(), [](const ValueErrors& row) { return row.as_found; }))
    print(out, "  *: against the rules that the renderer is found to follow, not OpenGL's own\n");
  return fmt::to_string(out);
}

std::string level_residuals_text(std::span<const LevelResiduals> rows) {
  Buffer out;
  if (rows.empty()) return "";
  const FormulaResidual& found = rows[0].found();
  print(out, "  levels of detail against {} + {}, derivatives {}: at most {:.4g} levels of error\n",
        name_of(found.scale_factor), name_of(found.log2), rows[0].derivatives, kMostResidual);
  print(out, "  {:<34}{:>10}{:>13}{:>13}\n", "ramp, where the level is reported", "fragments",
        "mean", "largest");
  for (const LevelResiduals& row : rows) print_found(out, row);
  print_formulas(out, rows);
  return fmt::to_string(out);
}

std::string sample_profile_text(const SampleProfile& samples) {
  Buffer out;
  if (!samples.unavailable.empty()) {
    print(out, "  multisampling: not measured: {}\n", samples.unavailable);
    print_counts(out, samples);
    return fmt::to_string(out);
  }
  if (samples.samples == 0) return "";
  print(out, "  multisampling, measured with {} samples, {} of {} random scenes with a tie:\n",
        samples.samples, percent({samples.with_ties, samples.random_scenes}),
        samples.random_scenes);
  print_counts(out, samples);
  for (const MeasuredPositions& positions : samples.positions) print_positions(out, positions);
  print_invocations(out, samples);
  print_alphas(out, samples);
  return fmt::to_string(out);
}

std::string output_profile_text(const OutputProfile& output) {
  Buffer out;
  if (output.codes.empty()) return "";
  print(out, "  stored codes and units of offset:\n");
  for (const CodeEvidence& evidence : output.codes) print_codes(out, evidence);
  for (const MeasuredUnit& unit : output.units) print_unit(out, unit);
  print_blending(out, output.blending);
  return fmt::to_string(out);
}

std::string profile_text(const Profile& profile, std::size_t most_clusters) {
  Buffer out;
  print_renderer(out, profile);
  print(out, "{} random scenes of each primitive type on each surface, seed {}; {}\n",
        profile.scenes_per_kind, profile.seed, words_of_bits(profile.renderer));
  for (const SurfaceProfile& surface : profile.surfaces) print_surface(out, surface, most_clusters);
  return fmt::to_string(out);
}

}  // namespace edgecase
