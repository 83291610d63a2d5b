// SPDX-License-Identifier: MIT
#include "results/cluster_entries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "rules/all_rules.h"

namespace edgecase {
namespace {

// What the differences of a cluster have in common: words of their situations, and the part of the
// target.
class Common {
 public:
  void add(const CaseResults& one, const ClusterMember& member) {
    members_ += member.count;
    if (!is_first_ && words_.empty()) return;
    std::set<std::string> words = places_of(one, member);
    if (member.situation) words.merge(words_of(*member.situation));
    if (std::exchange(is_first_, false)) {
      words_ = std::move(words);
      return;
    }
    std::erase_if(words_, [&](const std::string& word) { return !words.contains(word); });
  }

  void add(const Common& more) {
    if (more.is_first_) return;
    members_ += more.members_;
    if (std::exchange(is_first_, false)) {
      words_ = more.words_;
      return;
    }
    std::erase_if(words_, [&](const std::string& word) { return !more.words_.contains(word); });
  }

  std::string text() const {
    constexpr std::size_t kFewest = 5;  // fewer have much in common by chance
    return members_ < kFewest ? "" : fmt::format("{}", fmt::join(words_, ", "));
  }

 private:
  // The situation's parts but for the kind of primitive, which the rule names; of a direction also
  // its major axis.
  static std::set<std::string> words_of(const std::string& situation) {
    std::set<std::string> words;
    for (std::size_t begin = situation.find(", "); begin != std::string::npos;) {
      const std::size_t end = situation.find(", ", begin + 2);
      const std::string word = situation.substr(begin + 2, end - begin - 2);
      for (const char* axis : {"x-major", "y-major"})
        if (word.starts_with(axis)) words.insert(axis);
      words.insert(word);
      begin = end;
    }
    for (const char* kind : {"wide line", "clipped triangle", "triangle without area"})
      if (situation.starts_with(kind)) words.insert(kind);
    return words;
  }

  static std::set<std::string> places_of(const CaseResults& one, const ClusterMember& member) {
    constexpr int kSmallest = 4;  // pixels: below, each pixel is on a border
    std::set<std::string> places;
    if (one.width < kSmallest || one.height < kSmallest) return places;
    if (member.y == 0) places.insert("in the lowest row");
    if (member.y == one.height - 1) places.insert("in the highest row");
    if (member.x == 0) places.insert("in the leftmost column");
    if (member.x == one.width - 1) places.insert("in the rightmost column");
    const bool is_left = 2 * member.x < one.width;
    const bool is_low = 2 * member.y < one.height;
    places.insert(fmt::format("in the {} {} quarter", is_low ? "lower" : "upper",
                              is_left ? "left" : "right"));
    return places;
  }

  bool is_first_ = true;
  std::size_t members_ = 0;
  std::set<std::string> words_;
};

// The differences of one key.
struct Entry {
  struct Situation {
    std::size_t disagreements = 0;
    std::size_t cases = 0;
    std::size_t latest = 0;  // the last case that has it
  };

  Cluster cluster;
  std::vector<std::size_t> cases;  // ascending
  std::optional<CaseSize> smallest;
  std::map<std::optional<std::string>, Situation> situations;
  std::vector<ClusterSituation> as_if;
  Common common;

  void add(std::size_t number, const ClusterPlace& place, const ClusterMember& member) {
    cluster.disagreements += member.count;
    if (cases.empty() || cases.back() != number) cases.push_back(number);
    count(number, member);
    common.add(*place.one, member);
    if (smallest && !(place.size < *smallest)) return;
    smallest = place.size;
    cluster.smallest_case = place.one->id;
    cluster.smallest_file = place.one->file;
    cluster.x = member.x;
    cluster.y = member.y;
    cluster.primitive = member.primitive;
  }

