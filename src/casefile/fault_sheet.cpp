// SPDX-License-Identifier: MIT
#include "casefile/fault_sheet.h"

#include <fmt/format.h>

#include <utility>

namespace edgecase {

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

}  // namespace edgecase
