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
struct WebTimeouts {
  double header_s = 10.0;    ///< for the TLS handshake, and for the head of a request from its first byte on
  double body_s = 10.0;      ///< for the body of a request that is no upload, at most 64 KiB
  double idle_s = 30.0;      ///< in which the next request of an open connection begins, the first one too
  double progress_s = 30.0;  ///< in which each further 64 KiB of an upload arrive, or the last bytes of it
  /// In which a client takes an answer, a message or a picture, besides the time for its bytes at
  /// `least_bytes_per_s`.
  double write_s = 10.0;
  double least_bytes_per_s = 16384.0;  ///< [B/s]
  /// A client that takes longer over an answer is slow: its connection may be closed in favour of a new one.
  double slow_s = 2.0;
  /// Between pings to a WebSocket. It is closed if nothing comes from it for three times as long.
  double ping_s = 10.0;
};

struct WebServerSettings {
  std::string bind = "127.0.0.1";
  std::uint16_t port = 8080;              ///< 0 for any that is free
  std::optional<TlsFiles> tls;            ///< nothing: plain HTTP
  bool allows_plain = false;              ///< permits listening beyond the loopback interface without TLS
  std::size_t connections = 32;           ///< most at a time
  std::size_t connections_of_client = 8;  ///< most at a time from one address
  /// A WebSocket whose client has yet to take more bytes than this is closed.
  std::size_t most_unsent_bytes = std::size_t{1} << 20;
  WebTimeouts patience;
};

/// Listens for browsers and slicers. Each connection has a thread of its own, so that none waits for another.
/// If a new connection exceeds a limit, the connection that has waited longest for a request is closed; if
/// none waits, one whose client takes its answer slowly; if there is neither, the new one. If the limit is
/// that of one client, only connections of that client are closed. WebSockets, pictures and uploads take at
/// most three quarters of all connections, so that some remain for short requests.
class WebServer {
 public:
  /// `site` outlives it.
  /// @throws InvalidConfig if it is to listen beyond the loopback interface without TLS, and this is not
  ///   allowed
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
