// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace lamina {

/// What a connection is used for at present.
enum class ConnectionUse : std::uint8_t {
  Waiting,  ///< for a request
  Answering,
  Upload,
  Stream  ///< WebSocket or pictures
};

/// How fast a client reads what is sent to it.
enum class ConnectionPace : std::uint8_t { Usual, Slow };

/// The open connections: their number, their clients, and which one is closed in favour of a new one. May be
/// called from several threads.
class ConnectionTable {
 public:
  ConnectionTable(std::size_t most, std::size_t most_of_client)
      : most_(most), most_of_client_(most_of_client) {}

  /// Adds a connection. If there are too many, another one is shut down in its favour: a connection that
  /// waits for a request, or whose client reads its answer slowly.
  /// @return number of the connection; 0 if it could not be added
  std::uint64_t add(int descriptor, const std::string& client);

  /// Sets the use of a connection.
  /// @return false, without effect, if there are too many with that use
  bool use(std::uint64_t number, ConnectionUse use);

  /// Sets how fast the connection's client reads.
  void setPace(std::uint64_t number, ConnectionPace pace);

  /// Removes a connection; afterwards its descriptor may be closed.
  void remove(std::uint64_t number);

  /// Shuts down all connections, so that their threads end.
  void shutDownAll();

  std::size_t size() const;

  /// Whether so many connections that were shut down have not ended yet that no further one can be added.
  bool isCrowded() const { return size() >= 2 * most_; }

 private:
  struct Row {
    int descriptor = -1;
    std::string client;
    ConnectionUse use = ConnectionUse::Waiting;
    std::uint64_t since = 0;  ///< order in which uses began
    bool is_shut = false;     ///< whether it was shut down and so is not counted any more
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
