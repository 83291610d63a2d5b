// SPDX-License-Identifier: MIT
#include "search/fuzz.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <utility>

#include "base/threads.h"
#include "diff/compare.h"
#include "search/ledger.h"
#include "search/trial.h"

namespace edgecase {
namespace {

constexpr std::size_t kPiece = 32;      // scenes that a thread takes at once
constexpr std::size_t kWarmUp = 4;      // rounds without minimizing, to read their results
constexpr std::size_t kChunk = 8;       // candidates that are minimized in parallel
constexpr std::size_t kLeastAsks = 30;  // to minimize a find, however late it is
// The share of a time limit after which what was found is minimized. While nothing is found, the
// search has the whole time.
constexpr double kSearchShare = 0.6;
constexpr std::size_t kUnlimited = ~std::size_t{0};

// Some scenes of a batch, and their results.
struct Piece {
  const Batch* batch = nullptr;
  std::size_t first = 0;
  std::size_t count = 0;
  bool done = false;
  std::vector<SourcedScene> scenes;
  std::vector<Screening> screenings;  // by renderer
};

std::vector<Piece> pieces_of(const std::vector<Batch>& batches) {
  std::vector<Piece> pieces;
  for (const Batch& batch : batches)
    for (std::size_t first = 0; first < batch.count; first += kPiece)
      pieces.push_back({&batch, first, std::min(kPiece, batch.count - first), false, {}, {}});
  return pieces;
}

class Search {
 public:
  Search(const std::vector<FuzzRenderer>& renderers, const FuzzOptions& options)
      : renderers_(renderers),
        options_(options),
        source_(options.exhaustive ? SceneSource(options.seed, options.families, options.surfaces)
                                   : SceneSource(options.seed, options.families, options.surfaces,
                                                 options.corpus)),
        start_(Clock::now()) {
    for (const FuzzRenderer& renderer : renderers_) {
      screens_.emplace_back(renderer.policy, renderer.profiles);
      ledgers_.emplace_back(renderer.policy.latitude, options.least);
    }
    waiting_.resize(renderers_.size());
    workers_.resize(static_cast<std::size_t>(std::max(options.jobs, 1)));
    for (auto& worker : workers_)
      for (const FuzzRenderer& renderer : renderers_) worker.push_back(renderer.make());
    report_.renderers.resize(renderers_.size());
  }

  FuzzReport run() {
    try {
      learn_known();
      // Candidates that turn out to be no finds leave the rest of the time to the search.
      for (bool goes_on = true; goes_on; goes_on = goes_on && !has_found_ && !is_over()) {
        goes_on = search();
        queue_candidates();
        minimize_candidates([] { return true; });
        has_found_ = finds() > 0;
      }
      minimize_others();
    } catch (const SearchStopped&) {
    }
    return finished();
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool is_stopped() const { return options_.stop != nullptr && options_.stop->load(); }
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double time() const { return std::chrono::duration<double>(*options_.time).count(); }
  bool is_late() const {
    return options_.time && elapsed() >= (has_found_ ? kSearchShare : 1.0) * time();
  }
  std::size_t left() const { return options_.count ? *options_.count - asked_ : kUnlimited; }
  std::size_t finds() const {
    std::size_t sum = 0;
    for (const Ledger& ledger : ledgers_) sum += ledger.finds();
    return sum;
  }
  bool is_over() const {
    return is_stopped() || is_late() || left() == 0 ||
           (options_.finds && finds() >= *options_.finds);
  }

  // Runs work(item, worker) for items 0 to count - 1 on all threads; false if some were left out
  // because `over` said so.
  template <class Work, class IsOver>
  bool in_parallel(std::size_t count, const Work& work, const IsOver& over) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> left_out{false};
    const auto take = [&](std::size_t worker) {
      try {
        for (;;) {
          const std::size_t item = next++;
          if (item >= count) return;
          if (over()) {
            left_out = true;
            return;
          }
          work(item, worker);
        }
      } catch (const SearchStopped&) {
        left_out = true;
      }
    };
    run_threads(std::min(workers_.size(), count), take);
    return !left_out;
  }

