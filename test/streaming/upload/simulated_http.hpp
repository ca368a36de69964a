// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/random.hpp"
#include "streaming/emulator/print_server/emulated_print_server.hpp"
#include "streaming/upload/upload_job.hpp"

namespace lamina::test {

/// The body of a request, whole.
inline std::string bodyOf(const HttpRequest& request, const ProgramBody& program) {
  std::string body = request.head;
  if (request.sends_program) {
    std::array<char, 4096> buffer{};
    ProgramBody::Reader reader = program.open();
    while (const std::size_t count = reader.read(buffer.data(), buffer.size()))
      body.append(buffer.data(), count);
  }
  return body + request.tail;
}

/// How often each thing goes wrong with a request, from 0 to 1.
struct HttpFaults {
  double server_error = 0.0;   ///< 500 instead of an answer
  double lost_request = 0.0;   ///< the connection breaks before the server has the request
  double lost_response = 0.0;  ///< it breaks after the server has done what was asked
  double late = 0.0;           ///< no answer, and the server does it `late_s` after it was asked
  double late_s = 12.0;
  double damaged = 0.0;  ///< a byte of an upload is changed on the way
  double slow = 0.0;     ///< 4 s until the answer
};

/// What has these words is answered so, and not done, for a while.
struct TurnedAway {
  const char* words = "";
  HttpResponse answer;
  double until_s = std::numeric_limits<double>::infinity();
};

/// What happens at the machine, and when [s].
struct MachineEvent {
  double at_s = 0.0;
  std::function<void(EmulatedPrintServer&)> happens;
};

/// An upload job and an emulated print server in simulated time.
class SimulatedHttp {
 public:
  SimulatedHttp(std::shared_ptr<const UploadOrder> order, const StreamSettings& settings,
                std::unique_ptr<EmulatedPrintServer> print_server, std::uint64_t seed = 1)
      : job(settings, order), server(std::move(print_server)), order_(std::move(order)), random_(seed) {}

  void start() {
    job.start(now);
    collect();
  }
  void runUntil(double end_s) {
    while (now < end_s && !isFinal(job.status().state)) step(end_s);
  }
  /// What the machine does when the job is over, too.
  void runOn(double end_s) {
    while (now < end_s) step(end_s);
  }
  void run(double most_s = 1e5) {
    start();
    runUntil(most_s);
  }
  void runUntilState(PackmlState state) {
    while (job.status().state != state && !isFinal(job.status().state) && now < 1e5) step(1e5);
  }

  UploadJob job;
  std::unique_ptr<EmulatedPrintServer> server;
  HttpFaults faults;
  std::vector<MachineEvent> events;  ///< in order of time
  double unreachable_from_s = std::numeric_limits<double>::infinity();
  double unreachable_until_s = std::numeric_limits<double>::infinity();
  std::vector<const char*> late_words;  ///< what has one of them is as late as `faults` tells
  std::optional<TurnedAway> turned_away;
  std::vector<std::string> targets;  ///< of all requests
  std::vector<PackmlState> states;
  double now = 0.0;

 private:
  struct Outcome {
    double at_s = 0.0;
    std::optional<HttpResponse> response;
    HttpFailure failure;
  };
  struct LateRequest {
    double at_s = 0.0;
    HttpRequest request;
  };

  void step(double end_s) {
    double next = std::min(job.nextDeadline(), end_s);
    if (outcome_) next = std::min(next, outcome_->at_s);
    if (!events.empty()) next = std::min(next, events.front().at_s);
    if (!late_.empty()) next = std::min(next, late_.front().at_s);
    now = std::max(now, next);
    server->printer.elapse(now);
    while (!events.empty() && events.front().at_s <= now) {
      events.front().happens(*server);
      events.erase(events.begin());
    }
    while (!late_.empty() && late_.front().at_s <= now) {
      server->answer(late_.front().request, bodyOf(late_.front().request, order_->body));
      late_.erase(late_.begin());
    }
    if (outcome_ && outcome_->at_s <= now) {
      const Outcome outcome = *std::exchange(outcome_, std::nullopt);
      outcome.response ? job.receive(*outcome.response, now) : job.fail(outcome.failure, now);
    } else {
      job.elapse(now);
    }
    collect();
  }

  void collect() {
    if (job.takeBreak()) outcome_.reset();
    if (const auto request = job.takeRequest(now)) issue(*request);
    if (job.takeBreak()) outcome_.reset();
    for (const PackmlState state : job.takeStateChanges()) states.push_back(state);
  }

  static bool has(const HttpRequest& request, const char* words) {
    return (request.target + request.head).find(words) != std::string::npos;
  }
  bool isLate(const HttpRequest& request) {
    for (const char* words : late_words)
      if (has(request, words)) return true;
    return strikes(faults.late);
  }
  bool strikes(double rate) { return rate > 0.0 && random_.uniform(0.0, 1.0) < rate; }

  void issue(const HttpRequest& request) {
    constexpr double kLatency = 0.01;
    targets.push_back(request.target);
    if (now >= unreachable_from_s && now < unreachable_until_s) {
      outcome_ = Outcome{now + kLatency, {}, {"connection refused", false}};
    } else if (turned_away && now < turned_away->until_s && has(request, turned_away->words)) {
      outcome_ = Outcome{now + kLatency, turned_away->answer, {}};
    } else if (strikes(faults.server_error)) {
      outcome_ = Outcome{now + kLatency, HttpResponse{500, "Internal Server Error"}, {}};
    } else if (strikes(faults.lost_request)) {
      if (request.sends_program) job.sent(order_->body.bytes() / 2);
      outcome_ = Outcome{now + kLatency, {}, {"connection reset by peer", true}};
    } else if (isLate(request)) {
      late_.push_back({now + faults.late_s, request});
      outcome_ = Outcome{now + request.timeout_s, {}, {"no answer within 10 s", true}};
    } else {
      deliver(request, kLatency);
    }
  }

  void deliver(const HttpRequest& request, double latency_s) {
    std::string body = bodyOf(request, order_->body);
    if (request.sends_program && strikes(faults.damaged)) body[request.head.size() + 3] ^= 1;
    HttpResponse response = server->answer(request, body);
    if (request.digests_answer) {
      boost::crc_32_type crc;
      crc.process_bytes(response.body.data(), response.body.size());
      response.digested_bytes = response.body.size();
      response.digested_crc32 = crc.checksum();
      response.body.clear();
    }
    if (request.sends_program) job.sent(order_->body.bytes());
    outcome_ = Outcome{now + (strikes(faults.slow) ? 4.0 : latency_s), response, {}};
    if (strikes(faults.lost_response)) {
      outcome_->response.reset();
      outcome_->failure = {"connection reset by peer", true};
    }
  }

  std::shared_ptr<const UploadOrder> order_;
  Random random_;
  std::optional<Outcome> outcome_;
  std::vector<LateRequest> late_;
};

}  // namespace lamina::test
