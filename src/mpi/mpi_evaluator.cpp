// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi_evaluator.hpp"

#include <mpi.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/measured_point.hpp"

namespace lamina {
namespace {

using Clock = std::chrono::steady_clock;

enum Tag : int {
  kPoint,      ///< to others: the values of a point
  kCancel,     ///< to others: give up the point
  kStop,       ///< to others: no more points
  kResponses,  ///< to the leader: responses of the point
  kFailure,    ///< to the leader: why it failed
  kGivenUp,    ///< to the leader: the point was cancelled
  kUnable,     ///< to the leader: why no point can be measured here
};

constexpr auto kPause = std::chrono::milliseconds(1);
/// Between two looks whether the leader cancels.
constexpr auto kCancelPause = std::chrono::milliseconds(20);

/// A message that has arrived.
struct Arrival {
  int source = 0;
  int tag = 0;
  std::vector<double> numbers;  ///< kPoint, kResponses
  std::string text;             ///< kFailure, kUnable
};

bool hasArrived(int source, int tag, MPI_Status& status) {
  int flag = 0;
  MPI_Iprobe(source, tag, MPI_COMM_WORLD, &flag, &status);
  return flag != 0;
}

Arrival received(const MPI_Status& status) {
  Arrival arrival{status.MPI_SOURCE, status.MPI_TAG, {}, {}};
  int count = 0;
  if (arrival.tag == kFailure || arrival.tag == kUnable) {
    MPI_Get_count(&status, MPI_CHAR, &count);
    arrival.text.resize(static_cast<std::size_t>(count));
    MPI_Recv(arrival.text.data(), count, MPI_CHAR, arrival.source, arrival.tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return arrival;
  }
  MPI_Get_count(&status, MPI_DOUBLE, &count);
  arrival.numbers.resize(static_cast<std::size_t>(count));
  MPI_Recv(arrival.numbers.data(), count, MPI_DOUBLE, arrival.source, arrival.tag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return arrival;
}

void sendText(const std::string& text, Tag tag) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, tag, MPI_COMM_WORLD);
}

void sendNumbers(const std::vector<double>& numbers, int target, Tag tag) {
  MPI_Send(numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, target, tag, MPI_COMM_WORLD);
}

/// Points handed out in one call, and what came back of them.
class HandOut {
 public:
  HandOut(const std::vector<DesignPoint>& points, const std::vector<std::string>& names, int processes)
      : points_(points),
        names_(names),
        evaluations_(points.size()),
        at_(static_cast<std::size_t>(processes), kIdle) {}

  std::vector<Evaluation> run(const EvaluationListener& done, Progress& progress) {
    while (busy_ > 0 || (next_ < points_.size() && !is_cancelled_)) {
      if (!is_cancelled_ && progress.isCancelled()) cancel();
      if (!is_cancelled_) handOut();
      MPI_Status status;
      if (hasArrived(MPI_ANY_SOURCE, MPI_ANY_TAG, status))
        take(received(status), done, progress);
      else
        std::this_thread::sleep_for(kPause);
    }
    if (failure_) std::rethrow_exception(failure_);
    if (is_cancelled_) throw Cancelled("evaluate was cancelled");
    return std::move(evaluations_);
  }

 private:
  static constexpr std::size_t kIdle = static_cast<std::size_t>(-1);

  void handOut() {
    for (std::size_t process = 1; process < at_.size() && next_ < points_.size(); ++process) {
      if (at_[process] != kIdle) continue;
      sendNumbers(points_[next_], static_cast<int>(process), kPoint);
      at_[process] = next_++;
      ++busy_;
    }
  }

  void cancel() {
    is_cancelled_ = true;
    for (std::size_t process = 1; process < at_.size(); ++process)
      if (at_[process] != kIdle) sendNumbers({}, static_cast<int>(process), kCancel);
  }

  void take(Arrival arrival, const EvaluationListener& done, Progress& progress) {
    const std::size_t i = std::exchange(at_[static_cast<std::size_t>(arrival.source)], kIdle);
    --busy_;
    if (arrival.tag == kGivenUp && is_cancelled_) return;
    if (arrival.tag == kUnable)
      return endBy(std::make_exception_ptr(
          InvalidInput("process " + std::to_string(arrival.source) + " cannot measure: " + arrival.text)));
    evaluations_[i] = evaluationOf(points_[i], std::move(arrival));
    progress.report("evaluate", static_cast<double>(++finished_) / static_cast<double>(points_.size()));
    try {
      if (done && !failure_) done(evaluations_[i]);
    } catch (...) {
      endBy(std::current_exception());
    }
  }

