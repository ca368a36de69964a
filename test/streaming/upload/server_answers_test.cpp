// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/server_answers.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "streaming/upload/print_account.hpp"
#include "streaming/upload/upload_fixture.hpp"

namespace lamina {
namespace {

using nlohmann::json;

json parsedNumber(const char* text) { return json::parse(text, nullptr, false); }

TEST(ServerAnswers, TakeWholeNumbersOnlyAsTheyAre) {
  constexpr auto kNone = std::optional<std::uint64_t>();
  EXPECT_EQ(numberOf<std::uint64_t>(parsedNumber("0")), 0U);
  EXPECT_EQ(numberOf<std::uint64_t>(parsedNumber("18446744073709551615")),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(numberOf<std::uint64_t>(parsedNumber("7.0")), 7U) << "some write a point";
  for (const char* text : {"-1", "-9223372036854775808", "1.5", "-0.5", "1e300", "-1e300",
                           "18446744073709551616", "\"7\"", "null", "true", "[7]", "{}", "\"NaN\""})
    EXPECT_EQ(numberOf<std::uint64_t>(parsedNumber(text)), kNone) << text;
  EXPECT_EQ(numberOf<int>(parsedNumber("-2147483648")), std::numeric_limits<int>::min());
  EXPECT_EQ(numberOf<int>(parsedNumber("2147483647")), std::numeric_limits<int>::max());
  for (const char* text : {"-2147483649", "2147483648", "18446744073709551615", "2147483648.0", "-3e9"})
    EXPECT_EQ(numberOf<int>(parsedNumber(text)), std::nullopt) << text;
  EXPECT_EQ(numberOf<std::uint32_t>(parsedNumber("4294967295")), 4294967295U);
  EXPECT_EQ(numberOf<std::uint32_t>(parsedNumber("4294967296")), std::nullopt);
}

TEST(ServerAnswers, AreNotReadWhereTheyNestWithoutEnd) {
  const auto nested = [](std::size_t depth) {
    return HttpResponse{200, R"({"a]":")" + std::string(500, '[') + R"(\"","b":)" +
                                 std::string(depth - 1, '[') + std::string(depth - 1, ']') + "}"};
  };
  EXPECT_TRUE(jsonOf(nested(100))) << "what is quoted does not count";
  EXPECT_FALSE(jsonOf(nested(101)));
  EXPECT_FALSE(jsonOf(nested(1000000))) << "its copy would have no room on the stack";
}

TEST(ServerAnswers, TakeMeasuredNumbersThatAMachineCanHave) {
  EXPECT_EQ(numberOf<double>(parsedNumber("-273.15")), -273.15);
  EXPECT_EQ(numberOf<double>(parsedNumber("210")), 210.0);
  for (const char* text : {"1e300", "-1e10", "\"210\"", "null"})
    EXPECT_EQ(numberOf<double>(parsedNumber(text)), std::nullopt) << text;
  EXPECT_EQ(numberOf<double>(json(std::numeric_limits<double>::quiet_NaN())), std::nullopt);
  EXPECT_EQ(numberOf<double>(json(std::numeric_limits<double>::infinity())), std::nullopt);
}

TEST(ServerAnswers, SayWhichNumberIsNone) {
  const json tree = {{"job", {{"filePosition", -5}, {"size", "many"}, {"lines", nullptr}}}};
  AnswerNumbers numbers(tree);
  EXPECT_EQ(numbers.at<std::uint64_t>("/job/lines"), std::nullopt);
  EXPECT_EQ(numbers.at<std::uint64_t>("/job/layers"), std::nullopt);
  EXPECT_EQ(numbers.doubted(), "") << "missing ones are none";
  EXPECT_EQ(numbers.at<std::uint64_t>("/job/filePosition"), std::nullopt);
  EXPECT_EQ(numbers.at<double>("/job/size"), std::nullopt);
  EXPECT_EQ(numbers.doubted(), "job/filePosition is -5; expected a whole number of 0 or more");
}

/// What a Moonraker makes of a report with that status of the printer.
std::unique_ptr<PrintServer> moonrakerTold(const json& changes) {
  auto server = makeMoonraker(test::orderOf("G1 X1\nG1 X2\n"));
  json status = {{"webhooks", {{"state", "ready"}}},
                 {"print_stats", {{"state", "printing"}, {"filename", test::kOurFile}}},
                 {"virtual_sdcard", {{"file_position", 6}}},
                 {"heaters", {{"available_heaters", {"extruder"}}}},
                 {"extruder", {{"temperature", 200.0}, {"target", 0.0}}},
                 {"gcode_move", {{"gcode_position", {1.0, 2.0, 3.0, 4.0}}}},
                 {"toolhead", {{"stalls", 2}}}};
  status.merge_patch(changes);
  server->read(UploadStep::Report, {200, json{{"result", {{"status", status}}}}.dump()});
  return server;
}

TEST(MoonrakerAnswers, AreTakenAsTheyAreWhereTheyAreSound) {
  const auto server = moonrakerTold(json::object());
  const MachineReport& report = server->report();
  EXPECT_EQ(report.bytes_read, 6U);
  EXPECT_EQ(report.stalls, 2U);
  EXPECT_FALSE(report.has_targets);
  ASSERT_TRUE(report.temperatures && report.position);
  EXPECT_EQ(report.temperatures->nozzle_c, 200.0);
  EXPECT_EQ(report.position->e, 4.0);
  EXPECT_EQ(report.doubt, "");
}

TEST(MoonrakerAnswers, AreLeftOutWithAReasonWhereTheyAreNot) {
  const auto position = moonrakerTold({{"virtual_sdcard", {{"file_position", -6}}}});
  EXPECT_FALSE(position->report().bytes_read);
  EXPECT_NE(position->report().doubt.find("file_position is -6"), std::string::npos);
  const auto stalls = moonrakerTold({{"toolhead", {{"stalls", 1e300}}}});
  EXPECT_FALSE(stalls->report().stalls);
  const auto cold = moonrakerTold({{"extruder", {{"temperature", "200"}}}});
  EXPECT_FALSE(cold->report().temperatures) << "not 0 degrees";
  const auto lost = moonrakerTold({{"gcode_move", {{"gcode_position", {1.0, "2", 3.0, 4.0}}}}});
  EXPECT_FALSE(lost->report().position);
  const auto hot = moonrakerTold({{"extruder", {{"target", "0"}}}});
  EXPECT_TRUE(hot->report().has_targets) << "what cannot be read may be on";
  const auto unlisted = moonrakerTold({{"heaters", {{"available_heaters", "extruder"}}}});
  EXPECT_TRUE(unlisted->report().has_targets);
  EXPECT_NE(unlisted->report().doubt.find("available_heaters"), std::string::npos);
}

TEST(DuetAnswers, AreLeftOutWithAReasonWhereTheyAreNoNumbers) {
  auto server = makeDuetWithComputer(test::orderOf("G1 X1\nG1 X2\n"));
  const auto told = [&](const json& job, const json& heat) {
    const json model = {{"state", {{"status", "processing"}}}, {"job", job}, {"heat", heat}};
    server->read(UploadStep::Report, {200, model.dump()});
    return server->report();
  };
  const json ours = {{"fileName", std::string("0:/gcodes/") + test::kOurFile}};
  const json off = {{"heaters", {{{"state", "off"}, {"current", 20.5}}}}};
  const MachineReport sound = told({{"file", ours}, {"filePosition", 6}}, off);
  EXPECT_EQ(sound.bytes_read, 6U);
  EXPECT_FALSE(sound.has_targets);
  ASSERT_TRUE(sound.temperatures);
  EXPECT_EQ(sound.temperatures->nozzle_c, 20.5);
  const MachineReport odd = told({{"file", ours}, {"filePosition", -1.5}}, {{"heaters", "off"}});
  EXPECT_FALSE(odd.bytes_read);
  EXPECT_TRUE(odd.has_targets) << "what cannot be read may be on";
  EXPECT_EQ(odd.doubt, "job/filePosition is -1.5; expected a whole number of 0 or more");
}

TEST(DuetAnswers, AreNoSuccessWhereTheirErrorIsNoNumber) {
  auto server = makeDuet(test::orderOf("G1 X1\nG1 X2\n"));
  const auto answer = server->read(UploadStep::Upload, {200, R"({"err": "1"})"});
  EXPECT_EQ(answer.kind, AnswerKind::Later);
  EXPECT_NE(answer.failure.message.find("err is \"1\""), std::string::npos) << answer.failure.message;
  EXPECT_EQ(server->read(UploadStep::Upload, {200, R"({"err": 4294967296})"}).kind, AnswerKind::Later)
      << "its low half is 0";
  EXPECT_EQ(server->read(UploadStep::Verify, {200, R"({"err": 0, "size": -12})"}).kind, AnswerKind::Later);
  EXPECT_EQ(server->read(UploadStep::Verify, {200, R"({"err": 0, "size": 12})"}).kind, AnswerKind::Done);
  EXPECT_EQ(server->read(UploadStep::Connect, {200, R"({"err": 0, "sessionKey": -1})"}).kind,
            AnswerKind::Later);
}

TEST(PrintAccount, TellsOnceWhatItLeavesOut) {
  const auto order = test::orderOf("G1 X1\nG1 X2\n");
  StreamStatus status;
  PrintAccount account(status, order->body);
  const auto sound = moonrakerTold(json::object());
  const auto odd = moonrakerTold({{"virtual_sdcard", {{"file_position", -6}}}});
  sound->follow(test::kOurFile);
  account.hearOfPrint(*sound);
  EXPECT_EQ(status.lines_acknowledged, 1U);
  account.hearOfPrint(*odd);
  EXPECT_EQ(status.lines_acknowledged, 1U);
  EXPECT_NE(status.message.find("left out of the machine's report: virtual_sdcard/file_position"),
            std::string::npos)
      << status.message;
  status.message = "read";
  account.hearOfPrint(*odd);
  EXPECT_EQ(status.message, "read");
}

}  // namespace
}  // namespace lamina
