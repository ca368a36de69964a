// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/web_server.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <chrono>
#include <csignal>
#include <limits>
#include <list>
#include <system_error>
#include <thread>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/loopback.hpp"
#include "lamina/base/text.hpp"
#include "lamina/web/upload_file.hpp"
#include "lamina/web/web_socket.hpp"
#include "web/connection_table.hpp"
#include "web/peer_stream.hpp"
#include "web/response_text.hpp"

namespace lamina {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::uint32_t kMostHeader = 16384;  // bytes
constexpr std::size_t kMostBuffered = 65536;  // bytes
constexpr std::size_t kUploadStep = 65536;    // bytes that count as progress
constexpr double kLiveInterval = 0.5;         // [s] between looks whether a stream without news is to end
constexpr double kFrameInterval = 0.2;        // [s] between pictures of the camera
constexpr double kLeavingChecked = 5.0;       // [s] between looks whether a stream's session still is
constexpr int kSilentPings = 3;
constexpr int kAcceptWait = 100;  // [ms]

using Parser = http::request_parser<http::buffer_body>;

CellTime timeNow() {
  const auto utc = std::chrono::system_clock::now().time_since_epoch();
  return {SteadyClock().now(), std::chrono::duration<double>(utc).count()};
}

/// The connection as Beast's parser reads it.
class PeerReader {
 public:
  explicit PeerReader(PeerSocket& socket) : socket_(socket) {}

  // NOLINTBEGIN(readability-identifier-naming): Beast calls them so.
  template <class Buffers>
  std::size_t read_some(const Buffers& buffers, error_code& error) {
    const asio::mutable_buffer buffer = *asio::buffer_sequence_begin(buffers);
    const auto [result, bytes] = socket_.read(buffer.data(), buffer.size());
    if (result == PeerResult::Closed) error = asio::error::eof;
    if (result == PeerResult::Late) error = asio::error::timed_out;
    return bytes;
  }
  template <class Buffers>
  std::size_t read_some(const Buffers& buffers) {
    error_code error;
    const std::size_t bytes = read_some(buffers, error);
    if (error) throw boost::system::system_error(error);
    return bytes;
  }
  // NOLINTEND(readability-identifier-naming)

 private:
  PeerSocket& socket_;
};

HttpMethod methodOf(http::verb verb) {
  switch (verb) {
    case http::verb::get:
      return HttpMethod::Get;
    case http::verb::post:
      return HttpMethod::Post;
    case http::verb::delete_:
      return HttpMethod::Delete;
    default:
      return HttpMethod::Other;
  }
}

/// Headers that say who asks and for what: twice, they could be read in two ways.
bool isOnce(const std::string& name) {
  static constexpr std::array kOnce = {
      "host",           "origin",       "authorization", "x-api-key",       "cookie",
      "content-length", "content-type", "x-csrf-token",  "idempotency-key", "x-pressed-at"};
  return std::find(kOnce.begin(), kOnce.end(), name) != kOnce.end();
}

std::optional<HttpHead> requestHead(const http::request<http::buffer_body>& request, const HttpPeer& peer) {
  HttpHead head;
  head.method = methodOf(request.method());
  head.target = std::string(request.target());
  head.peer = peer;
  for (const auto& field : request) {
    const std::string name = lowerCase(std::string(field.name_string()));
    const std::string value(field.value());
    const auto [place, is_new] = head.headers.emplace(name, value);
    if (!is_new && isOnce(name)) return std::nullopt;
    if (!is_new) place->second += ", " + value;
  }
  return head;
}

/// One client, from its first byte to its last, in a thread of its own.
class Connection {
 public:
  struct Place {
    OperatorSite& site;
    const WebServerSettings& settings;
    ConnectionTable& table;
    const std::atomic<bool>& is_ending;
  };

  Connection(const Place& place, std::uint64_t number, PeerSocket& socket, HttpPeer peer)
      : place_(place), number_(number), socket_(socket), peer_(std::move(peer)), reader_(socket) {}

  void serve() {
    socket_.allow(place_.settings.patience.header_s);
    if (socket_.shakeHands() != PeerResult::Done) return;
    while (!place_.is_ending && serveRequest()) {
    }
    place_.table.use(number_, ConnectionUse::Waiting);  // gives way while it waits for its end
    socket_.close();
  }

