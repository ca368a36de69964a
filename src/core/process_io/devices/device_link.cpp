// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/devices/device_link.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "base/threads/thread_priority.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kHung = 2.0;  // time-outs after which a call that has not come back counts as a lost link

std::chrono::duration<double> seconds(double time_s) { return std::chrono::duration<double>(time_s); }

}  // namespace

DeviceLink::DeviceLink(std::unique_ptr<ProcessDevice> device, const DeviceSettings& settings,
                       const Clock& clock, std::vector<double> safe)
    : device_(std::move(device)),
      settings_(settings),
      clock_(clock),
      safe_(std::move(safe)),
      retry_at_s_(-std::numeric_limits<double>::infinity()) {
  report_.reason = "not connected yet";
  thread_ = std::thread([this] { run(); });
}

DeviceLink::~DeviceLink() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool DeviceLink::end() {
  std::unique_lock<std::mutex> lock(mutex_);
  is_ending_ = true;
  changed_.notify_all();
  while (!has_ended_ && !isHung()) changed_.wait_for(lock, seconds(settings_.timeout_s));
  return has_ended_;
}

void DeviceLink::send(std::vector<double> raw, double due_s) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    // What it takes the place of was due before it.
    waiting_ = Waiting{std::move(raw), waiting_ ? waiting_->due_s : due_s};
  }
  changed_.notify_all();
}

DeviceReport DeviceLink::report() {
  const std::lock_guard<std::mutex> lock(mutex_);
  DeviceReport report = report_;
  report_.late_s = 0.0;
  report_.note.clear();
  if (isHung()) {
    report.is_hung = true;
    report.is_connected = false;
    report.reason = "no answer for " + numberText(clock_.now() - *busy_since_s_) + " s";
  }
  return report;
}

bool DeviceLink::isHung() const {
  return busy_since_s_ && clock_.now() - *busy_since_s_ > kHung * settings_.timeout_s;
}

DeviceFigures DeviceLink::figures() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return figures_;
}

void DeviceLink::run() {
  preferThisThread();
  std::unique_lock<std::mutex> lock(mutex_);
  while (!is_ending_) {
    const bool is_connected = report_.is_connected;
    if (!waitForWork(lock)) continue;
    const std::optional<Waiting> values = std::exchange(waiting_, std::nullopt);
    lock.unlock();
    if (!is_connected)
      tryToOpen();
    else if (values)
      exchange(*values);
    lock.lock();
  }
  const bool is_connected = report_.is_connected;
  lock.unlock();
  if (is_connected) exchange({safe_, clock_.now()});
  device_->close();
  lock.lock();
  has_ended_ = true;
  changed_.notify_all();
}

/// Until there are values, or it is time to open the device. False if it is neither.
bool DeviceLink::waitForWork(std::unique_lock<std::mutex>& lock) {
  if (report_.is_connected) {
    changed_.wait(lock, [this] { return is_ending_ || waiting_; });
    return !is_ending_;
  }
  const double wait_s = retry_at_s_ - clock_.now();
  if (wait_s <= 0.0) return true;
  changed_.wait_for(lock, seconds(wait_s), [this] { return is_ending_; });
  return false;
}

void DeviceLink::beginCall() {
  const std::lock_guard<std::mutex> lock(mutex_);
  busy_since_s_ = clock_.now();
}

void DeviceLink::tryToOpen() {
  try {
    beginCall();
    std::string note = device_->open();
    beginCall();
    device_->exchange(safe_);
    const std::lock_guard<std::mutex> lock(mutex_);
    busy_since_s_.reset();
    report_.is_connected = true;
    report_.reason.clear();
    report_.note = std::move(note);
    waiting_.reset();
  } catch (const Error& error) {
    lose(error.what());
  }
}

void DeviceLink::exchange(const Waiting& values) {
  const double begin_s = clock_.now();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    busy_since_s_ = begin_s;
    figures_.late.add(begin_s - values.due_s);
    report_.late_s = std::max(report_.late_s, begin_s - values.due_s);
  }
  try {
    std::vector<double> inputs = device_->exchange(values.raw);
    const std::lock_guard<std::mutex> lock(mutex_);
    busy_since_s_.reset();
    figures_.round_trip.add(clock_.now() - begin_s);
    report_.inputs = std::move(inputs);
  } catch (const Error& error) {
    lose(error.what());
  }
}

/// Reported first: to close a device may take long.
void DeviceLink::lose(const std::string& why) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    busy_since_s_.reset();
    report_.is_connected = false;
    report_.reason = why;
    report_.inputs.clear();
    waiting_.reset();
  }
  device_->close();
  const std::lock_guard<std::mutex> lock(mutex_);
  retry_at_s_ = clock_.now() + settings_.retry_s;
}

}  // namespace lamina
