// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The job against grbl played by hand, line by line, at times that are set.
#include <gtest/gtest.h>

#include "lamina/streaming/session/streamer.hpp"
#include "streaming/emulator/grbl_link.hpp"

namespace lamina {
namespace {

constexpr char kIdle[] = "<Idle|MPos:0.000,0.000,0.000|Bf:15,128|FS:0,0|WCO:0.000,0.000,0.000>\r\n";
constexpr char kRun[] = "<Run|MPos:1.000,0.000,0.000|FS:100,0>\r\n";
constexpr char kLocked[] = "<Alarm|MPos:0.000,0.000,0.000|FS:0,0>\r\n";
constexpr char kGreeting[] = "\r\nGrbl 1.1h ['$' for help]\r\n";

class GrblPeer : public testing::Test {
 protected:
  static StreamSettings settings() { return test::reliableGrbl(); }

  /// Answers until the machine is known.
  static void identify(Streamer& streamer, const std::string& options = "[OPT:V,15,128]",
                       const std::string& setting = "$32=0") {
    streamer.start(0.0);
    streamer.elapse(0.0);
    EXPECT_EQ(streamer.takeOutput(), "?");
    streamer.receive(kIdle, 0.0);
    streamer.elapse(0.2);
    EXPECT_EQ(streamer.takeOutput(), "?");
    streamer.receive("error:20\r\n" + std::string(kIdle), 0.2);  // the error is of an older line
    EXPECT_EQ(streamer.takeOutput(), "$I\n");
    streamer.receive("[VER:1.1h.20190830:]\r\n" + options + "\r\nok\r\n", 0.2);
    EXPECT_EQ(streamer.takeOutput(), "$G\n");
    streamer.receive("[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]\r\nok\r\n", 0.2);
    EXPECT_EQ(streamer.takeOutput(), "$$\n");
    streamer.receive("$13=0\r\n" + setting + "\r\nok\r\n", 0.2);
  }
  /// The first output is lines of the program.
  std::string begin(Streamer& streamer, const std::string& options = "[OPT:V,15,128]") {
    identify(streamer, options);
    streamer.elapse(0.2);
    EXPECT_EQ(streamer.status().state, PackmlState::Execute) << streamer.status().failure.message;
    return streamer.takeOutput();
  }
  static StreamableProgram program(const std::string& text) {
    return StreamableProgram::fromText("job", text, settings());
  }
  static std::string messageOf(const Streamer& streamer) { return streamer.status().failure.message; }
  static void expectIn(const std::string& part, const std::string& text) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
  /// Answers a safe stop.
  static void stopSafely(Streamer& streamer, double now) {
    EXPECT_EQ(streamer.takeOutput(), "!?");
    streamer.receive("<Hold:1|MPos:0.500,0.000,0.000|FS:50,0>\r\n", now);
    EXPECT_EQ(streamer.takeOutput(), "");
    streamer.receive("<Hold:0|MPos:0.700,0.000,0.000|FS:0,0>\r\n", now + 0.1);
    EXPECT_EQ(streamer.takeOutput(), "\x18");
    streamer.receive(kGreeting, now + 0.2);
    EXPECT_EQ(streamer.takeOutput(), "?");
    EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
    streamer.receive(kIdle, now + 0.3);
    EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  }