 private:
  /// Sends all of it in the time that its size allows. Whoever takes longer than a moment gives way to others
  /// meanwhile.
  /// @param isTooFarBehind  asked with the bytes left each time that none were taken for a moment
  template <class Check>
  bool send(std::string_view bytes, const Check& isTooFarBehind) {
    const WebTimeouts& patience = place_.settings.patience;
    const double begun_s = clock_.now();
    const double until_s =
        begun_s + patience.write_s + static_cast<double>(bytes.size()) / patience.least_bytes_per_s;
    bool is_slow = false;
    while (!bytes.empty()) {
      const double now_s = clock_.now();
      if (now_s >= until_s) return false;
      if (!is_slow && now_s - begun_s >= patience.slow_s) {
        is_slow = true;
        place_.table.setPace(number_, ConnectionPace::Slow);
      }
      socket_.allow(std::min(patience.slow_s, until_s - now_s));
      const auto [result, written] = socket_.write(bytes.data(), bytes.size());
      if (result == PeerResult::Closed || (result == PeerResult::Late && isTooFarBehind(bytes.size())))
        return false;
      bytes.remove_prefix(written);
    }
    if (is_slow) place_.table.setPace(number_, ConnectionPace::Usual);
    return true;
  }

  bool send(std::string_view bytes) {
    return send(bytes, [](std::size_t) { return false; });
  }

  bool answer(const WebResponse& response, bool is_kept) {
    const WebResponse shown = is_shown_as_text_ ? errorAsText(response) : response;
    // As one, so that the time is that of the whole answer.
    return send(headText(shown, is_kept) + shown.body) && is_kept;
  }

  bool refuse(int status, const std::string& code, const std::string& message) {
    place_.site.noteRefusal(peer_, "a request", message, timeNow());
    return answer(plainError(status, code, message), false);
  }

  /// @return whether another request may follow
  bool serveRequest() {
    const WebTimeouts& patience = place_.settings.patience;
    place_.table.use(number_, ConnectionUse::Waiting);
    is_shown_as_text_ = false;
    if (buffer_.size() == 0 && !socket_.waitForBytes(patience.idle_s)) return false;
    Parser parser;
    parser.header_limit(kMostHeader);
    parser.body_limit(std::numeric_limits<std::uint64_t>::max());  // the site refuses what is too large
    socket_.allow(patience.header_s);
    error_code error;
    http::read_header(reader_, buffer_, parser, error);
    // Whoever has gone, or gave way to another, asked for nothing.
    if (error == http::error::end_of_stream || error == http::error::partial_message ||
        error == asio::error::eof)
      return false;
    if (error == asio::error::timed_out)
      return refuse(408, "too_slow", "the head of the request did not come whole in time");
    if (error == http::error::header_limit || error == http::error::buffer_overflow)
      return refuse(431, "too_large", "the head of the request has more than 16384 bytes");
    if (error) return refuse(400, "bad_request", "the head of the request is not HTTP");
    place_.table.use(number_, ConnectionUse::Answering);
    const auto head = requestHead(parser.get(), peer_);
    if (!head) return refuse(400, "bad_request", "a header that may stand once stands twice");
    is_shown_as_text_ = isShownAsText(*head);
    auto admission = place_.site.admit(*head, timeNow());
    const bool is_kept = parser.get().keep_alive();
    if (const auto* refused = std::get_if<WebResponse>(&admission))
      return answer(*refused, is_kept && !hasBody(*head));
    return serveAdmitted(parser, *head, std::get<OperatorSite::Admitted>(admission), is_kept);
  }

  static bool hasBody(const HttpHead& head) {
    const std::string length = head.header("content-length");
    return head.headers.count("transfer-encoding") != 0 || (!length.empty() && length != "0");
  }

  bool serveAdmitted(Parser& parser, const HttpHead& head, const OperatorSite::Admitted& admitted,
                     bool is_kept) {
    if (head.header("expect") == "100-continue" && hasBody(head) && !send("HTTP/1.1 100 Continue\r\n\r\n"))
      return false;
    switch (admitted.body) {
      case RouteBody::Upload:
        return serveUpload(parser, head, admitted, is_kept);
      case RouteBody::Socket:
        return serveSocket(head, admitted);
      case RouteBody::Camera:
        return serveCamera(head, admitted);
      case RouteBody::None:
      case RouteBody::Small:
        break;
    }
    WebRequest request{head, "", {}};
    if (const int status = readSmallBody(parser, request.body); status != 0)
      return refuse(status, "bad_body", "the body did not come whole in time, or has more than 65536 bytes");
    return answer(place_.site.answer(admitted, request, timeNow()), is_kept);
  }

