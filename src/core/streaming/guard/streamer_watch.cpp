// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/guard/streamer_watch.hpp"

#include <csignal>
#include <utility>

#include "base/threads/thread_priority.hpp"

namespace lamina {
namespace {

constexpr double kDying = 1.0;  // s, of a process that was killed
constexpr double kLook = 0.01;  // s

}  // namespace

StreamerWatch::StreamerWatch(const std::string& socket, GuardSettings settings, WatchObserver observer,
                             MachineStopper stop)
    : listener_(socket),
      guard_(settings),
      observer_(std::move(observer)),
      stop_(std::move(stop)),
      thread_([this] { run(); }) {}

StreamerWatch::~StreamerWatch() {
  is_ending_ = true;
  listener_.wake();
  thread_.join();
}

void StreamerWatch::run() {
  preferThisThread();
  while (!is_ending_) {
    hear(guard_.nextDeadline() - clock_.now());
    const auto order = guard_.due(clock_.now());
    tell();
    if (order) stop(*order);
  }
  // Nobody else knows of it.
  if (const auto order = guard_.dueAtEnd()) stop(*order);
}

void StreamerWatch::stop(const GuardOrder& order) {
  if (order.hung_process > 0) endHung(order.hung_process);
  MachineStopReport report = stop_(order.machine, observer_.begun);
  report.message = order.machine.port.name + ": " + report.message;
  guard_.onStop(report, clock_.now());
  tell();
}

void StreamerWatch::hear(double timeout_s) {
  for (const HeardPulse& heard : listener_.wait(timeout_s)) {
    if (heard.pulse && observer_.heard) observer_.heard(*heard.pulse);
    if (heard.pulse)
      guard_.hear(*heard.pulse, heard.process, clock_.now());
    else
      guard_.end(heard.process, clock_.now());
  }
}

void StreamerWatch::tell() {
  for (const GuardNews& news : guard_.takeNews()) observer_.news(news);
}

/// Its connection lasts, so that the number is still its own.
void StreamerWatch::endHung(int process) {
  ::kill(process, SIGKILL);
  const double until_s = clock_.now() + kDying;
  while (clock_.now() < until_s && ::kill(process, 0) == 0) hear(kLook);
}

}  // namespace lamina
