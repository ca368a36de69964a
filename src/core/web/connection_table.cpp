// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "web/connection_table.hpp"

#include <sys/socket.h>

#include <algorithm>

namespace lamina {

std::uint64_t ConnectionTable::add(int descriptor, const std::string& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // Threads of connections that gave way need a moment to end: they are bounded, too.
  if (rows_.size() >= 2 * most_ || !makeRoom(client)) return 0;
  rows_[++last_] = {descriptor, client, ConnectionUse::Waiting, ++uses_, false, ConnectionPace::Usual};
  return last_;
}

bool ConnectionTable::isFull(const std::string& client) const {
  std::size_t all = 0;
  std::size_t own = 0;
  for (const auto& [number, row] : rows_) {
    if (row.is_shut) continue;
    ++all;
    if (row.client == client) ++own;
  }
  return all >= most_ || own >= most_of_client_;
}

bool ConnectionTable::makeRoom(const std::string& client) {
  if (!isFull(client)) return true;
  const auto count = static_cast<std::size_t>(std::count_if(rows_.begin(), rows_.end(), [&](const auto& row) {
    return !row.second.is_shut && row.second.client == client;
  }));
  const bool is_own_fault = count >= most_of_client_;
  Row* waiting = nullptr;
  Row* slow = nullptr;
  for (auto& [number, row] : rows_) {
    if (row.is_shut || (is_own_fault && row.client != client)) continue;
    const bool is_waiting = row.use == ConnectionUse::Waiting;
    if (!is_waiting && row.pace != ConnectionPace::Slow) continue;
    Row*& oldest = is_waiting ? waiting : slow;
    if (oldest == nullptr || row.since < oldest->since) oldest = &row;
  }
  return giveWay(waiting != nullptr ? waiting : slow);
}

bool ConnectionTable::giveWay(Row* row) {
  if (row == nullptr) return false;
  ::shutdown(row->descriptor, SHUT_RDWR);
  row->is_shut = true;
  return true;
}

bool ConnectionTable::use(std::uint64_t number, ConnectionUse use) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = rows_.find(number);
  if (found == rows_.end()) return false;
  if (use == ConnectionUse::Upload || use == ConnectionUse::Stream) {
    std::size_t all = 0;
    std::size_t own = 0;
    for (const auto& [other, row] : rows_) {
      if (row.is_shut || (row.use != ConnectionUse::Upload && row.use != ConnectionUse::Stream)) continue;
      ++all;
      if (row.client == found->second.client) ++own;
    }
    if (all >= most_ * 3 / 4 || own >= most_of_client_ * 3 / 4) return false;
  }
  found->second.use = use;
  found->second.since = ++uses_;
  return true;
}

void ConnectionTable::setPace(std::uint64_t number, ConnectionPace pace) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = rows_.find(number);
  if (found != rows_.end()) found->second.pace = pace;
}

void ConnectionTable::remove(std::uint64_t number) {
  const std::lock_guard<std::mutex> lock(mutex_);
  rows_.erase(number);
}

void ConnectionTable::shutDownAll() {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto& [number, row] : rows_) ::shutdown(row.descriptor, SHUT_RDWR);
}

std::size_t ConnectionTable::size() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return rows_.size();
}

}  // namespace lamina
