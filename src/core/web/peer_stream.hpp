// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <openssl/ssl.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "lamina/base/clock.hpp"

namespace lamina {

struct FreeTlsContext {
  void operator()(SSL_CTX* context) const { SSL_CTX_free(context); }
};
using TlsContext = std::unique_ptr<SSL_CTX, FreeTlsContext>;

/// A context for TLS 1.2 and later.
/// @throws FileError if certificate or key cannot be used
TlsContext tlsContext(const std::string& certificate, const std::string& key);

/// Outcome of reading or writing.
enum class PeerResult : std::uint8_t { Done, Closed, Late };

/// One end of a connection, plain or encrypted, with a time limit for every operation.
class PeerSocket {
 public:
  /// Takes ownership of the descriptor, and makes it non-blocking.
  /// @param context  of TLS; null for a plain connection. Where OpenSSL gives no connection, `shakeHands`
  /// answers
  ///   Closed.
  PeerSocket(int descriptor, SSL_CTX* context);
  ~PeerSocket();
  PeerSocket(const PeerSocket&) = delete;
  PeerSocket& operator=(const PeerSocket&) = delete;

  /// Sets the time, from now, at which reading and writing give up.
  void allow(double seconds);

  PeerResult shakeHands();
  struct Transfer {
    PeerResult result = PeerResult::Done;
    std::size_t bytes = 0;
  };
  Transfer read(void* buffer, std::size_t size);
  Transfer write(const void* bytes, std::size_t size);

  /// Waits until there are bytes to read.
  /// @return false if there are none within that time
  bool waitForBytes(double seconds);
  /// The same, and no longer than until another descriptor is readable.
  bool waitForBytesBeside(int descriptor, double seconds);

  /// Number of bytes written that the other host has not received yet.
  std::size_t unsent() const;

  /// Ends the connection in the direction of the client. Bytes that the client still sends are read: unread
  /// bytes would make the client lose the answer.
  void close();

  int descriptor() const { return descriptor_; }

 private:
  struct FreeSsl {
    void operator()(SSL* ssl) const { SSL_free(ssl); }
  };
  bool wait(short events, double seconds) const;
  PeerResult await(int ssl_result);
  double left() const;

  SteadyClock clock_;
  int descriptor_;
  bool is_plain_;
  double until_s_ = 0.0;
  std::unique_ptr<SSL, FreeSsl> ssl_;
};

}  // namespace lamina
