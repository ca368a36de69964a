// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace lamina {

/// What a connection is at.
enum class ConnectionUse : std::uint8_t {
  Waiting,  ///< for a request
  Answering,
  Upload,
  Stream  ///< WebSocket or pictures
};

/// How fast a client takes what is sent to it.
enum class ConnectionPace : std::uint8_t { Usual, Slow };

/// The connections that are open: how many, whose, and which gives way to another. Several threads call at a
/// time.
class ConnectionTable {
 public:
  ConnectionTable(std::size_t most, std::size_t most_of_client)
      : most_(most), most_of_client_(most_of_client) {}

  /// Adds a connection. Where there are too many, one that waits for a request is shut down for it,
  /// or one whose client takes its answer slowly.
  /// @return its number; 0 if there is no place
  std::uint64_t add(int descriptor, const std::string& client);

  /// Notes what it is at from now on.
  /// @return false if there are too many of that use; then nothing has changed
  bool use(std::uint64_t number, ConnectionUse use);

  /// Notes how fast its client takes what is sent to it.
  void setPace(std::uint64_t number, ConnectionPace pace);

  /// Forgets a connection; its descriptor may be closed afterwards.
  void remove(std::uint64_t number);

  /// Shuts all down, so that their threads end.
  void shutDownAll();

  std::size_t size() const;

  /// So many connections that gave way have not ended yet that no other finds a place.
  bool isCrowded() const { return size() >= 2 * most_; }

 private:
  struct Row {
    int descriptor = -1;
    std::string client;
    ConnectionUse use = ConnectionUse::Waiting;
    std::uint64_t since = 0;  ///< order in which uses began
    bool is_shut = false;     ///< and counts no more
    ConnectionPace pace = ConnectionPace::Usual;
  };
  bool isFull(const std::string& client) const;
  bool makeRoom(const std::string& client);
  static bool giveWay(Row* row);

  std::size_t most_;
  std::size_t most_of_client_;
  mutable std::mutex mutex_;
  std::map<std::uint64_t, Row> rows_;
  std::uint64_t last_ = 0;
  std::uint64_t uses_ = 0;
};

}  // namespace lamina
