// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/modbus/modbus_server.hpp"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <condition_variable>
#include <mutex>
#include <random>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/modbus/plc_link.hpp"

namespace lamina {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

/// What the server reported, and a way to wait for it.
class Reported {
 public:
  void tell(const std::string& what) {
    const std::lock_guard<std::mutex> lock(mutex_);
    reported_.push_back(what);
    changed_.notify_all();
  }
  std::vector<std::string> waitFor(std::size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return reported_.size() >= count; });
    return reported_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> reported_;
};

/// A server whose registers hold their own addresses.
struct ServerOfAddresses {
  Reported broken;
  Reported closed;
  ModbusServer server;

  explicit ServerOfAddresses(ModbusServerSettings settings = onAnyPort())
      : server(std::move(settings),
               {[](int, const ModbusRequest& request) {
                  std::vector<std::uint16_t> values;
                  for (std::size_t i = 0; i < request.read_count; ++i)
                    values.push_back(static_cast<std::uint16_t>(request.read_address + i));
                  return modbusAnswer(request, values);
                },
                [this](int connection) { closed.tell(std::to_string(connection)); },
                [this](const std::string& address, const std::string& reason) {
                  broken.tell(address + ' ' + reason);
                }}) {}

  static ModbusServerSettings onAnyPort() {
    ModbusServerSettings settings;
    settings.port = 0;
    return settings;
  }
};

/// A client that sends bytes and reads as many as it asks for.
class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(context_) {
    socket_.connect({asio::ip::make_address("127.0.0.1"), port});
    socket_.set_option(tcp::no_delay(true));
  }
  void send(const std::string& bytes) { asio::write(socket_, asio::buffer(bytes)); }
  std::string receive(std::size_t count) {
    std::string bytes(count, '\0');
    asio::read(socket_, asio::buffer(bytes));
    return bytes;
  }
  /// True if the server closes without another byte.
  bool isClosed() {
    char byte = 0;
    boost::system::error_code error;
    return asio::read(socket_, asio::buffer(&byte, 1), error) == 0;
  }

 private:
  asio::io_context context_;
  tcp::socket socket_;
};

std::string readRequest(std::uint16_t transaction, std::uint8_t address, std::uint8_t count) {
  const std::vector<unsigned> bytes = {
      unsigned{transaction} >> 8U, transaction & 0xffU, 0, 0, 0, 6, 1, 4, 0, address, 0, count};
  return {bytes.begin(), bytes.end()};
}

TEST(ModbusServer, AnswersRequestsThatComeTogetherInTheirOrder) {
  ServerOfAddresses server;
  Client client(server.server.port());
  client.send(readRequest(1, 8, 1) + readRequest(2, 9, 1));
  const std::string answers = client.receive(22);
  EXPECT_EQ(answers[1], 1);
  EXPECT_EQ(answers[10], 8);
  EXPECT_EQ(answers[12], 2);
  EXPECT_EQ(answers[21], 9);
}

TEST(ModbusServer, ClosesAfterABrokenFrameAndSaysWhy) {
  ServerOfAddresses server;
  Client client(server.server.port());
  client.send(std::string("\0\1\0\7\0\6\1\4\0\0\0\1", 12));
  EXPECT_TRUE(client.isClosed());
  EXPECT_EQ(server.broken.waitFor(1).front(), "127.0.0.1 protocol 7; expected 0");
}

TEST(ModbusServer, ClosesWhereHalfAFrameIsAllThatComes) {
  ModbusServerSettings settings = ServerOfAddresses::onAnyPort();
  settings.half_frame_s = 0.05;
  ServerOfAddresses server(settings);
  Client client(server.server.port());
  client.send(readRequest(1, 8, 1).substr(0, 9));
  EXPECT_TRUE(client.isClosed());
  EXPECT_NE(server.broken.waitFor(1).front().find("half a frame"), std::string::npos);
}

TEST(ModbusServer, TakesSoManyConnectionsAndNoMore) {
  ModbusServerSettings settings = ServerOfAddresses::onAnyPort();
  settings.connections = 2;
  ServerOfAddresses server(settings);
  Client first(server.server.port());
  {
    Client second(server.server.port());
    second.send(readRequest(1, 3, 1));
    second.receive(11);
    Client third(server.server.port());
    EXPECT_TRUE(third.isClosed());
  }
  EXPECT_EQ(server.closed.waitFor(1).size(), 1U);
  Client fourth(server.server.port());
  fourth.send(readRequest(1, 3, 1));
  EXPECT_EQ(fourth.receive(11)[10], 3);
}

TEST(ModbusServer, MakesPlaceForADeviceWhoseOwnConnectionsAreSilent) {
  ModbusServerSettings settings = ServerOfAddresses::onAnyPort();
  settings.connections = 1;
  settings.replaceable_after_s = 0.0;
  ServerOfAddresses server(settings);
  Client dead(server.server.port());
  dead.send(readRequest(1, 3, 1));
  dead.receive(11);
  Client back(server.server.port());
  back.send(readRequest(1, 4, 1));
  EXPECT_EQ(back.receive(11)[10], 4);
  EXPECT_TRUE(dead.isClosed());
}

