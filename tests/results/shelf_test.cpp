// SPDX-License-Identifier: MIT
//
// What is put on a shelf comes back, wherever it lies.
#include "results/shelf.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace edgecase {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Bytes that cannot be packed.
std::string noise(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

// The first megabyte of them stays in memory.
std::vector<std::string> three_megabytes() {
  std::vector<std::string> all;
  for (unsigned i = 0; i < 30; ++i) all.push_back(noise(100'000 + 17 * i, i));
  return all;
}

// Puts them until one cannot be kept; the places are of those before it.
std::string fault_of_putting(const std::vector<std::string>& all, Shelf& shelf,
                             std::vector<Shelf::Place>& places) {
  try {
    for (const std::string& bytes : all) places.push_back(shelf.put(bytes));
  } catch (const ShelfError& error) {
    return error.what();
  }
  return "";
}

// TMPDIR, until this is gone.
class Folder {
 public:
  explicit Folder(const char* name) {
    if (const char* const before = std::getenv("TMPDIR")) before_ = before;
    setenv("TMPDIR", name, 1);
  }
  ~Folder() {
    if (before_.empty())
      unsetenv("TMPDIR");
    else
      setenv("TMPDIR", before_.c_str(), 1);
  }

 private:
  std::string before_;
};

TEST(Shelf, GivesBackWhatLiesInMemoryAndInTheFile) {
  Shelf shelf;
  const std::vector<std::string> all = three_megabytes();
  std::vector<Shelf::Place> places;
  for (const std::string& bytes : all) {
    places.push_back(shelf.put(bytes));
    EXPECT_EQ(shelf.at(places.back()), bytes);
    EXPECT_EQ(shelf.at(places.front()), all.front());
  }
  for (std::size_t i = all.size(); i-- > 0;) EXPECT_EQ(shelf.at(places[i]), all[i]) << i;
}

TEST(Shelf, PacksAndHoldsNothingAndMoreThanAMegabyteAtOnce) {
  Shelf shelf;
  const std::string zeros(5'000'000, '\0');
  const std::string large = noise(2'500'000, 1);
  const Shelf::Place none = shelf.put("");
  const Shelf::Place packed = shelf.put(zeros);
  const Shelf::Place beyond = shelf.put(large);
  const Shelf::Place last = shelf.put("");
  EXPECT_LT(packed.packed, 5'000u);
  EXPECT_EQ(shelf.at(none), "");
  EXPECT_EQ(shelf.at(packed), zeros);
  EXPECT_EQ(shelf.at(beyond), large);
  EXPECT_EQ(shelf.at(last), "");
}

TEST(Shelf, HasOnceWhatWasPutAMomentAgo) {
  Shelf shelf;
  const Shelf::Place first = shelf.put_repeated("first");
  const Shelf::Place second = shelf.put_repeated("second");
  EXPECT_EQ(shelf.put_repeated("first").begin, first.begin);
  EXPECT_NE(second.begin, first.begin);
  EXPECT_NE(shelf.put("first").begin, first.begin);
  for (int i = 0; i < 100; ++i) {
    const std::string other = std::to_string(i);
    EXPECT_EQ(shelf.at(shelf.put_repeated(other)), other);
  }
  EXPECT_EQ(shelf.at(shelf.put_repeated("first")), "first");
  EXPECT_EQ(shelf.at(first), "first");
  EXPECT_EQ(shelf.at(second), "second");
}

TEST(Shelf, NamesTheFolderThatIsNotThere) {
  const Folder nowhere("/nowhere/at/all");
  Shelf shelf;
  std::vector<Shelf::Place> places;
  EXPECT_THAT(fault_of_putting(three_megabytes(), shelf, places),
              AllOf(HasSubstr("/nowhere/at/all"), HasSubstr("No such file or directory"),
                    HasSubstr("TMPDIR")));
}

// As on a full disk: the file takes one part of what it is given, and no more.
TEST(Shelf, KeepsWhatItHasWhereTheFileTakesNoMore) {
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{1'500'000, limit.rlim_max};
  const std::vector<std::string> all = three_megabytes();
  Shelf shelf;
  std::vector<Shelf::Place> places;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string fault = fault_of_putting(all, shelf, places);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, before);
  EXPECT_THAT(fault, AllOf(HasSubstr("File too large"), HasSubstr("TMPDIR")));
  ASSERT_GT(places.size(), 15u);
  ASSERT_LT(places.size(), all.size());
  EXPECT_EQ(shelf.at(shelf.put("now there is room")), "now there is room");
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(shelf.at(places[i]), all[i]) << i;
}

}  // namespace
}  // namespace edgecase
