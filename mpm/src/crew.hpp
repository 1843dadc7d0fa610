/// \file
/// Work on the strips of a body by several threads.
#pragma once

#include <cstddef>
#include <vector>

namespace settle::mpm {

/// Calls `work(i, thread)` for every i, in contiguous shares of about the same weight, one a thread. What is done with
/// an i must not depend on the thread. OpenMP keeps the threads from one call to the next.
class Crew {
public:
  /// `weights`: of every i.
  void divide(const std::vector<std::size_t>& weights, int threads) {
    std::size_t total = 0;
    for (const std::size_t weight : weights)
      total += weight;
    first_.assign(1, 0);
    std::size_t sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      sum += weights[i];
      const std::size_t due = first_.size() * total; // ends the share that the middle of i is beyond
      if (first_.size() < static_cast<std::size_t>(threads) && sum * static_cast<std::size_t>(threads) >= due)
        first_.push_back(static_cast<int>(i) + 1);
    }
    first_.resize(static_cast<std::size_t>(threads), static_cast<int>(weights.size()));
    first_.push_back(static_cast<int>(weights.size()));
  }
  [[nodiscard]] int size() const { return static_cast<int>(first_.size()) - 1; }

  template <class Work>
  void run(const Work& work) const {
    if (size() == 1) return share(0, work);
#pragma omp parallel for num_threads(size()) schedule(static, 1)
    for (int thread = 0; thread < size(); ++thread)
      share(thread, work);
  }

private:
  std::vector<int> first_; ///< (threads + 1)

  template <class Work>
  void share(int thread, const Work& work) const {
    const auto t = static_cast<std::size_t>(thread);
    for (int i = first_[t]; i < first_[t + 1]; ++i)
      work(i, thread);
  }
};

} // namespace settle::mpm