  // Those of another key that belong to the same cluster. `row`: the cause that they look like.
  void take_in(const ClusterKey& key, Entry& more, const std::string& row) {
    if (cluster.keys.empty()) {
      cluster.rule = key.rule;
      cluster.kind = key.kind;
      cluster.attribute = key.attribute;
    }
    // A cluster with several rules or kinds names none.
    if (cluster.rule != key.rule) cluster.rule.clear();
    if (cluster.kind != key.kind) cluster.kind.clear();
    if (cluster.attribute != key.attribute) cluster.attribute.clear();
    if (std::ranges::find(cluster.keys, key) == cluster.keys.end()) cluster.keys.push_back(key);
    cluster.disagreements += more.cluster.disagreements;
    if (!row.empty())
      as_if.push_back({"as if " + row, false, more.cluster.disagreements, more.cases.size()});
    else
      for (auto& [text, situation] : more.situations) situations.insert({text, situation});
    std::vector<std::size_t> all;
    std::ranges::set_union(cases, more.cases, std::back_inserter(all));
    cases = std::move(all);
    common.add(more.common);
    if (smallest && !(*more.smallest < *smallest)) return;
    smallest = more.smallest;
    cluster.smallest_case = more.cluster.smallest_case;
    cluster.smallest_file = more.cluster.smallest_file;
    cluster.x = more.cluster.x;
    cluster.y = more.cluster.y;
    cluster.primitive = more.cluster.primitive;
  }

  std::vector<ClusterSituation> take_rows() const {
    std::vector<ClusterSituation> list = as_if;
    for (const auto& [text, situation] : situations)
      list.push_back({text.value_or("of a gross fault, only counted"), !text,
                      situation.disagreements, situation.cases});
    std::ranges::stable_sort(list, std::ranges::greater(), &ClusterSituation::disagreements);
    return list;
  }

 private:
  void count(std::size_t number, const ClusterMember& member) {
    if (member.situation == "") return;
    Situation& situation = situations[member.situation];
    situation.disagreements += member.count;
    if (situation.cases == 0 || situation.latest != number) ++situation.cases;
    situation.latest = number;
  }
};

// Which causes explain the cases of a key.
class Ballot {
 public:
  // A difference of the case of this number, and the causes under which it comes out, the likeliest
  // first.
  void add(std::size_t number, const std::vector<Cause>& likely) {
    if (!common_ || number_ != number) {
      close();
      number_ = number;
      common_ = std::set<Cause>(likely.begin(), likely.end());
      if (!likely.empty()) ++chosen_[likely.front()];
      ++cases_;
    } else if (!common_->empty()) {
      std::erase_if(*common_, [&](const Cause& cause) {
        return std::ranges::find(likely, cause) == likely.end();
      });
    }
  }

  // The one cause of all: it explains nine in ten of the cases, no answer refutes it, and a pair is
  // not taken from one case alone. Of several the one of the fewest parts, then that of the most
  // cases, then the one that is the likeliest most often. Empty: there is none.
  Cause elected(const AlternativeSet& refuted) {
    close();
    const Cause* best = nullptr;
    std::tuple<std::ptrdiff_t, std::size_t, std::size_t> best_rank;
    for (const auto& [cause, explained] : explained_) {
      const bool is_pair_of_one = cause.size() > 1 && cases_ == 1;
      if (10 * explained < 9 * cases_ || is_pair_of_one) continue;
      if (std::ranges::any_of(cause.parts, [&](auto part) { return refuted.contains(part); }))
        continue;
      const std::tuple rank(-std::ssize(cause.parts), explained, chosen_[cause]);
      if (best != nullptr && rank <= best_rank) continue;
      best = &cause;
      best_rank = rank;
    }
    return best != nullptr ? *best : Cause();
  }

 private:
  void close() {
    if (common_)
      for (const Cause& cause : *common_) ++explained_[cause];
    common_.reset();
  }

  std::size_t cases_ = 0;
  std::size_t number_ = 0;                 // of the latest case
  std::optional<std::set<Cause>> common_;  // that explain all its differences
  std::map<Cause, std::size_t> explained_;
  std::map<Cause, std::size_t> chosen_;  // cases of which it is the likeliest
};

}  // namespace

class ClusterEntries::Lists {
 public:
  explicit Lists(std::map<std::string, AlternativeSet> refuted) : refuted_(std::move(refuted)) {}

  void start(const CaseResults& one) {
    if (latest_ != one.id) ++number_;
    latest_ = one.id;
  }

