// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Jobs as controllers save them, with what people write at the pendant: they are refused at the first line
// that is foreign, and not before it. Written for this test, from the grammars.
#include <gtest/gtest.h>

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/program/robot/robot_reader.hpp"

namespace lamina {
namespace {

std::string jobRefusal(const std::string& file, const std::string& text) {
  try {
    readRobotProgram({{file, text}}, "part");
    return "";
  } catch (const InvalidProgram& error) {
    return error.what();
  }
}

void expectRefused(const std::string& refusal, const std::string& expected) {
  EXPECT_EQ(refusal.rfind(expected, 0), 0U) << refusal;
}

TEST(ForeignJobs, OfKukaAreRefusedAtTheInterruptOfTheirHead) {
  expectRefused(
      jobRefusal("pick.src",
                 "&ACCESS RVP\r\n&REL 3\r\n&PARAM TEMPLATE = C:\\KRC\\Roboter\\Template\\vorgabe\r\n"
                 "DEF pick( )\r\n\r\n;FOLD INI\r\n  ;FOLD BASISTECH INI\r\n"
                 "    BAS (#INITMOV,0 )\r\n"
                 "    GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )\r\n"
                 "  ;ENDFOLD (BASISTECH INI)\r\n;ENDFOLD (INI)\r\nPTP HOME\r\nEND\r\n"),
      "'pick.src' line 9: found 'GLOBAL'; expected a statement that is known");
}

constexpr const char* kFanucHead =
    "/PROG  PICK\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"\";\nDEFAULT_GROUP\t= 1,*,*,*,*;\n/MN\n";
constexpr const char* kFanucPoints =
    "/POS\nP[1:\"HOME\"]{\n   GP1:\n\tUF : 0, UT : 1,\t\n\tJ1=     0.000 deg,\tJ2=     0.000 deg,\tJ3=     "
    "0.000 deg,\n\tJ4=     0.000 deg,\tJ5=   -90.000 deg,\tJ6=     0.000 deg\n};\nP[2]{\n   GP1:\n\tUF : 0, "
    "UT "
    ": 1,\t\tCONFIG : 'N U T, 0, 0, 0',\n\tX =   100.000  mm,\tY =     0.000  mm,\tZ =   500.000  mm,\n\tW = "
    "  "
    "180.000 deg,\tP =     0.000 deg,\tR =     0.000 deg\n};\n/END\n";

TEST(ForeignJobs, OfFanucHaveEmptyLinesAndNamesOfPoints) {
  const std::string begun = std::string(kFanucHead) + "   1:  !pick up ;\n   2:   ;\n";
  expectRefused(jobRefusal("pick.ls", begun + "   3:L P[2] 500mm/sec CNT100 ACC50    ;\n" + kFanucPoints),
                "'pick.ls' line 9: found 'ACC50    ;'; expected ';'");
  expectRefused(
      jobRefusal("pick.ls", begun + "   3:L P[2:over it] 500mm/sec FINE    ;\n   4:  R[1:n]=R[1:n]+1 ;\n" +
                                kFanucPoints),
      "'pick.ls' line 10: found 'R[1:n]=R[1:n]+1 ;'; expected a statement that is known");
  expectRefused(jobRefusal("pick.ls", begun + "   3:L P[2:over it 500mm/sec FINE    ;\n" + kFanucPoints),
                "'pick.ls' line 9: found 'over it 500mm/sec FINE    ;'; expected ']'");
}

TEST(ForeignJobs, OfYaskawaAreRefusedAtPositionVariables) {
  const std::string head =
      "/JOB\r\n//NAME PICK\r\n//POS\r\n///NPOS 2,0,0,0,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\n"
      "C00000=0,0,0,0,0,0\r\nC00001=1000,0,0,0,0,0\r\n//INST\r\n///DATE 2020/01/01 12:00\r\n///ATTR SC,RW\r\n"
      "///GROUP1 RB1\r\nNOP\r\n'go home\r\n";
  expectRefused(jobRefusal("pick.jbi", head + "SET B000 1\r\nEND\r\n"),
                "'pick.jbi' line 16: found 'SET B000 1'; expected an instruction that is known");
  expectRefused(jobRefusal("pick.jbi", head + "MOVL C00000 V=100.0\r\nEND\r\n"),
                "'pick.jbi' line 16: found ");
  std::string variables = head;
  variables.replace(variables.find("2,0,0,0,0,0"), 11, "2,0,0,1,0,0");
  expectRefused(jobRefusal("pick.jbi", variables + "END\r\n"), "'pick.jbi' line 4: found ");
}

TEST(ForeignJobs, OfUniversalRobotsAreRefusedAtTheirFirstOwnCall) {
  expectRefused(jobRefusal("pick.script",
                           "def pick():\n  set_tcp(p[0,0,0.1,0,0,0])\n\n  # over it\n  textmsg(\"hello\")\n"
                           "  movej([0,-1.57,0,-1.57,0,0], a=1.4, v=1.05)\nend\n"),
                "'pick.script' line 5: found 'textmsg'; expected a statement that is known");
}

}  // namespace
}  // namespace lamina