  /// Reads a piece of the body into a buffer. @return bytes; nothing if it broke off
  std::optional<std::size_t> readPiece(Parser& parser, std::array<char, 16384>& piece) {
    auto& body = parser.get().body();
    body.data = piece.data();
    body.size = piece.size();
    error_code error;
    http::read_some(reader_, buffer_, parser, error);
    if (error && error != http::error::need_buffer) return std::nullopt;
    return piece.size() - body.size;
  }

  /// @return 0, or the status of the refusal
  int readSmallBody(Parser& parser, std::string& text) {
    socket_.allow(place_.settings.patience.body_s);
    std::array<char, 16384> piece{};
    while (!parser.is_done()) {
      const auto bytes = readPiece(parser, piece);
      if (!bytes) return 408;
      text.append(piece.data(), *bytes);
      if (text.size() > kMostSmallBody) return 413;
    }
    return 0;
  }

  bool serveUpload(Parser& parser, const HttpHead& head, const OperatorSite::Admitted& admitted,
                   bool is_kept) {
    if (!place_.table.use(number_, ConnectionUse::Upload))
      return refuse(503, "too_many", "too many uploads and streams at a time; expected fewer");
    const SiteSettings& site = place_.site.settings();
    try {
      UploadFile file(site.upload_folder, *multipartBoundary(head.header("content-type")),
                      site.most_upload_bytes, admitted.place);
      if (!readUpload(parser, file))
        return refuse(408, "too_slow", "the upload stood still for too long, or broke off");
      const WebRequest request{head, "", file.finish()};
      return answer(place_.site.answer(admitted, request, timeNow()), is_kept);
    } catch (const UploadTooLarge& error) {
      return refuse(error.status(), "too_large", error.status() == 413 ? error.what() : "the disk is full");
    } catch (const InvalidInput& error) {
      place_.site.noteRefusal(peer_, "an upload", error.what(), timeNow());
      return answer(plainError(400, "bad_form", "the form cannot be read, or holds no file"), false);
    } catch (const FileError& error) {
      place_.site.noteRefusal(peer_, "an upload", error.what(), timeNow());
      return answer(plainError(500, "no_file", "the file cannot be written"), false);
    }
  }

  bool readUpload(Parser& parser, UploadFile& file) {
    std::array<char, 16384> piece{};
    std::size_t since_step = 0;
    socket_.allow(place_.settings.patience.progress_s);
    while (!parser.is_done()) {
      const auto bytes = readPiece(parser, piece);
      if (!bytes || place_.is_ending) return false;
      file.read({piece.data(), *bytes});
      since_step += *bytes;
      if (since_step < kUploadStep) continue;
      since_step = 0;
      socket_.allow(place_.settings.patience.progress_s);
    }
    return true;
  }

  bool serveSocket(const HttpHead& head, const OperatorSite::Admitted& admitted) {
    const std::string key = head.header("sec-websocket-key");
    if (key.empty() || head.header("sec-websocket-version") != "13")
      return refuse(400, "no_socket", "the request is no WebSocket of version 13");
    if (!place_.table.use(number_, ConnectionUse::Stream))
      return refuse(503, "too_many", "too many uploads and streams at a time; expected fewer");
    StateBell::Ear ear(place_.site.bell());
    if (!send("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: "
              "Upgrade\r\nSec-WebSocket-Accept: " +
              webSocketAccept(key) + "\r\n\r\n"))
      return false;
    WebSocketReader frames;
    double sent_s = clock_.now();
    double heard_s = sent_s;
    double checked_s = sent_s;
    std::uint64_t sent = 0;
    const double ping_s = place_.settings.patience.ping_s;
    while (!place_.is_ending && clock_.now() - heard_s < ping_s * kSilentPings) {
      if (socket_.waitForBytesBeside(ear.descriptor(), kLiveInterval)) {
        if (!takeFrames(frames)) return false;
        heard_s = clock_.now();
      }
      ear.clear();  // before the look, so that no later state goes by
      if (clock_.now() - checked_s > kLeavingChecked) {
        checked_s = clock_.now();
        if (!place_.site.isStillIn(admitted.who, head, timeNow())) break;
      }
      const OperatorSite::Live live = place_.site.live(*admitted.who.role);
      const bool is_new = live.text && live.number != sent;
      if (is_new && !sendState(live, *admitted.who.role)) return false;
      if (is_new) sent = live.number;
      if (clock_.now() - sent_s < ping_s) continue;
      sent_s = clock_.now();
      if (!send(webSocketFrame(WebSocketOpcode::Ping, ""))) return false;
    }
    send(webSocketFrame(WebSocketOpcode::Close, std::string("\x03\xe9", 2)));
    return false;
  }