  StreamableProgram two_ = program("G1 X1 F100\nX2\n");
};

TEST_F(GrblPeer, ChangesItsFeedAmidTheLines) {
  Streamer streamer(two_, settings());
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 80.0}, 0.0), kNoJobToChange);
  begin(streamer);
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 121.0}, 0.3), "");
  EXPECT_EQ(streamer.takeOutput(), "?") << "what it is now is not known yet";
  // One byte for each report, since grbl takes equal ones that come together for one: 100, 110, 120, 121.
  for (const auto& [reported, sent] :
       {std::pair{"100", "\x91"}, {"110", "\x91"}, {"120", "\x93"}, {"121", ""}}) {
    streamer.receive("<Run|MPos:0.500,0.000,0.000|FS:0,0|Ov:" + std::string(reported) + ",100,100>\r\n", 0.4);
    EXPECT_EQ(streamer.takeOutput(), sent) << reported;
  }
  EXPECT_EQ(streamer.change({LiveSetting::Feed, 250.0}, 0.3), "feed is 250 %; grbl takes 10 to 200 %");
  EXPECT_EQ(streamer.change({LiveSetting::Rapid, 30.0}, 0.3), "rapid is 30 %; grbl takes 25, 50 and 100 %");
  EXPECT_EQ(streamer.change({LiveSetting::Flow, 90.0}, 0.3), "grbl has no flow");
}

TEST_F(GrblPeer, SaysThatAnOverrideWasNotReached) {
  Streamer streamer(two_, settings());
  begin(streamer);
  EXPECT_EQ(streamer.change({LiveSetting::Spindle, 50.0}, 1.0), "");
  streamer.receive(kRun, 5.9);
  EXPECT_EQ(streamer.status().message, "");
  streamer.receive(kRun, 6.0);
  expectIn("has not reported spindle 50 % (Ov) in time", streamer.status().message);
}

TEST_F(GrblPeer, IsAskedWhoItIsBeforeTheFirstLine) {
  Streamer streamer(two_, settings());
  EXPECT_EQ(begin(streamer), "G1 X1 F100\nX2\n");
  EXPECT_EQ(streamer.status().firmware_name, "grbl 1.1h.20190830");
}

TEST_F(GrblPeer, NeverGetsMoreThanItsBufferHolds) {
  std::string text;
  for (int i = 10; i < 40; ++i) text += "G1 X" + std::to_string(i) + " F100\n";  // 12 bytes each with its end
  Streamer streamer(program(text), settings());
  // 127 bytes by the settings, less three for a question: ten lines are 120, eleven would be 132.
  EXPECT_EQ(begin(streamer).size(), 120U);
  Streamer narrow(program(text), settings());
  EXPECT_EQ(begin(narrow, "[OPT:V,15,64]").size(), 60U);  // five; six would be 72
  narrow.receive("ok\r\nok\r\n", 0.3);
  EXPECT_EQ(narrow.takeOutput(), "G1 X15 F100\nG1 X16 F100\n");
  EXPECT_EQ(narrow.status().lines_acknowledged, 2U);
}

TEST_F(GrblPeer, IsCompleteWhenAQuestionBehindTheLastLineIsAnsweredAndItRestsWhereTheProgramEnds) {
  Streamer streamer(two_, settings());
  begin(streamer);
  streamer.receive("ok\r\nok\r\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), "$G\n");
  streamer.receive("[GC:G1]\r\nok\r\n", 0.4);
  EXPECT_EQ(streamer.status().state, PackmlState::Completing);
  streamer.receive(kIdle, 0.41);  // from before the motion
  streamer.receive(kRun, 0.6);
  streamer.receive("<Idle|MPos:2.000,0.000,0.000|FS:0,0>\r\n", 0.8);
  EXPECT_EQ(streamer.status().state, PackmlState::Completing);
  streamer.receive("<Idle|MPos:2.000,0.000,0.000|FS:0,0>\r\n", 1.0);
  EXPECT_EQ(streamer.status().state, PackmlState::Complete);
}

TEST_F(GrblPeer, IsNotCompleteWhereItStandsElsewhere) {
  Streamer streamer(two_, settings());
  begin(streamer);
  streamer.receive("ok\r\nok\r\n", 0.3);
  streamer.receive("[GC:G1]\r\nok\r\n", 0.4);
  streamer.receive("<Idle|MPos:7.000,0.000,0.000|FS:0,0>\r\n", 0.8);
  streamer.receive("<Idle|MPos:7.000,0.000,0.000|FS:0,0>\r\n", 1.0);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborting);
  expectIn("X is 7.000 mm; expected 2.000 mm", messageOf(streamer));
}

