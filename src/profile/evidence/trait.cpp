// SPDX-License-Identifier: MIT
#include "profile/evidence/trait.h"

#include <fmt/format.h>

#include <utility>

namespace edgecase {

double Rate::share() const {
  return of == 0 ? 1 : static_cast<double>(agreeing) / static_cast<double>(of);
}

std::string percent(const Rate& rate) {
  if (rate.of == 0) return "-";
  if (rate.agreeing == rate.of) return "100 %";
  const std::size_t hundredths = rate.agreeing * 10'000 / rate.of;
  return fmt::format("{}.{:02} %", hundredths / 100, hundredths % 100);
}

std::string text_of(const TraitId& id) {
  if (id.rule == RuleId::none) return id.probe;
  return id.probe.empty() ? name_of(id.rule) : fmt::format("{}:{}", name_of(id.rule), id.probe);
}

void OwnershipTable::Cell::count(bool is_drawn) {
  ++of;
  if (is_drawn) ++drawn;
}

OwnershipTable::OwnershipTable(std::string table_title, std::vector<std::string> row_names,
                               std::vector<std::string> column_names)
    : title(std::move(table_title)),
      rows(std::move(row_names)),
      columns(std::move(column_names)),
      cells(rows.size(), std::vector<Cell>(columns.size())) {}

}  // namespace edgecase