  void add(const ClusterEntryKey& key, const ClusterPlace& place, const ClusterMember& member) {
    entries_[key].add(number_, place, member);
    ballots_[without_cause(key.of)].add(number_, member.likely);
  }

  std::vector<Cluster> take(bool is_apart) {
    const auto causes = is_apart ? std::map<ClusterKey, std::string>() : run_causes();
    const Shares shares = shares_of_choices();
    std::map<ClusterKey, Entry> merged;
    for (auto& [key, entry] : entries_) {
      ClusterKey whole = key.of;
      std::string as_if = key.as_if;
      if (!is_apart && is_by_chance(whole, shares)) as_if = std::exchange(whole.cause, "");
      if (is_apart && whole.cause.empty()) whole.cause = as_if;
      if (const auto found = causes.find(whole); found != causes.end()) whole.cause = found->second;
      if (!whole.cause.empty()) {
        whole.rule = whole.kind = whole.attribute = "";
        as_if.clear();
      }
      merged[whole].take_in(key.of, entry, as_if);
    }
    std::vector<Cluster> clusters;
    for (auto& [key, entry] : merged) {
      Cluster& cluster = entry.cluster;
      cluster.surface = key.surface;
      cluster.legality = key.legality;
      cluster.cause = key.cause;
      cluster.cases = entry.cases.size();
      if (key.cause.empty() && key.attribute.empty()) {
        cluster.situations = entry.take_rows();
        cluster.common = entry.common.text();
      }
      if (!key.cause.empty()) cluster.attribute.clear();
      clusters.push_back(std::move(cluster));
    }
    return clusters;
  }

 private:
  // Of the differences of a rule and kind, how many cases there are for each alternative.
  struct Share {
    std::size_t all = 0;
    std::map<AlternativeId, std::size_t> of;
  };
  using Shares = std::map<ClusterKey, Share>;  // by key, without a cause

  static ClusterKey without_cause(ClusterKey key) {
    key.cause.clear();
    return key;
  }

  Shares shares_of_choices() const {
    Shares shares;
    for (const auto& [key, entry] : entries_) {
      Share& share = shares[without_cause(key.of)];
      share.all += entry.cases.size();
      if (const auto cause = parse_cause(key.of.cause))
        for (const AlternativeId part : cause->parts) share.of[part] += entry.cases.size();
    }
    return shares;
  }

  // True if a choice that explains allowed differences is not the renderer's elsewhere, and
  // explains less than half of what differs.
  bool is_by_chance(const ClusterKey& key, const Shares& shares) const {
    const auto refuted = refuted_.find(key.surface);
    const auto choice = parse_cause(key.cause);
    if (refuted == refuted_.end() || !choice || choice->empty()) return false;
    const Share& share = shares.at(without_cause(key));
    const auto& parts = choice->parts;
    return std::ranges::any_of(parts, [&](auto part) { return refuted->second.contains(part); }) &&
           std::ranges::none_of(parts,
                                [&](auto part) { return 2 * share.of.at(part) >= share.all; });
  }

  // The cause of each key without one.
  std::map<ClusterKey, std::string> run_causes() {
    std::map<ClusterKey, std::string> causes;
    for (auto& [key, ballot] : ballots_)
      causes[key] = text_of(ballot.elected(refuted_[key.surface]));
    return causes;
  }

  std::map<ClusterEntryKey, Entry> entries_;
  std::map<ClusterKey, Ballot> ballots_;           // by key, without a cause
  std::map<std::string, AlternativeSet> refuted_;  // by surface
  std::optional<std::string> latest_;              // id of the last case
  std::size_t number_ = 0;                         // of cases so far
};

ClusterEntries::ClusterEntries(std::map<std::string, AlternativeSet> refuted)
    : lists_(new Lists(std::move(refuted))) {}
ClusterEntries::~ClusterEntries() = default;

void ClusterEntries::start(const CaseResults& one) {
  lists_->start(one);
}

void ClusterEntries::add(const ClusterEntryKey& key, const ClusterPlace& place,
                         const ClusterMember& member) {
  lists_->add(key, place, member);
}

std::vector<Cluster> ClusterEntries::take(bool is_apart) {
  return lists_->take(is_apart);
}

}  // namespace edgecase
