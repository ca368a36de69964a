// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "lamina/streaming/session/stream_session.hpp"
#include "streaming/emulator/print_server/emulated_print_server.hpp"
#include "streaming/transport/http_client.hpp"
#include "streaming/upload/upload_fixture.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

namespace http = boost::beast::http;
using boost::asio::ip::tcp;

/// An emulated print server on the loopback interface, one connection after the other.
class ListeningServer {
 public:
  explicit ListeningServer(std::unique_ptr<EmulatedPrintServer> server) : server_(std::move(server)) {
    thread_ = std::thread([this] {
      while (!is_over_) serve();
    });
  }
  ~ListeningServer() {
    is_over_ = true;
    try {
      knock();
      thread_.join();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "the server does not end: %s\n", error.what());
      std::abort();
    }
  }
  std::string address() const {
    return "http://127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port());
  }
  template <class Use>
  auto with(Use use) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return use(*server_);
  }

 private:
  /// Wakes the server up.
  void knock() {
    boost::asio::io_context context;
    tcp::socket socket(context);
    boost::system::error_code ignored;
    socket.connect(acceptor_.local_endpoint(ignored), ignored);
  }
  void serve() {
    tcp::socket socket(context_);
    acceptor_.accept(socket);
    boost::beast::flat_buffer buffer;
    http::request_parser<http::string_body> parser;
    parser.body_limit(std::uint64_t{1} << 30U);
    boost::system::error_code error;
    http::read(socket, buffer, parser, error);
    if (error) return;
    const auto& message = parser.get();
    HttpRequest request{std::string(message.method_string()), std::string(message.target())};
    for (const auto& field : message)
      request.headers.emplace_back(std::string(field.name_string()), std::string(field.value()));
    const HttpResponse answer = with([&](EmulatedPrintServer& server) {
      server.printer.elapse(clock_.now());
      return server.answer(request, message.body());
    });
    http::response<http::string_body> response{static_cast<http::status>(answer.status), 11};
    response.body() = answer.body;
    response.prepare_payload();
    http::write(socket, response, error);
  }

  boost::asio::io_context context_;
  tcp::acceptor acceptor_{context_, tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0)};
  SteadyClock clock_;
  std::mutex mutex_;
  std::unique_ptr<EmulatedPrintServer> server_;
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

class UploadSessionTest : public testing::TestWithParam<test::ServerKind> {};

TEST_P(UploadSessionTest, PrintsOverARealSocket) {
  ListeningServer server(GetParam().make());
  const std::string text = test::hotProgram(20000);
  server.with([](EmulatedPrintServer& emulated) { emulated.printer.lines_per_s = 1e5; });
  StreamSession session(StreamableProgram::fromText("part.gcode", text), {}, {server.address(), 0}, {});
  ASSERT_TRUE(session.waitFor(120.0));
  EXPECT_EQ(session.status().state, PackmlState::Complete) << session.status().failure.message;
  EXPECT_TRUE(server.with(
      [&](EmulatedPrintServer& emulated) { return emulated.printer.executed() == test::commandsOf(text); }));
}

TEST_P(UploadSessionTest, StopsThePrintWhenItIsAbandoned) {
  ListeningServer server(GetParam().make());
  const auto program = StreamableProgram::fromText("part.gcode", test::hotProgram(20000));
  {
    StreamSession session(program, {}, {server.address(), 0}, {});
    while (session.status().state != PackmlState::Execute && !session.isOver()) session.waitFor(0.01);
  }
  server.with([](EmulatedPrintServer& emulated) {
    EXPECT_EQ(emulated.printer.state(), EmulatedPrinter::State::Idle);
    EXPECT_EQ(emulated.printer.nozzle_target_c, 0.0);
  });
}

