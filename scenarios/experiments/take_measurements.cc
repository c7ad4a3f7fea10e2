#include "scenarios/experiments/take_measurements.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace touchdown::experiments {
namespace {

using Todo = std::vector<const Measurement*>;

/// Hands measurements out to several threads, and takes what they bring.
class Crew {
 public:
  Crew(const MeasurementStore& store, const util::StopRequested& stop_requested, const MeasurementProgress& progress,
       Measured& measured, double done_s, double whole_s)
      : store_(store),
        stop_requested_([this, stop_requested] { return failed_ || (stop_requested && stop_requested()); }),
        progress_(progress),
        measured_(measured),
        done_s_(done_s),
        whole_s_(whole_s) {}

  void Take(const Todo& todo, int jobs) {
    next_ = 0;
    std::vector<std::jthread> workers;
    for (int i = 0; i < std::min(jobs, static_cast<int>(todo.size())); ++i) {
      workers.emplace_back([&] { Work(todo); });
    }
    workers.clear();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void Work(const Todo& todo) {
    for (;;) {
      const std::size_t i = next_++;
      if (i >= todo.size() || failed_) return;
      try {
        if (stop_requested_()) throw util::Interrupted();
        Json value = todo[i]->take(stop_requested_);
        store_.Put(todo[i]->id, value);
        Bring(*todo[i], std::move(value));
      } catch (...) {
        Fail();
        return;
      }
    }
  }

  void Bring(const Measurement& measurement, Json value) {
    const std::lock_guard lock(mutex_);
    measured_[measurement.id] = std::move(value);
    done_s_ += measurement.expected_s;
    if (progress_) progress_(std::min(1.0, done_s_ / whole_s_), measurement.id);
  }

  void Fail() {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    failed_ = true;
  }

  const MeasurementStore& store_;
  util::StopRequested stop_requested_;
  const MeasurementProgress& progress_;
  Measured& measured_;
  double done_s_;
  double whole_s_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
  std::mutex mutex_;
};

}  // namespace

Measured TakeMeasurements(const std::vector<Measurement>& measurements, const MeasurementStore& store, int jobs,
                          const util::StopRequested& stop_requested, const MeasurementProgress& progress) {
  Measured measured;
  Todo together, alone;
  double done_s = 0.0, whole_s = 0.0;
  for (const Measurement& measurement : measurements) {
    whole_s += measurement.expected_s;
    if (auto value = store.Find(measurement.id)) {
      measured[measurement.id] = std::move(*value);
      done_s += measurement.expected_s;
    } else {
      (measurement.alone ? alone : together).push_back(&measurement);
    }
  }
  std::stable_sort(together.begin(), together.end(),
                   [](const Measurement* a, const Measurement* b) { return a->expected_s > b->expected_s; });
  Crew crew(store, stop_requested, progress, measured, done_s, whole_s);
  crew.Take(together, jobs);
  crew.Take(alone, 1);
  return measured;
}

}  // namespace touchdown::experiments