  Evaluation evaluationOf(const DesignPoint& point, Arrival arrival) const {
    if (arrival.tag == kResponses) return measuredPoint(point, std::move(arrival.numbers), names_);
    if (arrival.tag == kGivenUp) return {point, {}, "gave up though nobody cancelled"};
    return {point, {}, std::move(arrival.text)};
  }

  /// The others are waited for, so that no answer is left for the next call.
  void endBy(std::exception_ptr failure) {
    if (!failure_) failure_ = std::move(failure);
    if (!is_cancelled_) cancel();
  }

  const std::vector<DesignPoint>& points_;
  const std::vector<std::string>& names_;
  std::vector<Evaluation> evaluations_;
  std::vector<std::size_t> at_;  ///< the point each process is at
  std::size_t next_ = 0;
  std::size_t busy_ = 0;
  std::size_t finished_ = 0;
  bool is_cancelled_ = false;
  std::exception_ptr failure_;
};

/// Cancelled when the leader says so. Asked from any thread; one at a time speaks with MPI.
class ServedProgress final : public Progress {
 public:
  void report(const std::string&, double) override {}
  bool isCancelled() const override {
    if (is_cancelled_) return true;
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (!lock || Clock::now() < next_look_) return is_cancelled_;
    next_look_ = Clock::now() + kCancelPause;
    MPI_Status status;
    if (!hasArrived(0, kCancel, status)) return false;
    received(status);
    is_cancelled_ = true;
    return true;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::atomic<bool> is_cancelled_{false};
  mutable Clock::time_point next_look_;
};

void serve(const PointMeasurement& measure, const DesignPoint& point) {
  ServedProgress progress;
  try {
    sendNumbers(measure(point, progress), 0, kResponses);
  } catch (const Cancelled&) {
    sendNumbers({}, 0, kGivenUp);
  } catch (...) {
    sendText(currentFailure().message, kFailure);
  }
}

/// What a process measures with, or why it cannot.
struct Ability {
  PointMeasurement measure;
  std::string fault;
};

Ability abilityBy(const std::function<PointMeasurement()>& make) {
  try {
    return {make(), {}};
  } catch (...) {
    return {{}, currentFailure().message};
  }
}

}  // namespace

MpiSession::MpiSession() {
  int provided = MPI_THREAD_SINGLE;
  const int code = MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  if (code != MPI_SUCCESS || provided < MPI_THREAD_SERIALIZED)
    throw Error(ErrorCode::Internal, "MPI does not start for several threads");
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

MpiSession::~MpiSession() {
  if (isLeader())
    for (int process = 1; process < size_; ++process)
      MPI_Send(nullptr, 0, MPI_DOUBLE, process, kStop, MPI_COMM_WORLD);
  MPI_Finalize();
}

MpiEvaluator::MpiEvaluator(const MpiSession& session, std::vector<std::string> response_names,
                           PointMeasurement measure)
    : size_(session.size()), alone_(std::move(response_names), std::move(measure)) {}

std::vector<Evaluation> MpiEvaluator::evaluate(const std::vector<DesignPoint>& points,
                                               const EvaluationListener& done, Progress& progress) {
  if (size_ == 1) return alone_.evaluate(points, done, progress);
  return HandOut(points, responseNames(), size_).run(done, progress);
}

void servePoints(const std::function<PointMeasurement()>& make) {
  const Ability ability = abilityBy(make);
  while (true) {
    MPI_Status status;
    if (!hasArrived(0, MPI_ANY_TAG, status)) {
      std::this_thread::sleep_for(kPause);
      continue;
    }
    const Arrival arrival = received(status);
    if (arrival.tag == kStop) return;
    // A cancelling that came after the answer is of no use any more.
    if (arrival.tag != kPoint) continue;
    ability.fault.empty() ? serve(ability.measure, arrival.numbers) : sendText(ability.fault, kUnable);
  }
}

}  // namespace lamina
