// SPDX-License-Identifier: MIT
#include "profile/samples/sample_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <vector>

#include "profile/profile_text.h"

namespace edgecase {
namespace {

using Buffer = fmt::memory_buffer;

template <class... Args>
void print(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
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

// "1", "4", "1 to 4"; "-" where there are no such pixels.
std::string invocations_text(const InvocationRow& row, int covered) {
  const auto found = row.invocations.find(covered);
  if (found == row.invocations.end()) return "-";
  const int least = found->second.begin()->first;
  const int most = found->second.rbegin()->first;
  return least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
}

std::string places_text(const std::map<std::string, std::size_t>& places) {
  if (places.empty()) return "-";
  if (places.size() == 1) return places.begin()->first;
  std::vector<std::string> parts;
  for (const auto& [place, count] : places) parts.push_back(fmt::format("{} {}", place, count));
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
          row.least, fmt::format("{}", fmt::join(made, " ")), places_text(row.whole),
          places_text(row.partial),
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

}  // namespace

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

}  // namespace edgecase
