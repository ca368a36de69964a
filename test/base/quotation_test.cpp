// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/quotation.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(Quotation, ShowsNothingOfAFileThatIsNotRecognised) {
  const Quotation quotation;
  EXPECT_FALSE(quotation.isRecognised());
  EXPECT_EQ(quotation.of("root:$6$SECRET").find("root"), std::string::npos);
  EXPECT_EQ(quotation.of("root:$6$SECRET"), quotation.of("x")) << "nor its length";
}

TEST(Quotation, ShowsPrintableTextOfAFileThatIs) {
  Quotation quotation;
  quotation.recognise();
  EXPECT_EQ(quotation.of("G1 X?"), "'G1 X?'");
  EXPECT_EQ(quotation.of("\x1b[2J\n"), "'?[2J?'");
  EXPECT_EQ(quotation.of(std::string(40, 'a')), "'" + std::string(40, 'a') + "'");
  EXPECT_EQ(quotation.of(std::string(41, 'a')), "'" + std::string(40, 'a') + "...'");
}

}  // namespace
}  // namespace lamina