TEST(ModbusServer, TakesNobodyWhoIsNotNamed) {
  ModbusServerSettings settings = ServerOfAddresses::onAnyPort();
  settings.allow = {"192.0.2.1"};
  ServerOfAddresses server(settings);
  Client client(server.server.port());
  EXPECT_TRUE(client.isClosed());
}

TEST(ModbusServer, SaysWhereItCannotListen) {
  ServerOfAddresses server;
  ModbusServerSettings settings;
  settings.bind = "192.0.2.1";
  EXPECT_THROW(ServerOfAddresses{settings}, DeviceError);
  settings.bind = "nowhere";
  EXPECT_THROW(ServerOfAddresses{settings}, DeviceError);
}

/// A server of a PLC link, of which the registers can be looked at.
struct ServerOfLink {
  std::mutex mutex;
  PlcLink link{PlcLinkSettings{}};
  Reported broken;
  ModbusServer server{ServerOfAddresses::onAnyPort(),
                      {[this](int connection, const ModbusRequest& request) {
                         const std::lock_guard<std::mutex> lock(mutex);
                         return link.answer(connection, request, 0.0);
                       },
                       [this](int connection) {
                         const std::lock_guard<std::mutex> lock(mutex);
                         link.close(connection);
                       },
                       [this](const std::string&, const std::string& reason) { broken.tell(reason); }}};

  std::uint16_t heartbeat() {
    const std::lock_guard<std::mutex> lock(mutex);
    return link.inputs().heartbeat;
  }
};

std::string writeRequest(std::uint16_t transaction, std::uint16_t heartbeat) {
  const std::vector<unsigned> bytes = {
      unsigned{transaction} >> 8U, transaction & 0xffU, 0, 0, 0, 6, 1, 6, 0, 0,
      unsigned{heartbeat} >> 8U,   heartbeat & 0xffU};
  return {bytes.begin(), bytes.end()};
}

TEST(ModbusServer, RunsNoWriteThatHidesBehindARead) {
  ServerOfLink server;
  Client client(server.server.port());
  // A header that speaks of more than its read: a server that goes by functions would run what follows.
  std::string smuggled = readRequest(1, 0, 1) + writeRequest(2, 77);
  smuggled[5] = static_cast<char>(6 + 12);
  client.send(smuggled);
  EXPECT_TRUE(client.isClosed());
  EXPECT_NE(server.broken.waitFor(1).front().find("function 4 with 17 bytes"), std::string::npos);
  EXPECT_EQ(server.heartbeat(), 0);
}

/// Frames in pieces, two in one, and random bytes from three connections beside one that writes.
TEST(ModbusServer, TakesNoWriteThatIsNotWellFormed) {
  ServerOfLink server;
  std::mt19937 random(12);
  Client writer(server.server.port());
  std::vector<std::unique_ptr<Client>> others(3);
  for (std::uint16_t i = 1; i <= 1000; ++i) {
    const std::string request = writeRequest(i, i);
    const std::size_t cut = 1 + random() % (request.size() - 1);
    writer.send(request.substr(0, cut));
    auto& other = others[random() % others.size()];
    if (!other) other = std::make_unique<Client>(server.server.port());
    std::string rubbish(1 + random() % 300, '\0');
    for (char& byte : rubbish) byte = static_cast<char>(random());
    if (random() % 2 == 0)
      rubbish = writeRequest(0, 50'000).substr(0, 11);  // a write that does not come whole
    other->send(rubbish);
    other.reset();
    ASSERT_EQ(server.heartbeat(), i - 1) << "half a frame";
    writer.send(request.substr(cut) + readRequest(i, 2, 1));
    ASSERT_EQ(writer.receive(12), request) << "a write is answered by itself";
    writer.receive(11);
    ASSERT_EQ(server.heartbeat(), i);
  }
}

/// 10 000 transactions of which one in three is malformed: what is well-formed is answered, nothing else is.
TEST(ModbusServer, OutlivesMalformedFrames) {
  ServerOfAddresses server;
  std::mt19937 random(11);
  std::size_t answered = 0;
  std::size_t spoilt = 0;
  auto client = std::make_unique<Client>(server.server.port());
  for (int i = 0; i < 10'000; ++i) {
    std::string request =
        readRequest(static_cast<std::uint16_t>(i), static_cast<std::uint8_t>(random() % 200), 2);
    if (random() % 10 >= 3) {
      client->send(request);
      const std::string answer = client->receive(13);
      ASSERT_EQ(answer[0], request[0]);
      ASSERT_EQ(answer[1], request[1]);
      ASSERT_EQ(answer[10], request[9]);
      ++answered;
      continue;
    }
    request[2 + random() % 5] = static_cast<char>(2 + random() % 250);  // protocol, length or unit
    client->send(request + std::string(random() % 260, '\0'));
    client = std::make_unique<Client>(server.server.port());
    ++spoilt;
  }
  EXPECT_EQ(answered + spoilt, 10'000U);
  EXPECT_GT(spoilt, 2500U);
}

}  // namespace
}  // namespace lamina