  /// @return false if the client is gone, or more than a MiB behind
  bool sendState(const OperatorSite::Live& live, WebRole role) {
    const std::string frame = webSocketFrame(WebSocketOpcode::Text, *live.text);
    const std::size_t most = place_.settings.most_unsent_bytes;
    if (socket_.unsent() > most) return false;
    return send(frame, [&](std::size_t left) {
      const std::uint64_t missed = place_.site.live(role).number - live.number;
      return socket_.unsent() + left + missed * frame.size() > most;
    });
  }

  /// Answers pings, and ends with the client. What a client says is ignored: nothing is commanded here.
  bool takeFrames(WebSocketReader& frames) {
    std::array<char, 4096> bytes{};
    socket_.allow(place_.settings.patience.write_s);
    const auto [result, count] = socket_.read(bytes.data(), bytes.size());
    if (result != PeerResult::Done) return false;
    frames.add({bytes.data(), count});
    try {
      while (const auto frame = frames.next()) {
        if (frame->opcode == WebSocketOpcode::Close) {
          send(webSocketFrame(WebSocketOpcode::Close, frame->payload.substr(0, 2)));
          return false;
        }
        if (frame->opcode == WebSocketOpcode::Ping &&
            !send(webSocketFrame(WebSocketOpcode::Pong, frame->payload)))
          return false;
      }
    } catch (const InvalidInput& error) {
      place_.site.noteRefusal(peer_, "a WebSocket", error.what(), timeNow());
      send(webSocketFrame(WebSocketOpcode::Close, std::string("\x03\xea", 2)));
      return false;
    }
    return true;
  }

  bool serveCamera(const HttpHead& head, const OperatorSite::Admitted& admitted) {
    if (!place_.table.use(number_, ConnectionUse::Stream))
      return refuse(503, "too_many", "too many uploads and streams at a time; expected fewer");
    if (!send("HTTP/1.1 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=picture\r\n"
              "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n"))
      return false;
    std::uint64_t sent = 0;
    double checked_s = clock_.now();
    while (!place_.is_ending) {
      // A viewer that is gone is seen by its end of file; it says nothing else.
      std::array<char, 64> ignored{};
      if (socket_.waitForBytes(kFrameInterval)) {
        if (socket_.read(ignored.data(), ignored.size()).result != PeerResult::Done) return false;
      }
      if (clock_.now() - checked_s > kLeavingChecked) {
        checked_s = clock_.now();
        if (!place_.site.isStillIn(admitted.who, head, timeNow())) return false;
      }
      const OperatorSite::Frame frame = place_.site.frame();
      if (frame.number == sent) continue;
      sent = frame.number;
      if (!send("--picture\r\nContent-Type: image/jpeg\r\nContent-Length: " +
                std::to_string(frame.jpeg->size()) + "\r\n\r\n") ||
          !send(*frame.jpeg) || !send("\r\n"))
        return false;
    }
    return false;
  }

  Place place_;
  std::uint64_t number_;
  PeerSocket& socket_;
  HttpPeer peer_;
  PeerReader reader_;
  SteadyClock clock_;
  boost::beast::flat_buffer buffer_{kMostBuffered};
  bool is_shown_as_text_ = false;  ///< errors of the request that is being answered
};

}  // namespace

class WebServer::Listener {
 public:
  Listener(WebServerSettings settings, OperatorSite& site, LogSink log)
      : settings_(std::move(settings)),
        site_(site),
        log_(std::move(log)),
        table_(settings_.connections, settings_.connections_of_client),
        acceptor_(context_) {
    requireSafe();
    if (settings_.tls) tls_ = tlsContext(settings_.tls->certificate, settings_.tls->key);
    open();
    thread_ = std::thread([this] { run(); });
  }

  ~Listener() {
    is_ending_ = true;
    thread_.join();
    table_.shutDownAll();
    for (Running& running : running_) running.thread.join();
  }

  std::uint16_t port() const { return port_; }