TEST_F(GrblPeer, ThatAnswersMoreOrLessThanItWasSentIsInDoubt) {
  Streamer more(two_, settings());
  begin(more);
  more.receive("ok\r\nok\r\nok\r\n", 0.3);
  EXPECT_EQ(more.status().state, PackmlState::Aborting);
  expectIn("in doubt", messageOf(more));
  Streamer less(two_, settings());
  begin(less);
  less.receive("ok\r\n", 0.3);
  less.receive(kIdle, 0.4);
  less.takeOutput();
  for (double now = 0.5; now < 4.0; now += 0.1) less.elapse(now);
  expectIn("$G\n", less.takeOutput());
  less.receive("[GC:G1]\r\nok\r\n", 4.0);
  EXPECT_EQ(less.status().state, PackmlState::Aborting);
  expectIn("a question behind line 2 was answered, the line was not", messageOf(less));
}

TEST_F(GrblPeer, ThatRefusesALineIsHeldAndResetAtOnce) {
  Streamer streamer(two_, settings());
  begin(streamer);
  streamer.receive("error:22\r\n", 0.3);
  expectIn("line 1 'G1 X1 F100' (error:22, no feed rate is set)", messageOf(streamer));
  streamer.elapse(0.3);
  stopSafely(streamer, 0.35);
}

