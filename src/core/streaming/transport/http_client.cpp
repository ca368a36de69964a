// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/transport/http_client.hpp"

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/crc.hpp>
#include <boost/optional.hpp>
#include <chrono>
#include <optional>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {

namespace beast = boost::beast;
namespace http = boost::beast::http;

/// One request and its response. Held by shared pointer, since operations under way keep it alive.
class HttpExchange : public std::enable_shared_from_this<HttpExchange> {
 public:
  HttpExchange(boost::asio::io_context& context, HttpRequest request, const ProgramBody& program,
               HttpEvents events)
      : stream_(context), request_(std::move(request)), program_(program), events_(std::move(events)) {
    if (request_.sends_program) reader_.emplace(program.open());
  }

  void begin(const boost::asio::ip::tcp::resolver::results_type& endpoints, const HttpAddress& address);
  void breakOff() {
    is_over_ = true;
    stream_.close();
  }

 private:
  using Error = boost::system::error_code;

  void compose(const HttpAddress& address);
  void writeBody();
  std::size_t nextPiece();
  void readHeader();
  void readBody();
  bool take(std::size_t count);
  void finish();
  void fail(const Error& error);
  void fail(const std::string& why);
  void awaitBytes() {
    stream_.expires_after(std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * request_.timeout_s)));
  }
  template <class Handler>
  auto then(Handler handler) {
    return [self = shared_from_this(), handler](const Error& error, auto&&...) {
      if (!self->is_over_) handler(error);
    };
  }

  beast::tcp_stream stream_;
  HttpRequest request_;
  const ProgramBody& program_;
  HttpEvents events_;
  std::optional<ProgramBody::Reader> reader_;
  http::request<http::buffer_body> message_;
  http::request_serializer<http::buffer_body> serializer_{message_};
  http::response_parser<http::buffer_body> parser_;
  beast::flat_buffer received_;
  std::array<char, 65536> piece_{};
  HttpResponse response_;
  boost::crc_32_type crc_;
  std::uint64_t program_sent_ = 0;
  std::uint64_t body_left_ = 0;
  std::size_t head_sent_ = 0;
  std::size_t tail_sent_ = 0;
  std::optional<Error> write_error_;
  bool is_connected_ = false;
  bool is_over_ = false;
};

void HttpExchange::compose(const HttpAddress& address) {
  message_.method_string(request_.method);
  message_.target(request_.target);
  message_.version(11);
  const bool is_ip6 = address.host.find(':') != std::string::npos;
  const std::string host = is_ip6 ? "[" + address.host + "]" : address.host;
  message_.set(http::field::host, address.port == "80" ? host : host + ":" + address.port);
  message_.set(http::field::connection, "close");
  message_.set(http::field::user_agent, "lamina");
  for (const auto& [name, value] : request_.headers) message_.set(name, value);
  body_left_ = request_.head.size() + request_.tail.size() + (request_.sends_program ? program_.bytes() : 0);
  if (request_.method != "GET") message_.content_length(body_left_);
  message_.body().data = nullptr;
  message_.body().more = true;
}

void HttpExchange::begin(const boost::asio::ip::tcp::resolver::results_type& endpoints,
                         const HttpAddress& address) {
  constexpr std::uint32_t kLongestHeader = 32 * 1024;
  constexpr std::uint64_t kLongestBody = std::uint64_t{4} << 20U;
  compose(address);
  parser_.header_limit(kLongestHeader);
  parser_.body_limit(request_.digests_answer ? program_.bytes() + kLongestBody : kLongestBody);
  awaitBytes();
  stream_.async_connect(endpoints, then([this](const Error& error) {
                          if (error) return fail(error);
                          is_connected_ = true;
                          awaitBytes();
                          http::async_write_header(stream_, serializer_, then([this](const Error& failed) {
                                                     if (failed) return fail(failed);
                                                     writeBody();
                                                   }));
                        }));
}

/// Fills the piece with what follows of the body; 0 if a part of the program is missing.
std::size_t HttpExchange::nextPiece() {
  const auto from = [&](const std::string& text, std::size_t& sent) {
    const std::size_t count = std::min(text.size() - sent, piece_.size());
    std::copy_n(text.begin() + static_cast<std::ptrdiff_t>(sent), count, piece_.begin());
    sent += count;
    return count;
  };
  if (head_sent_ < request_.head.size()) return from(request_.head, head_sent_);
  if (request_.sends_program && program_sent_ < program_.bytes()) {
    const std::uint64_t left = program_.bytes() - program_sent_;
    const std::size_t count = reader_->read(piece_.data(), std::min<std::uint64_t>(left, piece_.size()));
    program_sent_ += count;
    return count;
  }
  return from(request_.tail, tail_sent_);
}

