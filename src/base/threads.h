// SPDX-License-Identifier: MIT
//
// Work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <future>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace edgecase {

// Calls work(i) for each i below `count`, each on a thread of its own, and waits for all of them.
// Then throws the exception of the first that has thrown one.
template <class Work>
void run_threads(std::size_t count, const Work& work) {
  std::vector<std::future<void>> threads;
  for (std::size_t i = 0; i < count; ++i)
    threads.push_back(std::async(std::launch::async, [&work, i] { work(i); }));
  for (const std::future<void>& thread : threads) thread.wait();
  for (std::future<void>& thread : threads) thread.get();
}

// Calls work(i) for each i below `count`, in any order, on a thread for each processor. Throws what
// one of them throws.
template <class Work>
void for_each_index(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next = 0;
  const std::size_t processors = std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
  run_threads(std::min(processors, count), [&](std::size_t) {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  });
}

// Values that threads make in advance, and one thread takes in the order in which they were
// started. What `make` refers to must live until the value is taken, or until this is destroyed.
// There is one thread for each processor, since starting one for each value costs as much as making
// a small one.
template <class Value>
class Ahead {
 public:
  Ahead() = default;
  Ahead(const Ahead&) = delete;
  Ahead& operator=(const Ahead&) = delete;
  // Values that were not taken, and whose making has not begun, are not made.
  ~Ahead() {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
      waiting_.clear();
    }
    change_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  bool empty() const { return started_.empty(); }
  // Has every processor enough to do? Then take one before the next is started, for memory's sake.
  bool is_full() const { return started_.size() >= 2 * processors_; }
  template <class Make>
  void start(Make make) {
    std::packaged_task<Value()> task(std::move(make));
    started_.push_back(task.get_future());
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back(std::move(task));
    }
    change_.notify_one();
    if (threads_.size() < processors_) threads_.emplace_back([this] { work(); });
  }
  // The value that was started first. Throws what its making threw.
  Value take() {
    std::future<Value> first = std::move(started_.front());
    started_.pop_front();
    return first.get();
  }

 private:
  void work() {
    while (true) {
      std::unique_lock lock(mutex_);
      change_.wait(lock, [&] { return is_ending_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      std::packaged_task<Value()> task = std::move(waiting_.front());
      waiting_.pop_front();
      lock.unlock();
      task();
    }
  }

  const std::size_t processors_ = std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
  std::deque<std::future<Value>> started_;
  std::mutex mutex_;
  std::condition_variable change_;
  std::deque<std::packaged_task<Value()>> waiting_;
  bool is_ending_ = false;
  std::vector<std::thread> threads_;
};

// Calls make(i) for each i below `count`, on several threads, and take(i, value) on this one, in
// order. Throws what either throws. A thread makes up to eight values together, or fewer if these
// take a megabyte: bytes(i) is about the memory of a value.
template <class Make, class Take, class Bytes>
void make_in_order(std::size_t count, const Make& make, const Take& take, const Bytes& bytes) {
  constexpr std::size_t kTogether = 8;
  constexpr std::size_t kEnough = std::size_t{1} << 20;
  using Values = std::vector<std::invoke_result_t<const Make&, std::size_t>>;
  Ahead<Values> ahead;
  std::size_t taken = 0;
  const auto take_first = [&] {
    for (auto& value : ahead.take()) take(taken++, std::move(value));
  };
  for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
    std::size_t together = 0;
    for (; end < count && end < begin + kTogether && together < kEnough; ++end)
      together += bytes(end);
    if (ahead.is_full()) take_first();
    ahead.start([begin, end, &make] {
      Values values;
      values.reserve(end - begin);
      for (std::size_t i = begin; i < end; ++i) values.push_back(make(i));
      return values;
    });
  }
  while (!ahead.empty()) take_first();
}
template <class Make, class Take>
void make_in_order(std::size_t count, const Make& make, const Take& take) {
  make_in_order(count, make, take, [](std::size_t) { return std::size_t{0}; });
}

}  // namespace edgecase