  // Renders rounds until a limit; false if there are no more scenes.
  bool search() {
    for (; !is_over(); ++round_) {
      const auto batches = source_.next_round(left());
      if (batches.empty() || !ask(batches)) return false;
      if (round_ < kWarmUp) continue;
      queue_candidates();
      // While the search continues, it takes at least half of all scenes.
      minimize_candidates([&] { return minimize_asks_ < report_.scenes; });
    }
    return true;
  }

  // False if no more scenes can be rendered.
  bool ask(const std::vector<Batch>& batches) {
    std::vector<Piece> pieces = pieces_of(batches);
    std::vector<Piece*> left;
    for (Piece& piece : pieces) left.push_back(&piece);
    while (!left.empty() && !is_stopped() && !is_late()) {
      ask(left);
      for (Piece* piece : left)
        if (piece->done) keep(*piece);
      std::erase_if(left, [](const Piece* piece) { return piece->done; });
      if (!left.empty()) queue_candidates();
    }
    for (const Batch& batch : batches) {
      asked_ += batch.count;
      if (batch.family != nullptr && is_drawn_by_none(batch, pieces)) source_.retire(*batch.family);
    }
    return !is_stopped() && !is_unavailable();
  }

  // Renders pieces until there is no time for more. After the search's share of the time, a suspect
  // interrupts it: it may be a find, which is to be minimized.
  void ask(const std::vector<Piece*>& pieces) {
    std::atomic<bool> is_suspected{false};
    in_parallel(
        pieces.size(),
        [&](std::size_t i, std::size_t worker) {
          Piece& piece = *pieces[i];
          ask(piece, worker);
          tell_progress(piece.scenes.size());
          for (const Screening& screening : piece.screenings)
            if (!screening.suspects.empty()) is_suspected = true;
        },
        [&] {
          return is_stopped() || is_late() ||
                 (is_suspected && options_.time && elapsed() >= kSearchShare * time());
        });
  }

  void ask(Piece& piece, std::size_t worker) const {
    for (std::size_t i = 0; i < piece.count; ++i)
      if (auto scene = source_.scene(*piece.batch, piece.first + i))
        piece.scenes.push_back(std::move(*scene));
    std::vector<Scene> scenes;
    for (const SourcedScene& sourced : piece.scenes) scenes.push_back(sourced.scene);
    const bool coverage_only = piece.batch->family != nullptr && piece.batch->family->coverage_only;
    for (std::size_t r = 0; r < renderers_.size(); ++r)
      piece.screenings.push_back(
          screens_[r].ask(*workers_[worker][r], scenes, coverage_only, options_.stop));
    piece.done = true;
  }

  void keep(Piece& piece) {
    report_.scenes += piece.scenes.size();
    const Family* family = piece.batch->family;
    report_.by_family[family == nullptr ? kMutated : family->name] += piece.scenes.size();
    for (std::size_t r = 0; r < renderers_.size(); ++r) {
      Screening& screening = piece.screenings[r];
      FuzzedRenderer& renderer = report_.renderers[r];
      renderer.drawn += screening.drawn;
      renderer.not_drawn += piece.scenes.size() - screening.drawn;
      if (!renderer.failure) renderer.failure = screening.failure;
      for (Screening::Suspect& suspect : screening.suspects)
        ledgers_[r].add(piece.scenes[suspect.scene], std::move(suspect.result));
    }
  }

  static bool is_drawn_by_none(const Batch& batch, const std::vector<Piece>& pieces) {
    return std::ranges::none_of(pieces, [&](const Piece& piece) {
      return piece.batch == &batch &&
             (!piece.done || std::ranges::any_of(piece.screenings, [](const Screening& s) {
               return s.drawn > 0 || !s.suspects.empty();
             }));
    });
  }