TEST_F(GrblPeer, ThatLocksItselfIsResetWithoutAHold) {
  Streamer streamer(two_, settings());
  begin(streamer);
  streamer.receive("ALARM:1\r\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), "\x18");
  expectIn("a limit switch was hit", messageOf(streamer));
  streamer.receive(std::string(kGreeting) + kLocked, 1.0);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
}

TEST_F(GrblPeer, ThatGreetsInAJobWasReset) {
  Streamer streamer(two_, settings());
  begin(streamer);
  streamer.receive("\xffGrbl 1.1h ['$' for help]\r\n", 0.3);
  expectIn("the machine was reset", messageOf(streamer));
  EXPECT_EQ(streamer.takeOutput(), "!?");
}

TEST_F(GrblPeer, ThatIsLockedIsLeftSo) {
  Streamer streamer(two_, settings());
  streamer.start(0.0);
  streamer.elapse(0.0);
  streamer.takeOutput();
  streamer.receive("<Alarm:2|MPos:0.000,0.000,0.000>\r\n", 0.1);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  expectIn("ALARM:2, a motion would leave the machine's travel", messageOf(streamer));
  expectIn("$H", messageOf(streamer));
  EXPECT_EQ(streamer.takeOutput(), "");
}

TEST_F(GrblPeer, ThatIsLockedIsUnlockedWhereThatIsAskedFor) {
  StreamSettings once = settings();
  once.unlock = UnlockPolicy::Once;
  Streamer streamer(two_, once);
  streamer.start(0.0);
  streamer.elapse(0.0);
  streamer.takeOutput();
  streamer.receive(kLocked, 0.1);
  EXPECT_EQ(streamer.takeOutput(), "$X\n");
  streamer.receive(std::string("[MSG:Caution: Unlocked]\r\nok\r\n") + kIdle + kIdle, 0.2);
  EXPECT_EQ(streamer.takeOutput(), "$I\n");
}

TEST_F(GrblPeer, ThatMovesForSomebodyElseIsWaitedForAndNotStopped) {
  Streamer streamer(two_, settings());
  streamer.start(0.0);
  for (double now = 0.0; now < 11.0; now += 0.1) {
    streamer.elapse(now);
    streamer.receive(kRun, now);
  }
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  expectIn("state Run", messageOf(streamer));
  EXPECT_EQ(streamer.takeOutput().find_first_not_of('?'), std::string::npos);
}

TEST_F(GrblPeer, BehindALossyLinkGetsNothing) {
  StreamSettings lossy = settings();
  lossy.link = LinkKind::Lossy;
  Streamer streamer(two_, lossy);
  streamer.start(0.0);
  streamer.elapse(0.0);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  expectIn("stream.link", messageOf(streamer));
  EXPECT_EQ(streamer.takeOutput(), "");
}

TEST_F(GrblPeer, HoldsAndGoesOn) {
  Streamer streamer(two_, settings());
  begin(streamer);
  EXPECT_TRUE(streamer.pause(0.3));
  EXPECT_EQ(streamer.takeOutput(), "!?");
  streamer.receive("<Hold:1|MPos:0.500,0.000,0.000|FS:50,0>\r\n", 0.4);
  EXPECT_EQ(streamer.status().state, PackmlState::Holding);
  streamer.receive("<Hold:0|MPos:0.600,0.000,0.000|FS:0,0>\r\n", 0.5);
  EXPECT_EQ(streamer.status().state, PackmlState::Held);
  EXPECT_TRUE(streamer.resume(1.0));
  EXPECT_EQ(streamer.takeOutput(), "~?");
  streamer.receive("<Hold:0|MPos:0.600,0.000,0.000|FS:0,0>\r\n", 1.1);  // from before it went on
  EXPECT_EQ(streamer.status().state, PackmlState::Unholding);
  streamer.receive(kRun, 1.2);
  EXPECT_EQ(streamer.status().state, PackmlState::Execute);
}

TEST_F(GrblPeer, HoldsInFrontOfALayerWhenTheLinesBeforeItHaveEnded) {
  std::string text = ";LAYER:0\n";
  for (int i = 10; i < 24; ++i)
    text += (i == 21 ? ";LAYER:1\n" : "") + std::string("G1 X") + std::to_string(i) + " F100\n";
  Streamer streamer(program(text), settings());
  EXPECT_EQ(begin(streamer).size(), 120U) << "ten lines of layer 0, which has eleven";
  EXPECT_EQ(streamer.change({LiveSetting::PauseAtLayer, 1.0}, 0.3), "");
  streamer.receive("ok\r\nok\r\nok\r\n", 0.3);
  EXPECT_EQ(streamer.takeOutput(), "G1 X20 F100\n");
  streamer.receive(kIdle, 0.4);  // from before a line was read
  streamer.receive("ok\r\nok\r\nok\r\nok\r\nok\r\nok\r\nok\r\nok\r\n", 0.5);
  streamer.receive(kRun, 0.6);
  streamer.receive(kIdle, 0.8);
  EXPECT_EQ(streamer.takeOutput(), "");
  EXPECT_EQ(streamer.status().state, PackmlState::Execute);
  streamer.receive(kIdle, 0.9);
  EXPECT_EQ(streamer.takeOutput(), "!?");
  streamer.receive("<Hold:0|MPos:20.000,0.000,0.000|FS:0,0>\r\n", 1.0);
  EXPECT_EQ(streamer.status().state, PackmlState::Held);
  EXPECT_EQ(streamer.status().message, "holds in front of layer 1");
  EXPECT_EQ(streamer.status().starvation.count, 0U);
  EXPECT_TRUE(streamer.resume(9.0));
  EXPECT_EQ(streamer.takeOutput(), "~?");
  streamer.receive(kIdle, 9.1);
  EXPECT_EQ(streamer.takeOutput(), "G1 X21 F100\nG1 X22 F100\nG1 X23 F100\n");
}

TEST_F(GrblPeer, OfALaserIsWarnedOfABeamThatBurnsOn) {
  const auto warningOf = [](const std::string& text, const std::string& setting) {
    Streamer streamer(program(text), settings());
    identify(streamer, "[OPT:V,15,128]", setting);
    streamer.elapse(0.2);
    EXPECT_EQ(streamer.status().state, PackmlState::Execute);
    return streamer.status().warning;
  };
  expectIn("job line 2: 'G1 M3 S500' keeps the laser on", warningOf("G21\nG1 M3 S500\nX1\nM3\n", "$32=1"));
  EXPECT_EQ(warningOf("G21\nM4 S500\nM30\n", "$32=1"), "");
  EXPECT_EQ(warningOf("G21\nM3 S500\n", "$32=0"), "") << "a mill";
}

TEST_F(GrblPeer, ThatHoldsByItselfIsObeyed) {
  Streamer streamer(two_, settings());
  begin(streamer);
  streamer.receive("<Door:1|MPos:0.600,0.000,0.000|FS:0,0>\r\n", 0.5);
  EXPECT_EQ(streamer.status().state, PackmlState::Held);
  EXPECT_FALSE(streamer.resume(0.6)) << "the door is open";
  streamer.receive(kRun, 2.0);  // somebody has closed it and pressed the button
  EXPECT_EQ(streamer.status().state, PackmlState::Execute);
}

TEST_F(GrblPeer, ThatNeitherMovesNorAnswersEndsTheJob) {
  Streamer streamer(two_, settings());
  begin(streamer);
  for (double now = 0.3; now < 70.0; now += 0.5) {
    streamer.elapse(now);
    streamer.receive(kRun, now);
  }
  expectIn("neither moved nor answered", messageOf(streamer));
}

TEST_F(GrblPeer, DoesNotConfirmAStopThatItDoesNotAnswer) {
  Streamer streamer(two_, settings());
  begin(streamer);
  streamer.abort({ErrorCode::Cancelled, "stopped"}, 0.3);
  for (double now = 0.3; now < 11.0; now += 0.1) streamer.elapse(now);
  EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
  expectIn("did not confirm the safe stop", messageOf(streamer));
  expectIn("position is lost", messageOf(streamer));
  expectIn("\x18", streamer.takeOutput());
}

TEST_F(GrblPeer, IsToldWhatItDoesNotKnowBeforeAnythingMoves) {
  for (const auto& [line, expected] : std::vector<std::pair<std::string, std::string>>{
           {"M104 S200", "has M104, which grbl 1.1h.20190830 does not know"},
           {"G1 A3", "has the word A"},
           {"G5 X1", "has G5"},
           {"M7", "has M7"},
           {"G1 X" + std::string(90, '1'), "is 93 characters"}}) {
    Streamer streamer(program("G21\n" + line + "\n"), settings());
    identify(streamer);
    streamer.elapse(0.2);
    EXPECT_EQ(streamer.status().state, PackmlState::Aborted);
    expectIn("job line 2", messageOf(streamer));
    expectIn(expected, messageOf(streamer));
    EXPECT_EQ(streamer.takeOutput(), "");
  }
}

TEST_F(GrblPeer, IsNotGivenWhatItWouldObeyAsItArrives) {
  for (const std::string line : {"G1 X1!", "M117 why?", "$H", "G1 X1 E2", "G1 X1~"})
    EXPECT_THROW(program(line + "\n"), InvalidProgram) << line;
}

TEST_F(GrblPeer, OfEveryKindIsFoundByWhatItSays) {
  for (const std::string said :
       {"error:20\r\n", "error:9\r\n", "Grbl 1.1h ['$' for help]\r\n",
        "GrblHAL 1.1f ['$' or '$HELP' for help]\r\n", "Grbl 3.9 [FluidNC v3.9.1 (wifi) '$' for help]\r\n",
        "FIRMWARE_NAME:grblHAL\r\nok\r\n"}) {
    StreamSettings any = settings();
    any.firmware = kAnyFirmware;
    Streamer streamer(two_, any);
    streamer.start(0.0);
    EXPECT_EQ(streamer.takeOutput(), "M115\n");
    streamer.receive(said, 0.1);
    streamer.elapse(0.1);
    EXPECT_EQ(streamer.takeOutput(), "?") << said;
  }
}

}  // namespace
}  // namespace lamina
