// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/modbus/modbus_frame.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>
#include <vector>

namespace lamina {
namespace {

/// Bytes written as hexadecimal pairs.
std::string bytes(const std::string& hex) {
  std::string out;
  for (std::size_t i = 0; i + 1 < hex.size(); i += hex[i] == ' ' ? 1 : 2)
    if (hex[i] != ' ') out += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return out;
}

std::optional<ModbusFrame> only(const std::string& hex) {
  FrameReader reader;
  reader.add(bytes(hex), 0.0);
  return reader.next();
}

template <class Kind>
Kind as(const std::optional<ModbusFrame>& frame) {
  if (!frame || !std::holds_alternative<Kind>(*frame)) {
    ADD_FAILURE() << "another kind of frame";
    return {};
  }
  return std::get<Kind>(*frame);
}

// The examples of the Modbus application protocol, section 6, behind a header.
TEST(FrameReader, ReadsTheProtocolsExamples) {
  const auto read = as<ModbusRequest>(only("0001 0000 0006 01 03 006b 0003"));
  EXPECT_EQ(read.function, ModbusFunction::ReadHolding);
  EXPECT_EQ(read.read_address, 0x6b);
  EXPECT_EQ(read.read_count, 3);
  EXPECT_TRUE(read.written.empty());

  const auto one = as<ModbusRequest>(only("0002 0000 0006 ff 06 0001 0003"));
  EXPECT_EQ(one.unit, 255);
  EXPECT_EQ(one.write_address, 1);
  EXPECT_EQ(one.written, (std::vector<std::uint16_t>{3}));

  const auto many = as<ModbusRequest>(only("1234 0000 000b 01 10 0001 0002 04 000a 0102"));
  EXPECT_EQ(many.transaction, 0x1234);
  EXPECT_EQ(many.written, (std::vector<std::uint16_t>{0x0a, 0x0102}));

  const auto both = as<ModbusRequest>(only("0003 0000 0011 01 17 0003 0006 000e 0003 06 00ff 00fe 00fd"));
  EXPECT_EQ(both.read_address, 3);
  EXPECT_EQ(both.read_count, 6);
  EXPECT_EQ(both.write_address, 14);
  EXPECT_EQ(both.written, (std::vector<std::uint16_t>{0xff, 0xfe, 0xfd}));
}

// "The value 0 is also accepted to communicate directly to a MODBUS/TCP device": guide to Modbus on TCP/IP,
// section 4.4.2.1, and what pymodbus sends unless told otherwise.
TEST(FrameReader, TakesTheUnitsThatMeanTheServerItself) {
  for (const int unit : {0, 1, 255}) {
    std::string frame = bytes("0001 0000 0006 00 04 0000 0001");
    frame[6] = static_cast<char>(unit);
    FrameReader reader;
    reader.add(frame, 0.0);
    const auto read = as<ModbusRequest>(reader.next());
    EXPECT_EQ(read.unit, unit);
    std::string answer = bytes("0001 0000 0005 00 04 02 0001");
    answer[6] = static_cast<char>(unit);
    EXPECT_EQ(modbusAnswer(read, {1}), answer) << unit;
  }
}

TEST(FrameReader, AnswersAsInTheProtocolsExamples) {
  const auto read = as<ModbusRequest>(only("0001 0000 0006 01 03 006b 0003"));
  EXPECT_EQ(modbusAnswer(read, {0x022b, 0, 0x64}), bytes("0001 0000 0009 01 03 06 022b 0000 0064"));
  const auto one = as<ModbusRequest>(only("0002 0000 0006 01 06 0001 0003"));
  EXPECT_EQ(modbusAnswer(one, {}), bytes("0002 0000 0006 01 06 0001 0003"));
  const auto many = as<ModbusRequest>(only("0003 0000 000b 01 10 0001 0002 04 000a 0102"));
  EXPECT_EQ(modbusAnswer(many, {}), bytes("0003 0000 0006 01 10 0001 0002"));
  EXPECT_EQ(modbusRefusal(refused(read, ModbusException::IllegalAddress)), bytes("0001 0000 0003 01 83 02"));
}

TEST(FrameReader, RefusesOtherFunctionsAndAmounts) {
  const auto function = as<RefusedRequest>(only("0001 0000 0006 01 01 0000 0001"));
  EXPECT_EQ(function.exception, ModbusException::IllegalFunction);
  EXPECT_EQ(function.function, 1);
  for (const char* frame : {"0001 0000 0006 01 03 0000 0000", "0001 0000 0006 01 04 0000 007e",
                            "0001 0000 0007 01 10 0000 0000 00", "0001 0000 0009 01 10 0000 0002 02 0001",
                            "0001 0000 000d 01 17 0000 0000 0000 0001 02 0001"})
    EXPECT_EQ(as<RefusedRequest>(only(frame)).exception, ModbusException::IllegalValue) << frame;
}

TEST(FrameReader, BreaksOffAtAHeaderThatCannotBe) {
  for (const char* frame :
       {"0001 0001 0006 01 03 0000 0001", "0001 0000 0001 01 03", "0001 0000 00ff 01 03",
        "0001 0000 0006 02 03 0000 0001", "0001 0000 0005 01 03 0000 00", "0001 0000 0002 01 10"})
    EXPECT_FALSE(as<BrokenFrame>(only(frame)).reason.empty()) << frame;
}

// A read whose header claims the length of a write as well, and the write within it: what readers that take
// the length from the function alone would run (libmodbus, issue 514).
TEST(FrameReader, RunsNoWriteThatIsSmuggledBehindARead) {
  FrameReader reader;
  reader.add(bytes("0001 0000 0012 01 03 0000 0001 0002 0000 0006 01 06 0001 0002"), 0.0);
  EXPECT_TRUE(std::holds_alternative<BrokenFrame>(*reader.next()));
  reader.add(bytes("0002 0000 0006 01 06 0001 0002"), 0.1);
  EXPECT_FALSE(reader.next()) << "nothing is read after a broken frame";
}

TEST(FrameReader, TakesFramesHoweverTheyAreSplit) {
  const std::string stream =
      bytes("0001 0000 0006 01 03 006b 0003 0002 0000 000b 01 10 0001 0002 04 000a 0102");
  for (std::size_t split = 0; split <= stream.size(); ++split) {
    FrameReader reader;
    std::vector<ModbusFrame> frames;
    for (const std::string& part : {stream.substr(0, split), stream.substr(split)}) {
      reader.add(part, 0.0);
      while (const auto frame = reader.next()) frames.push_back(*frame);
    }
    ASSERT_EQ(frames.size(), 2U) << split;
    EXPECT_EQ(std::get<ModbusRequest>(frames[0]).transaction, 1);
    EXPECT_EQ(std::get<ModbusRequest>(frames[1]).written.size(), 2U);
  }
}

TEST(FrameReader, ReportsHowLongHalfAFrameWaits) {
  FrameReader reader;
  EXPECT_DOUBLE_EQ(reader.waited(5.0), 0.0);
  reader.add(bytes("0001 0000"), 5.0);
  EXPECT_FALSE(reader.next());
  EXPECT_DOUBLE_EQ(reader.waited(5.8), 0.8);
  reader.add(bytes("0006 01 03 0000 0001 00"), 6.0);
  EXPECT_TRUE(reader.next());
  EXPECT_DOUBLE_EQ(reader.waited(6.5), 0.5) << "of the frame that has begun";
}

TEST(FrameReader, TakesAnyBytes) {
  EXPECT_TRUE(rc::check("random bytes end in frames or in silence, and what is written is bounded",
                        [](const std::vector<std::string>& pieces) {
                          FrameReader reader;
                          for (const std::string& piece : pieces) {
                            reader.add(piece, 0.0);
                            while (const auto frame = reader.next())
                              if (const auto* request = std::get_if<ModbusRequest>(&*frame)) {
                                RC_ASSERT(request->written.size() <= 123U);
                                RC_ASSERT(request->read_count <= 125U);
                              }
                          }
                        }));
}

TEST(FrameReader, TakesDamagedFrames) {
  const std::string good = bytes("1234 0000 000b 01 10 0001 0002 04 000a 0102");
  EXPECT_TRUE(rc::check("a frame with one byte changed writes what it says, or nothing", [&good] {
    std::string frame = good;
    const auto at = *rc::gen::inRange<std::size_t>(0, good.size());
    frame[at] = *rc::gen::arbitrary<char>();
    FrameReader reader;
    reader.add(frame, 0.0);
    const auto read = reader.next();
    if (!read || !std::holds_alternative<ModbusRequest>(*read)) return;
    const auto& request = std::get<ModbusRequest>(*read);
    RC_ASSERT(request.written.size() == (request.function == ModbusFunction::WriteMany ? 2U : 0U));
  }));
}

}  // namespace
}  // namespace lamina