  // A renderer that cannot be started never draws anything.
  bool is_unavailable() const {
    return std::ranges::any_of(report_.renderers, [](const FuzzedRenderer& renderer) {
      return renderer.drawn == 0 && renderer.failure &&
             renderer.failure->kind == FailureKind::unavailable;
    });
  }

  void tell_progress(std::size_t scenes) {
    if (!options_.progress) return;
    const std::lock_guard lock(progress_mutex_);
    progress_.scenes += scenes;
    options_.progress(progress_);
  }

  Trial trial_of(std::size_t r, std::size_t worker) {
    return {*workers_[worker][r],
            {renderers_[r].policy, renderers_[r].profiles, ledgers_[r].readings(), options_.stop}};
  }

  void learn_known() {
    for (std::size_t r = 0; r < renderers_.size(); ++r) {
      const auto keys = options_.known.keys.find(renderers_[r].name);
      if (keys != options_.known.keys.end())
        for (const FindKey& key : keys->second) ledgers_[r].know(key);
      Trial trial = trial_of(r, 0);
      std::vector<TrialAnswer> answers = trial.ask(options_.known.scenes);
      for (std::size_t i = 0; i < answers.size(); ++i)
        ledgers_[r].know(options_.known.scenes[i], std::move(answers[i].result));
    }
  }

  // Judges what was found since the last call; what may be a find waits to be minimized.
  void queue_candidates() {
    for (std::size_t r = 0; r < renderers_.size(); ++r)
      for (Candidate& candidate : ledgers_[r].take_candidates()) {
        waiting_[r].push_back(std::move(candidate));
        has_found_ = true;
      }
  }

  // Minimizes waiting candidates, in the order in which they were found, while `goes_on` holds.
  template <class GoesOn>
  void minimize_candidates(const GoesOn& goes_on) {
    for (std::size_t r = 0; r < renderers_.size(); ++r) {
      std::deque<Candidate>& waiting = waiting_[r];
      while (!waiting.empty() && !is_full() && goes_on()) {
        // No more at once than may be wanted.
        const std::size_t wanted = options_.finds ? *options_.finds - finds() : kUnlimited;
        minimize_first(r, std::min({waiting.size(), wanted, kChunk}));
      }
    }
  }

  // The rest of a time limit is used for finds that could be easier to read: other scenes that show
  // them may lead to simpler ones.
  void minimize_others() {
    for (bool any = options_.time.has_value(); any;) {
      any = false;
      for (std::size_t r = 0; r < renderers_.size(); ++r) {
        for (Candidate& candidate : ledgers_[r].take_others())
          waiting_[r].push_back(std::move(candidate));
        for (; !waiting_[r].empty() && elapsed() < time(); any = true)
          minimize_first(r, std::min(waiting_[r].size(), kChunk));
      }
    }
  }

  // Minimizes the first waiting candidates in parallel.
  void minimize_first(std::size_t r, std::size_t count) {
    std::deque<Candidate>& waiting = waiting_[r];
    const MinimizeOptions options = affordable();
    std::vector<Find> found(count);
    in_parallel(
        count,
        [&](std::size_t i, std::size_t w) { found[i] = minimized(r, waiting[i], w, options); },
        [] { return false; });
    for (std::size_t i = 0; i < count; ++i) {
      minimize_asks_ += found[i].asks;
      if (is_shown(found[i].end) || waiting[i].result) add(r, std::move(found[i]));
    }
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(count));
  }

  // With a time limit: the number of scenes per waiting candidate for which there is time at the
  // speed so far.
  MinimizeOptions affordable() const {
    MinimizeOptions options = options_.minimize;
    if (!options_.time) return options;
    std::size_t waiting = 0;
    for (const auto& of_renderer : waiting_) waiting += of_renderer.size();
    const double rate = static_cast<double>(report_.scenes + minimize_asks_) / elapsed();
    const double asks = rate * std::max(time() - elapsed(), 0.0) / static_cast<double>(waiting);
    options.max_asks = std::clamp(static_cast<std::size_t>(asks), kLeastAsks, options.max_asks);
    return options;
  }