  std::string address() const {
    const bool is_v6 = settings_.bind.find(':') != std::string::npos;
    return std::string(settings_.tls ? "https://" : "http://") +
           (is_v6 ? "[" + settings_.bind + "]" : settings_.bind) + ':' + std::to_string(port_) + '/';
  }

 private:
  struct Running {
    std::thread thread;
    std::shared_ptr<std::atomic<bool>> is_done;
  };

  void requireSafe() const {
    if (settings_.tls || settings_.allows_plain || isLoopbackHost(settings_.bind)) return;
    throw InvalidConfig(
        "web.bind is " + settings_.bind +
        ", which other hosts reach, without TLS: tokens could be read on the way; expected web.tls, "
        "127.0.0.1, or web.allow_plain in a network of the cell's own");
  }

  void open() {
    try {
      const tcp::endpoint endpoint(asio::ip::make_address(settings_.bind), settings_.port);
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(tcp::acceptor::reuse_address(true));
      acceptor_.bind(endpoint);
      acceptor_.listen();
      acceptor_.non_blocking(true);
      port_ = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
      throw DeviceError("cannot listen on " + settings_.bind + ':' + std::to_string(settings_.port) + ": " +
                        error.code().message());
    }
  }

  void run() {
    // Writing to a connection that is gone is an error of that connection, and no end of the process.
    sigset_t broken_pipe;
    sigemptyset(&broken_pipe);
    sigaddset(&broken_pipe, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &broken_pipe, nullptr);
    while (!is_ending_) {
      reap();
      if (table_.isCrowded()) {
        // Clients wait in the queue of the system until those that gave way have ended.
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      pollfd poll{acceptor_.native_handle(), POLLIN, 0};
      if (::poll(&poll, 1, kAcceptWait) > 0) accept();
    }
  }

  void accept() {
    error_code error;
    tcp::endpoint client;
    tcp::socket socket = acceptor_.accept(context_, client, error);
    if (error == asio::error::would_block || error == asio::error::try_again) return;
    if (error) {
      // Where the host has no descriptors left, asking again at once would only take its time.
      std::this_thread::sleep_for(std::chrono::milliseconds(kAcceptWait));
      return;
    }
    const std::string address = client.address().to_string();
    const int descriptor = socket.native_handle();
    const std::uint64_t number = table_.add(descriptor, address);
    if (number == 0) return;
    const HttpPeer peer{address, isLoopbackHost(address), tls_ != nullptr};
    start(number, socket.release(error), peer);
  }

  void start(std::uint64_t number, int descriptor, const HttpPeer& peer) {
    auto is_done = std::make_shared<std::atomic<bool>>(false);
    const auto serve = [this, number, descriptor, peer, is_done] {
      {
        PeerSocket socket(descriptor, tls_.get());
        try {
          Connection({site_, settings_, table_, is_ending_}, number, socket, peer).serve();
        } catch (...) {
          log_(LogLevel::Error, "a request of " + peer.address + " failed: " + currentFailure().message);
        }
        table_.remove(number);
      }
      *is_done = true;
    };
    try {
      running_.push_back({std::thread(serve), is_done});
      is_short_of_threads_ = false;
    } catch (const std::system_error& error) {
      table_.remove(number);
      ::close(descriptor);
      if (!std::exchange(is_short_of_threads_, true))
        log_(LogLevel::Error, "connections are closed: no thread for them: " + std::string(error.what()));
      // Where the host has none left, trying again at once would only take its time.
      std::this_thread::sleep_for(std::chrono::milliseconds(kAcceptWait));
    }
  }

  void reap() {
    for (auto running = running_.begin(); running != running_.end();) {
      if (!*running->is_done) {
        ++running;
        continue;
      }
      running->thread.join();
      running = running_.erase(running);
    }
  }

  WebServerSettings settings_;
  OperatorSite& site_;
  LogSink log_;
  TlsContext tls_;
  ConnectionTable table_;
  asio::io_context context_;
  tcp::acceptor acceptor_;
  std::uint16_t port_ = 0;
  std::atomic<bool> is_ending_{false};
  std::list<Running> running_;
  bool is_short_of_threads_ = false;  ///< the last connection got none
  std::thread thread_;
};

WebServer::WebServer(WebServerSettings settings, OperatorSite& site, LogSink log)
    : listener_(std::make_unique<Listener>(std::move(settings), site, std::move(log))) {}

WebServer::~WebServer() = default;

std::uint16_t WebServer::port() const { return listener_->port(); }

std::string WebServer::address() const { return listener_->address(); }

}  // namespace lamina