TEST_P(UploadSessionTest, KeepsWhatItHasUploadedAndHowFarTheMachineIs) {
  ListeningServer server(GetParam().make());
  server.with([](EmulatedPrintServer& emulated) { emulated.printer.lines_per_s = 30.0; });
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  const auto program = StreamableProgram::fromText("part.gcode", test::hotProgram(600));
  {
    StreamSession session(program, {}, {server.address(), 0}, {}, {{}, beginJournal(path), JobStart::New});
    while (session.status().lines_acknowledged == 0 && !session.isOver()) session.waitFor(0.01);
    const JournalledProgress known = readJournal(path);
    EXPECT_EQ(known.progress.state, PackmlState::Execute);
    EXPECT_EQ(known.job.protocol, GetParam().firmware);
    EXPECT_EQ(known.job.program_sha256, sha256Of(program));
    server.with([&](EmulatedPrintServer& emulated) {
      EXPECT_EQ(emulated.printer.files.count(known.job.uploaded_as), 1U) << known.job.uploaded_as;
      emulated.printer.lines_per_s = 1e5;
    });
    ASSERT_TRUE(session.waitFor(120.0));
    EXPECT_EQ(session.status().state, PackmlState::Complete) << session.status().failure.message;
  }
  const JobProgress known = readJournal(path).progress;
  EXPECT_EQ(known.state, PackmlState::Complete);
  EXPECT_EQ(known.taken_through, 602U);
  server.with([](EmulatedPrintServer& emulated) { emulated.printer.restart(); });
  StreamSession again(program, {}, {server.address(), 0}, {},
                      {{}, followJournal(path, program, server.address()), JobStart::Resume});
  ASSERT_TRUE(again.waitFor(120.0));
  EXPECT_EQ(again.status().failure.code, ErrorCode::Rejected);
  EXPECT_NE(again.status().failure.message.find("had read line 602 of 602"), std::string::npos)
      << again.status().failure.message;
}

INSTANTIATE_TEST_SUITE_P(Servers, UploadSessionTest,
                         testing::Values(test::ServerKind{"moonraker", makeEmulatedMoonraker, "klipper"},
                                         test::ServerKind{"duet", makeEmulatedDuet, "reprapfirmware"},
                                         test::ServerKind{"duet_with_computer", makeEmulatedDuetWithComputer,
                                                          "reprapfirmware"}),
                         [](const auto& server) { return std::string(server.param.name); });

TEST(UploadSession, SaysAtOnceThatNobodyListens) {
  const auto program = StreamableProgram::fromText("part", "G1 X1\n");
  EXPECT_THROW(StreamSession(program, {}, {"http://127.0.0.1:1", 0}, {}), Disconnected);
  StreamSettings settings;
  settings.password_file = "/nowhere/at/all";
  EXPECT_THROW(StreamSession(program, settings, {"http://127.0.0.1:1", 0}, {}), FileError);
}

TEST(HttpAddress, IsReadFromAPort) {
  EXPECT_EQ(httpAddressOf("http://printer.local").host, "printer.local");
  EXPECT_EQ(httpAddressOf("http://printer.local").port, "80");
  EXPECT_EQ(httpAddressOf("http://printer.local:7125/").port, "7125");
  EXPECT_EQ(httpAddressOf("http://[::1]:81").host, "::1");
  EXPECT_EQ(httpAddressOf("http://[::1]:81").port, "81");
  for (const char* wrong : {"https://printer.local", "http://", "http://host/path",
                            "http://host:", "http://host:x", "http://user:secret@host"})
    EXPECT_THROW(httpAddressOf(wrong), InvalidInput) << wrong;
}

std::string bodyRefusal(const std::string& text) {
  try {
    const ProgramBody body(StreamableProgram::fromText("part", text));
  } catch (const InvalidProgram& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(ProgramBody, QuotesNothingOfAFileThatIsNoProgram) {
  EXPECT_EQ(bodyRefusal("root SECRET (a)\n").find("SECRET"), std::string::npos);
  EXPECT_NE(bodyRefusal("G28\nFAST (a)\n").find("part line 2: 'FAST (a)' is read otherwise"),
            std::string::npos);
}

TEST(ProgramBody, RefusesWhatAPrinterReadsOtherwise) {
  for (const char* text : {"G1 X1 (a comment)\n", "N1 G1 X1\n", "%\nG1 X1\n", "M117 \"a;b\"\n"})
    EXPECT_THROW(ProgramBody(StreamableProgram::fromText("part", text)), InvalidProgram) << text;
  // Sums of "G1 X1" and a line feed, by Python's zlib and hashlib.
  const ProgramBody body(StreamableProgram::fromText("part", "G1 X1"));
  EXPECT_EQ(body.bytes(), 6U);
  EXPECT_EQ(body.crc32(), 0xdbcb34dbU);
  EXPECT_EQ(body.sha256(), "38e3d2e9d17ba9e585e9de10f536b76b1e565236dd1f38c347ed1b248845be57");
}

}  // namespace
}  // namespace lamina
