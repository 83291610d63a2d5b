// SPDX-License-Identifier: MIT
//
// What a run has finished, written as it goes, so that a run that is killed or crashes loses no
// more than the cases at hand: `edgecase run --resume` goes on with it.
//
// The journal of FILE is FILE.unfinished, a results file that is cut off (results/results_json.h):
// a frame of Zstandard for each case, and behind it a skippable frame (RFC 8878) with the code of
// both it and the code before (results_key.h). It is there while the run goes on, and stays if that
// ends in any other way than by writing FILE. A write(2) for each case is enough: what the kernel
// has, no end of a process takes away.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "run/merge.h"
#include "run/run.h"
#include "tools/edgecase/results_key.h"

namespace edgecase {

// What lies beside a results file of which a run was killed.
std::filesystem::path journal_of(const std::filesystem::path& results);

class Journal final : public FinishedCases {
 public:
  // Of a run that is to write the file `results`. `key`, which must live as long, may be null: then
  // there are no codes. Where the journal cannot be written, there is none, and nothing is said:
  // the results will meet the same fault.
  Journal(const std::filesystem::path& results, const ResultsKey* key);
  ~Journal() override;  // the file stays
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // Takes the place of an earlier journal: empty, or with what an earlier run had finished.
  void start();
  void hold(const Results& earlier) override;

  void begin(const Results& run) override;
  void add(const CaseResults& one) override;

  // The run has written its results.
  void remove();

 private:
  struct Packer;

  void open_beside();
  void take_place();
  void write_frame(const std::string& text);
  bool is_at(const std::filesystem::path& path) const;

  const std::filesystem::path path_;
  std::filesystem::path beside_;  // the file's name until it takes its place
  int file_ = -1;
  std::unique_ptr<Packer> packer_;
  std::optional<ResultsKey::Coder> coder_;
  std::string last_code_;
  std::size_t heads_ = 0;  // that were written
  std::vector<RendererInfo> renderers_;
};

// What a journal holds up to its last whole frame.
struct JournalRead {
  std::optional<MergePart> run;  // nothing: no case was finished
  bool is_own = false;           // every frame has its code under the key
};

// Reads the journal at `path`; otherwise a sentence that says what is wrong with it. `key` may be
// null. One that is not the user's own is not read, unless it is named.
std::variant<JournalRead, std::string> read_journal(const std::filesystem::path& path,
                                                    const ResultsKey* key, bool is_named);

}  // namespace edgecase
