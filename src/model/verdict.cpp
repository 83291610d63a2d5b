// SPDX-License-Identifier: MIT
#include "model/verdict.h"

namespace edgecase {

const char* name_of(DisagreementKind kind) {
  switch (kind) {
    case DisagreementKind::missing:
      return "missing";
    case DisagreementKind::extra:
      return "extra";
    case DisagreementKind::duplicate:
      return "duplicate";
    case DisagreementKind::value:
      return "value";
  }
  return "?";
}

const char* name_of(Legality legality) {
  switch (legality) {
    case Legality::legal:
      return "legal";
    case Legality::contested:
      return "contested";
    case Legality::illegal:
      return "illegal";
  }
  return "?";
}

const char* describe(Legality legality) {
  switch (legality) {
    case Legality::legal:
      return "allowed";
    case Legality::contested:
      return "contested";
    case Legality::illegal:
      return "not allowed";
  }
  return "?";
}

bool parse_name(const std::string& name, Legality& value) {
  for (Legality legality : {Legality::legal, Legality::contested, Legality::illegal}) {
    if (name != name_of(legality)) continue;
    value = legality;
    return true;
  }
  return false;
}

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::agree:
      return "agree";
    case Verdict::convention:
      return "convention";
    case Verdict::permitted:
      return "permitted";
    case Verdict::contested:
      return "contested";
    case Verdict::violation:
      return "violation";
    case Verdict::not_run:
      return "not-run";
  }
  return "?";
}

bool parse_name(const std::string& name, Verdict& value) {
  for (Verdict verdict : {Verdict::agree, Verdict::convention, Verdict::permitted,
                          Verdict::contested, Verdict::violation, Verdict::not_run}) {
    if (name != name_of(verdict)) continue;
    value = verdict;
    return true;
  }
  return false;
}

}  // namespace edgecase
