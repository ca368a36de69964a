// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "lamina/base/log.hpp"
#include "lamina/web/operator_site.hpp"
#include "lamina/web/tls_identity.hpp"

namespace lamina {

/// How long clients may take. [s]
struct WebPatience {
  double header_s = 10.0;    ///< for the handshake, and for a head from its first byte
  double body_s = 10.0;      ///< for a small body
  double idle_s = 30.0;      ///< between two requests of a connection
  double progress_s = 30.0;  ///< in which an upload brings 64 KiB more, or its end
  /// In which a client takes an answer, a message or a picture, besides a second for so many bytes of it.
  double write_s = 10.0;
  double least_bytes_per_s = 16384.0;  ///< [B/s]
  double slow_s = 2.0;                 ///< after which a client that has not taken all gives way to another
  double ping_s = 10.0;  ///< between pings of a WebSocket, which closes after three without a word
};

struct WebServerSettings {
  std::string bind = "127.0.0.1";
  std::uint16_t port = 8080;    ///< 0 for any that is free
  std::optional<TlsFiles> tls;  ///< nothing: plain HTTP
  bool allows_plain = false;    ///< listens beyond the loopback interface without TLS, too
  std::size_t connections = 32;
  std::size_t connections_of_client = 8;
  std::size_t most_behind = std::size_t{1} << 20;  ///< bytes that a WebSocket's client has yet to take
  WebPatience patience;
};

/// Listens for browsers and slicers. Each connection has a thread of its own, so that none waits for another;
/// when there are too many, the one that has waited longest for its request gives way, then a slow reader.
/// WebSockets, pictures and uploads take three quarters of the places at most: one more request always finds
/// one.
class WebServer {
 public:
  /// `site` outlives it.
  /// @throws InvalidConfig if it would listen beyond the loopback interface without TLS, and is not allowed
  /// to
  /// @throws FileError for TLS files that cannot be used
  /// @throws DeviceError if it cannot listen there, with address and reason
  WebServer(WebServerSettings settings, OperatorSite& site, LogSink log);
  /// Closes all connections.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  std::uint16_t port() const;
  /// "http://127.0.0.1:8080/"
  std::string address() const;

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace lamina
