// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/client/streamer.hpp"

#include <utility>

#include "streaming/client/streamer_machine.hpp"

namespace lamina {

Streamer::Streamer(const StreamableProgram& program, const StreamSettings& settings, ReplyListener heard)
    : machine_(std::make_unique<Machine>(program, settings, std::move(heard))) {}
Streamer::~Streamer() = default;

void Streamer::start(double now) { machine_->start(now); }
void Streamer::receive(std::string_view bytes, double now) { machine_->receive(bytes, now); }
void Streamer::elapse(double now) { machine_->elapse(now); }
void Streamer::disconnect(const std::string& why, double now) { machine_->disconnect(why, now); }
void Streamer::reconnect(double now) { machine_->reconnect(now); }
bool Streamer::isOffline() const { return machine_->isOffline(); }
bool Streamer::pause(double now) { return machine_->pause(now); }
bool Streamer::resume(double now) { return machine_->resume(now); }
void Streamer::abort(const Failure& why, double now) { machine_->abort(why, now); }
std::string Streamer::takeOutput() { return machine_->takeOutput(); }
double Streamer::nextDeadline() const { return machine_->nextDeadline(); }
const StreamStatus& Streamer::status() const { return machine_->status(); }
std::vector<PackmlState> Streamer::takeStateChanges() { return machine_->takeStateChanges(); }

}  // namespace lamina