void HttpExchange::writeBody() {
  if (body_left_ == 0) return readHeader();
  const std::size_t count = nextPiece();
  if (count == 0) return fail(std::string("the program has become shorter than it was when it was checked"));
  body_left_ -= count;
  message_.body().data = piece_.data();
  message_.body().size = count;
  message_.body().more = body_left_ > 0;
  awaitBytes();
  http::async_write(stream_, serializer_, then([this](const Error& error) {
                      if (error && error != http::error::need_buffer) {
                        // A server that refuses an upload may have said why before it closed.
                        write_error_ = error;
                        return readHeader();
                      }
                      if (program_sent_ > 0) events_.sent(program_sent_);
                      if (!is_over_) writeBody();
                    }));
}

void HttpExchange::readHeader() {
  awaitBytes();
  http::async_read_header(stream_, received_, parser_, then([this](const Error& error) {
                            if (error) return fail(write_error_.value_or(error));
                            response_.status = static_cast<int>(parser_.get().result_int());
                            readBody();
                          }));
}

void HttpExchange::readBody() {
  if (parser_.is_done()) return finish();
  parser_.get().body().data = piece_.data();
  parser_.get().body().size = piece_.size();
  awaitBytes();
  http::async_read(stream_, received_, parser_, then([this](const Error& error) {
                     if (error && error != http::error::need_buffer) return fail(error);
                     const std::size_t count = piece_.size() - parser_.get().body().size;
                     if (request_.digests_answer) {
                       crc_.process_bytes(piece_.data(), count);
                       response_.digested_bytes += count;
                     } else {
                       response_.body.append(piece_.data(), count);
                     }
                     readBody();
                   }));
}

void HttpExchange::finish() {
  response_.digested_crc32 = crc_.checksum();
  breakOff();
  events_.responded(response_);
}

void HttpExchange::fail(const Error& error) {
  if (error == beast::error::timeout)
    return fail("no answer within " + std::to_string(static_cast<int>(request_.timeout_s)) + " s");
  fail(error.message());
}

void HttpExchange::fail(const std::string& why) {
  breakOff();
  events_.failed({why, is_connected_});
}

HttpClient::HttpClient(boost::asio::io_context& context, HttpAddress address, HttpEvents events)
    : context_(context), address_(std::move(address)), events_(std::move(events)) {}
HttpClient::~HttpClient() { breakOff(); }

void HttpClient::open() {
  constexpr std::chrono::seconds kConnectTimeout{5};
  boost::system::error_code error;
  endpoints_ = boost::asio::ip::tcp::resolver(context_).resolve(address_.host, address_.port, error);
  if (!error) {
    beast::tcp_stream stream(context_);
    stream.expires_after(kConnectTimeout);
    stream.async_connect(endpoints_,
                         [&](const boost::system::error_code& result, const auto&) { error = result; });
    context_.restart();
    context_.run();
    context_.restart();
  }
  if (!error) return;
  throw Disconnected("cannot connect to " + address_.host + " port " + address_.port + ": " +
                     error.message() + "; is the machine on?");
}

void HttpClient::ask(const HttpRequest& request, const ProgramBody& program) {
  breakOff();
  try {
    exchange_ = std::make_shared<HttpExchange>(context_, request, program, events_);
  } catch (const Error& error) {
    boost::asio::post(context_, [failed = events_.failed, why = std::string(error.what())] {
      failed({why, false});
    });
    return;
  }
  exchange_->begin(endpoints_, address_);
}

void HttpClient::breakOff() {
  if (exchange_) exchange_->breakOff();
  exchange_.reset();
}

bool isWebAddress(const std::string& port) {
  return port.compare(0, 7, "http://") == 0 || port.compare(0, 8, "https://") == 0;
}

HttpAddress httpAddressOf(const std::string& port) {
  constexpr std::string_view kScheme = "http://";
  const auto fail = [&](const std::string& why) {
    throw InvalidInput("port is \"" + port + "\"" + why + "; expected http://host or http://host:port");
  };
  if (port.compare(0, kScheme.size(), kScheme) != 0) fail(", but encryption is not spoken");
  std::string rest = port.substr(kScheme.size());
  if (!rest.empty() && rest.back() == '/') rest.pop_back();
  if (rest.find_first_of("/?#") != std::string::npos) fail(", which has a path");
  if (rest.find('@') != std::string::npos)
    throw InvalidInput(
        "the port has a user's name; expected http://host, and a password in stream.password_file");
  const std::size_t bracket = rest.find(']');
  const std::size_t colon = rest.find(':', bracket == std::string::npos ? 0 : bracket);
  HttpAddress address{rest.substr(0, colon)};
  if (colon != std::string::npos) address.port = rest.substr(colon + 1);
  if (bracket != std::string::npos && address.host.front() == '[')
    address.host = address.host.substr(1, bracket - 1);
  const bool is_number = address.port.find_first_not_of("0123456789") == std::string::npos;
  if (address.host.empty() || address.port.empty() || !is_number) fail("");
  return address;
}

}  // namespace lamina
