#include "progress.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>

#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "progress_text.hpp"

namespace settle::compare::cli {
namespace {

using nlohmann::json;

/// One line for each solver run that has ended.
class Lines : public Display {
public:
  void plan(const Plan& plan) override { fmt::print("{}", plan_text(plan)); }
  void progress(const Progress& progress) override {
    if (progress.ended != nullptr) fmt::print(stderr, "{}\n", ended_line(progress));
  }
  void end(exchange::ExitCode, const std::string& summary, const std::string& report) override {
    fmt::print("{}\n", summary);
    if (!report.empty()) fmt::print("report: {}\n", report);
  }
};

std::size_t terminal_width() {
  winsize size{};
  constexpr std::size_t usual = 80;
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

/// One line that is written over, at every change and every second. A failed solver leaves a line of its own.
class Line : public Lines {
public:
  Line() : clock_([this](const std::stop_token& stop) { tick(stop); }) {}
  ~Line() override {
    clock_.request_stop();
    clock_.join();
    clear();
  }
  void progress(const Progress& progress) override {
    const std::scoped_lock lock(mutex_);
    if (progress.ended != nullptr && progress.ended->status != SolverStatus::finished) {
      clear();
      Lines::progress(progress);
    }
    last_ = progress;
    last_->ended = nullptr;
    since_ = Clock::now();
    show();
  }
  void end(exchange::ExitCode code, const std::string& summary, const std::string& report) override {
    const std::scoped_lock lock(mutex_);
    clear();
    last_.reset();
    Lines::end(code, summary, report);
  }

private:
  using Clock = std::chrono::steady_clock;
  static void clear() { fmt::print(stderr, "\r\x1b[K"); }
  void show() const {
    if (!last_) return;
    Progress now = *last_;
    if (now.seconds_left)
      now.seconds_left =
          std::max(0.0, *now.seconds_left - std::chrono::duration<double>(Clock::now() - since_).count());
    fmt::print(stderr, "\r\x1b[K{}", progress_line(now, terminal_width() - 1));
    std::fflush(stderr);
  }
  void tick(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, stop, std::chrono::seconds(1), [&] { return stop.stop_requested(); }))
      show();
  }

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Progress> last_;
  Clock::time_point since_;
  std::jthread clock_; ///< the last member: it uses the others
};

/// One JSON object a line on standard output; docs/campaigns.md lists them.
class JsonLines : public Display {
public:
  void plan(const Plan& plan) override {
    for (const std::size_t index : order_of(plan)) {
      const Task& task = plan.tasks[index];
      json event{{"event", "planned"},   {"run", plan.runs[task.run].name}, {"solver", task.job.solver},
                 {"due", task.is_due()}, {"reason", name_of(task.reason)},  {"last_wall_time", nullptr}};
      if (task.record) event["last_wall_time"] = task.record->wall_time;
      write(event);
    }
  }
  void progress(const Progress& progress) override {
    json event{{"event", progress.ended != nullptr ? "ended" : "started"},
               {"run", progress.run},
               {"solver", progress.solver},
               {"reason", name_of(progress.reason)},
               {"finished", progress.finished},
               {"total", progress.total},
               {"seconds_left", nullptr}};
    if (progress.seconds_left) event["seconds_left"] = *progress.seconds_left;
    if (progress.ended != nullptr) add_end(*progress.ended, event);
    write(event);
  }
  void end(exchange::ExitCode code, const std::string&, const std::string& report) override {
    write({{"event", "campaign ended"}, {"exit_code", static_cast<int>(code)}, {"report", report}});
  }

private:
  static void add_end(const SolverRun& run, json& event) {
    event["status"] = name_of(run.status);
    event["reused"] = run.reused;
    event["wall_time"] = run.wall_time;
    event["cpu_time"] = run.cpu_time;
    event["peak_memory"] = run.peak_memory;
    event["message"] = run.message;
  }
  static void write(const json& event) {
    fmt::print("{}\n", event.dump(-1, ' ', false, json::error_handler_t::replace));
    std::fflush(stdout);
  }
};

} // namespace

const std::vector<std::string>& display_kinds() {
  static const std::vector<std::string> kinds{"auto", "line", "lines", "json"};
  return kinds;
}

std::unique_ptr<Display> make_display(const std::string& kind) {
  if (kind == "json") return std::make_unique<JsonLines>();
  const bool over = kind == "line" || (kind == "auto" && isatty(STDERR_FILENO) == 1);
  return over ? std::make_unique<Line>() : std::make_unique<Lines>();
}

} // namespace settle::compare::cli
