// Threads that share work by strips.

#include "crew.hpp"

#include <utility>

namespace settle::mpm {

namespace {

/// Looks for a change for about as long as is between two phases of a step, then sleeps until there is one.
void await_change(const std::atomic<std::uint32_t>& state, std::uint32_t old) {
  constexpr int looks = 200; // each gives the processor to whoever else waits for it
  for (int look = 0; look < looks; ++look) {
    if (state.load(std::memory_order_acquire) != old) return;
    std::this_thread::yield();
  }
  state.wait(old, std::memory_order_acquire);
}

} // namespace

Shares shares_by_weight(const std::vector<std::size_t>& weights, int threads) {
  std::size_t total = 0;
  for (const std::size_t weight : weights)
    total += weight;
  Shares shares{.first = {0}};
  const auto n = static_cast<std::size_t>(threads);
  std::size_t sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i];
    const std::size_t due = shares.first.size() * total; // ends the share that the middle of i is beyond
    if (shares.first.size() < n && sum * n >= due) shares.first.push_back(static_cast<int>(i) + 1);
  }
  shares.first.resize(n + 1, static_cast<int>(weights.size()));
  return shares;
}

Shares equal_shares(int n, int threads) {
  return shares_by_weight(std::vector<std::size_t>(static_cast<std::size_t>(n), 1), threads);
}

Crew::~Crew() {
  state_ |= over;
  state_.notify_all();
}

void Crew::run(const Shares& shares, const Task& task) {
  hand_out(shares);
  task_ = task;
  const bool alone = shares.threads() == 1;
  if (!alone) {
    state_.store((state_.load(std::memory_order_relaxed) & ~open) + round + open, std::memory_order_release);
    state_.notify_all();
  }
  take_part(0);
  if (!alone) {
    std::uint32_t state = state_.fetch_and(~open, std::memory_order_acq_rel) & ~open;
    for (; state % open != 0; state = state_.load(std::memory_order_acquire))
      await_change(state_, state);
  }
  for (Part& part : parts_)
    if (part.error) std::rethrow_exception(std::exchange(part.error, nullptr));
}

/// While no helper is at work.
void Crew::hand_out(const Shares& shares) {
  const auto n = static_cast<std::size_t>(shares.threads());
  if (parts_.size() != n) parts_ = std::vector<Part>(n);
  for (std::size_t t = 0; t < n; ++t) {
    parts_[t].last = shares.first[t + 1];
    parts_[t].next.store(shares.first[t], std::memory_order_relaxed);
  }
  for (int thread = static_cast<int>(helpers_.size()) + 1; thread < shares.threads(); ++thread)
    helpers_.emplace_back([this, thread] { help(thread); });
}

/// Its own share, then the others'.
void Crew::take_part(int thread) {
  const auto own = static_cast<std::size_t>(thread);
  try {
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      Part& part = parts_[(own + k) % parts_.size()];
      for (int i = part.next++; i < part.last; i = part.next++)
        task_.call(task_.context, i, thread);
    }
  } catch (...) {
    parts_[own].error = std::current_exception();
  }
}

/// What a helper does for as long as there is a crew.
void Crew::help(int thread) {
  for (std::uint32_t last_round = 0;;) {
    std::uint32_t state = state_.load(std::memory_order_acquire);
    if ((state & over) != 0) return;
    if ((state & open) == 0 || state / round == last_round) {
      await_change(state_, state);
      continue;
    }
    if (!state_.compare_exchange_weak(state, state + 1, std::memory_order_acq_rel)) continue;
    last_round = state / round;
    if (static_cast<std::size_t>(thread) < parts_.size()) take_part(thread);
    state_.fetch_sub(1, std::memory_order_acq_rel);
    state_.notify_all();
  }
}

} // namespace settle::mpm