  bool is_full() const { return options_.finds && finds() >= *options_.finds; }

  static bool is_shown(MinimizeEnd end) {
    return end == MinimizeEnd::finished || end == MinimizeEnd::exhausted;
  }

  Find minimized(std::size_t r, const Candidate& candidate, std::size_t worker,
                 const MinimizeOptions& options) {
    Find find;
    find.renderer = renderers_[r].name;
    find.key = candidate.key;
    find.verdict = candidate.verdict;
    find.scene = candidate.sourced.scene;
    find.origin = candidate.sourced.origin;
    Trial trial = trial_of(r, worker);
    Minimized least = edgecase::minimize(find.scene, find.key.signature, trial, options);
    // A find that was stopped at once, or did not show again, keeps its original scene.
    if (is_shown(least.end)) {
      find.result = std::move(least.result);
      find.scene = std::move(least.scene);
    } else if (candidate.result) {
      find.result = *candidate.result;
    }
    find.end = least.end;
    find.least_bits = least.least_bits;
    find.asks = least.asks;
    return find;
  }

  void add(std::size_t r, Find find) {
    const std::string name = "a find of " + describe(find.origin, options_.seed);
    const CorpusScene scene{name, find.scene};
    const Verdict verdict = find.verdict;
    if (!ledgers_[r].add_find(std::move(find))) return;
    source_.add_to_corpus(scene);
    const std::lock_guard lock(progress_mutex_);
    ++progress_.finds[verdict];
  }

  // Collects every renderer's answer to every find.
  void answer_all(std::vector<Find>& finds) {
    std::vector<Scene> scenes;
    for (const Find& find : finds) scenes.push_back(find.scene);
    for (std::size_t r = 0; r < renderers_.size(); ++r) {
      Trial trial = trial_of(r, 0);
      const std::vector<TrialAnswer> answers = trial.ask(scenes);
      for (std::size_t i = 0; i < finds.size(); ++i)
        finds[i].answers.push_back({renderers_[r].name, describe(answers[i].result)});
    }
  }

  FuzzReport finished() {
    for (std::size_t r = 0; r < renderers_.size(); ++r) {
      FuzzedRenderer& renderer = report_.renderers[r];
      renderer.info = workers_[0][r]->info();
      for (Find& find : ledgers_[r].take_finds()) report_.finds.push_back(std::move(find));
      renderer.known = ledgers_[r].known_met();
    }
    report_.stopped = is_stopped();
    try {
      if (!report_.stopped) answer_all(report_.finds);
    } catch (const SearchStopped&) {
      report_.stopped = true;
    }
    return std::move(report_);
  }

  const std::vector<FuzzRenderer>& renderers_;
  const FuzzOptions& options_;
  SceneSource source_;
  Clock::time_point start_;
  std::vector<Screen> screens_;                                  // by renderer
  std::vector<Ledger> ledgers_;                                  // by renderer
  std::vector<std::deque<Candidate>> waiting_;                   // by renderer
  std::vector<std::vector<std::unique_ptr<Renderer>>> workers_;  // by thread, by renderer
  std::size_t round_ = 1;
  bool has_found_ = false;         // something that is or may be a find
  std::size_t asked_ = 0;          // scenes to be rendered, including mutations that were not found
  std::size_t minimize_asks_ = 0;  // scenes rendered to make others small
  FuzzReport report_;
  std::mutex progress_mutex_;
  FuzzProgress progress_;
};

}  // namespace

FuzzReport fuzz(const std::vector<FuzzRenderer>& renderers, const FuzzOptions& options) {
  return Search(renderers, options).run();
}

}  // namespace edgecase
