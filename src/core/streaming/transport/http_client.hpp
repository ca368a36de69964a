// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "streaming/upload/http_exchange.hpp"
#include "streaming/upload/program_body.hpp"

namespace lamina {

/// The address of a print server.
struct HttpAddress {
  std::string host;
  std::string port = "80";
};

/// Whether a port is a web address of any scheme: "http://host".
bool isWebAddress(const std::string& port);

/// Parses "http://host", "http://host:port" or "http://[address]:port".
/// @throws InvalidInput if the text is no such address, has a path, or begins with https://, which is not
///   supported
HttpAddress httpAddressOf(const std::string& port);

/// Callbacks of a request, from the thread that runs the io_context.
struct HttpEvents {
  /// Called with the number of bytes of the program sent so far.
  std::function<void(std::uint64_t bytes)> sent;
  std::function<void(const HttpResponse&)> responded;
  std::function<void(const HttpFailure&)> failed;
};

/// Sends one request at a time, each over a connection of its own. A response may have at most 4 MiB, unless
/// only its digest is kept (`HttpRequest::digests_answer`). Redirects are not followed.
class HttpClient {
 public:
  HttpClient(boost::asio::io_context& context, HttpAddress address, HttpEvents events);
  ~HttpClient();
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  /// Looks up the host and tries a connection. To be called before the io_context runs.
  /// @throws Disconnected if no server listens there
  void open();
  /// Sends a request; the previous request must be over or broken off.
  void ask(const HttpRequest& request, const ProgramBody& program);
  /// Closes the connection of the current request without a callback.
  void breakOff();

 private:
  boost::asio::io_context& context_;
  HttpAddress address_;
  HttpEvents events_;
  boost::asio::ip::tcp::resolver::results_type endpoints_;
  std::shared_ptr<class HttpExchange> exchange_;
};

}  // namespace lamina
