/// \file
/// Work on the strips of a body by several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <thread>
#include <vector>

namespace settle::mpm {

/// Work 0 ... n - 1 in contiguous shares, one a thread: share t is first[t] ... first[t + 1] - 1.
struct Shares {
  std::vector<int> first;
  [[nodiscard]] int threads() const { return static_cast<int>(first.size()) - 1; }
};
/// Of about the same weight; `weights`: of every piece of work.
Shares shares_by_weight(const std::vector<std::size_t>& weights, int threads);
Shares equal_shares(int n, int threads);

/// Does work on several threads: each does its share and then takes what is left of the others'. A thread that the
/// machine has not given a processor, because other programs run, is not waited for unless it has begun: then the
/// calling thread does all by itself. The threads stay from one call to the next; between calls they look for work for
/// some microseconds and then sleep.
class Crew {
public:
  Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  ~Crew();

  /// Calls `work(i, thread)` once for every i of the shares. What is done with an i must not depend on the thread.
  /// Throws what `work` has thrown, once no thread is at work any more.
  template <class Work>
  void run(const Shares& shares, const Work& work) {
    run(shares, Task{.context = &work, .call = [](const void* context, int i, int thread) {
                       (*static_cast<const Work*>(context))(i, thread);
                     }});
  }

private:
  struct Task {
    const void* context = nullptr;
    void (*call)(const void* context, int i, int thread) = nullptr;
  };
  /// What a thread has to do.
  struct Part {
    int last = 0;
    std::exception_ptr error;
    alignas(64) std::atomic<int> next = 0; ///< nobody has taken it yet
  };

  std::vector<Part> parts_; ///< by thread
  Task task_;
  /// How many helpers are at work, whether more may begin (`open`), whether the crew is dismissed (`over`), and in
  /// steps of `round` how often `run` was called.
  std::atomic<std::uint32_t> state_ = 0;
  std::vector<std::jthread> helpers_; ///< the first is thread 1: 0 is the calling one

  static constexpr std::uint32_t open = 1U << 12, over = open << 1, round = over << 1;

  void run(const Shares& shares, const Task& task);
  void hand_out(const Shares& shares);
  void take_part(int thread);
  void help(int thread);
};

} // namespace settle::mpm
