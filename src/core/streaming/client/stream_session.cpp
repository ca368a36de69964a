// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/client/stream_session.hpp"

#include <boost/asio/post.hpp>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "lamina/base/clock.hpp"
#include "lamina/streaming/transport/transport.hpp"
#include "streaming/transport/deadline_timer.hpp"
#include "streaming/transport/thread_priority.hpp"

namespace lamina {
namespace {

constexpr double kProgressInterval = 0.05;  // s
constexpr std::chrono::milliseconds kReopenInterval{200};

StreamSettings atPort(StreamSettings settings, const std::string& port) {
  if (settings.link == LinkKind::Auto) settings.link = linkOf(port);
  return settings;
}

}  // namespace

class StreamSession::Impl {
 public:
  Impl(const StreamableProgram& program, const StreamSettings& settings, MachinePort port, Observer observer,
       ReplyListener heard)
      : port_(std::move(port)),
        observer_(std::move(observer)),
        streamer_(program, atPort(settings, port_.name), std::move(heard)),
        transport_(makeTransport(context_, port_.name, port_.baud)),
        timer_(context_, clock_, [this] { onDeadline(); }) {
    transport_->open(events());
    boost::asio::post(context_, [this] {
      streamer_.start(clock_.now());
      flush();
    });
    thread_ = std::thread([this] { run(); });
  }

  ~Impl() {
    abort({ErrorCode::Cancelled, "the job was abandoned"});
    thread_.join();
  }

  void pause() {
    command([this](double now) { streamer_.pause(now); });
  }
  void resume() {
    command([this](double now) { streamer_.resume(now); });
  }
  void abort(const Failure& why) {
    command([this, why](double now) { streamer_.abort(why, now); });
  }

  StreamStatus status() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return snapshot_;
  }

  bool isOver() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return is_over_;
  }

  bool waitFor(double timeout_s) const {
    std::unique_lock<std::mutex> lock(mutex_);
    return over_.wait_for(lock, std::chrono::duration<double>(timeout_s), [this] { return is_over_; });
  }

 private:
  TransportEvents events() {
    return {[this](std::string_view bytes) {
              streamer_.receive(bytes, clock_.now());
              flush();
            },
            [this](const std::string& why) {
              streamer_.disconnect("lost the link: " + why, clock_.now());
              flush();
            }};
  }

  /// Until the job is over; a link that was lost is opened again for the safe stop.
  void run() {
    preferThisThread();
    context_.run();
    while (!is_closed_) {
      std::this_thread::sleep_for(kReopenInterval);
      onDeadline();
      if (is_closed_ || !reopen()) continue;
      streamer_.reconnect(clock_.now());
      flush();
      context_.restart();
      context_.run();
    }
  }

  bool reopen() {
    try {
      transport_->open(events());
      return true;
    } catch (const Error&) {
      return false;  // tried again until the streamer gives up
    }
  }

  template <class Command>
  void command(Command command) {
    boost::asio::post(context_, [this, command] {
      command(clock_.now());
      flush();
    });
  }

  void onDeadline() {
    if (is_closed_) return;
    streamer_.elapse(clock_.now());
    flush();
  }

  /// Passes on what the streamer wants after each event.
  void flush() {
    if (is_closed_) return;
    const std::string output = streamer_.takeOutput();
    if (!output.empty()) transport_->send(output);
    notify();
    if (isFinal(streamer_.status().state)) {
      finish();
    } else if (streamer_.isOffline()) {
      timer_.cancel();
      transport_->close();
    } else {
      timer_.set(streamer_.nextDeadline());
    }
  }

  void notify() {
    const auto entered = streamer_.takeStateChanges();
    const double now = clock_.now();
    if (entered.empty() && now < next_progress_) return;
    next_progress_ = now + kProgressInterval;
    StreamStatus status = streamer_.status();
    if (status.failure.code != ErrorCode::Ok)
      status.failure.message = port_.name + ": " + status.failure.message;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      snapshot_ = status;
    }
    if (!observer_) return;
    for (std::size_t i = 0; i + 1 < entered.size(); ++i) {
      StreamStatus passing = status;
      passing.state = entered[i];
      observer_(passing);
    }
    observer_(status);
  }

  void finish() {
    is_closed_ = true;
    timer_.cancel();
    transport_->close();
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
    over_.notify_all();
  }

  SteadyClock clock_;
  boost::asio::io_context context_;
  MachinePort port_;
  Observer observer_;
  Streamer streamer_;
  std::unique_ptr<Transport> transport_;
  DeadlineTimer timer_;
  double next_progress_ = 0.0;
  bool is_closed_ = false;
  mutable std::mutex mutex_;
  mutable std::condition_variable over_;
  StreamStatus snapshot_;
  bool is_over_ = false;
  std::thread thread_;
};

StreamSession::StreamSession(const StreamableProgram& program, const StreamSettings& settings,
                             const MachinePort& port, Observer observer, ReplyListener heard)
    : impl_(std::make_unique<Impl>(program, settings, port, std::move(observer), std::move(heard))) {}
StreamSession::~StreamSession() = default;

void StreamSession::pause() { impl_->pause(); }
void StreamSession::resume() { impl_->resume(); }
void StreamSession::abort(const Failure& why) { impl_->abort(why); }
StreamStatus StreamSession::status() const { return impl_->status(); }
bool StreamSession::isOver() const { return impl_->isOver(); }
bool StreamSession::waitFor(double timeout_s) const { return impl_->waitFor(timeout_s); }

void throwIfFailed(const StreamStatus& status) {
  const Failure& failure = status.failure;
  switch (failure.code) {
    case ErrorCode::Ok:
      return;
    case ErrorCode::Cancelled:
      throw Cancelled(failure.message);
    case ErrorCode::Disconnected:
      throw Disconnected(failure.message);
    case ErrorCode::InvalidProgram:
      throw InvalidProgram(failure.message);
    case ErrorCode::Rejected:
      throw Rejected(failure.message);
    case ErrorCode::TimedOut:
      throw TimedOut(failure.message);
    default:
      throw DeviceError(failure.message);
  }
}

}  // namespace lamina
