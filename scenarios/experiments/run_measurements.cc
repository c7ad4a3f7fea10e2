#include "scenarios/experiments/run_measurements.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace touchdown::experiments {
namespace {

using PendingMeasurements = std::vector<const Measurement*>;

/// Runs measurements in several threads, and stores their results.
class MeasurementPool {
 public:
  MeasurementPool(const MeasurementStore& store, const util::StopRequested& stop_requested,
                  const MeasurementProgress& progress, Measured& measured, double done_s, double total_s)
      : store_(store),
        stop_requested_([this, stop_requested] { return failed_ || (stop_requested && stop_requested()); }),
        progress_(progress),
        measured_(measured),
        done_s_(done_s),
        total_s_(total_s) {}

  /// Runs all `pending` measurements, at most `jobs` concurrently. Rethrows the first exception.
  void Run(const PendingMeasurements& pending, int jobs) {
    next_ = 0;
    std::vector<std::jthread> workers;
    for (int i = 0; i < std::min(jobs, static_cast<int>(pending.size())); ++i) {
      workers.emplace_back([&] { RunWorker(pending); });
    }
    workers.clear();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void RunWorker(const PendingMeasurements& pending) {
    for (;;) {
      const std::size_t i = next_++;
      if (i >= pending.size() || failed_) return;
      try {
        if (stop_requested_()) throw util::Interrupted();
        Json value = pending[i]->measure(stop_requested_);
        store_.Put(pending[i]->id, value);
        Record(*pending[i], std::move(value));
      } catch (...) {
        RecordFailure();
        return;
      }
    }
  }

  void Record(const Measurement& measurement, Json value) {
    const std::lock_guard lock(mutex_);
    measured_[measurement.id] = std::move(value);
    done_s_ += measurement.expected_s;
    if (progress_) progress_(std::min(1.0, done_s_ / total_s_), measurement.id);
  }

  void RecordFailure() {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    failed_ = true;
  }

  const MeasurementStore& store_;
  util::StopRequested stop_requested_;
  const MeasurementProgress& progress_;
  Measured& measured_;
  double done_s_;
  double total_s_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
  std::mutex mutex_;
};

}  // namespace

Measured RunMeasurements(const std::vector<Measurement>& measurements, const MeasurementStore& store, int jobs,
                         const util::StopRequested& stop_requested, const MeasurementProgress& progress) {
  Measured measured;
  PendingMeasurements concurrent, alone;
  double done_s = 0.0, total_s = 0.0;
  for (const Measurement& measurement : measurements) {
    total_s += measurement.expected_s;
    if (auto value = store.Find(measurement.id)) {
      measured[measurement.id] = std::move(*value);
      done_s += measurement.expected_s;
    } else {
      (measurement.alone ? alone : concurrent).push_back(&measurement);
    }
  }
  std::stable_sort(concurrent.begin(), concurrent.end(),
                   [](const Measurement* a, const Measurement* b) { return a->expected_s > b->expected_s; });
  MeasurementPool pool(store, stop_requested, progress, measured, done_s, total_s);
  pool.Run(concurrent, jobs);
  pool.Run(alone, 1);
  return measured;
}

}  // namespace touchdown::experiments
