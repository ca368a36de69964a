// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/drops/drop_dialect.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(DropDialect, KnowsItsDischargeWithAndWithoutParameters) {
  const DropDialect dialect;
  EXPECT_TRUE(isDischarge("M780", dialect));
  EXPECT_TRUE(isDischarge("M780 P3 S1", dialect));
  for (const char* other : {"M7800", "M78", "G1 X1", "", "m780"}) EXPECT_FALSE(isDischarge(other, dialect));
}

TEST(DropDialect, WithoutADischargeLetsNoDropGo) {
  DropDialect dialect;
  dialect.discharge.clear();
  EXPECT_FALSE(isDischarge("", dialect));
  EXPECT_FALSE(isDischarge("M780", dialect));
}

TEST(DropDialect, NamesRolesBothWays) {
  const DropDialect dialect;
  for (const PathRole role : {PathRole::OuterWall, PathRole::Infill, PathRole::GapFill})
    EXPECT_EQ(roleOf(roleName(role, dialect), dialect), role);
  EXPECT_EQ(roleName(PathRole::InnerWall, dialect), "CONTOUR");
  EXPECT_EQ(roleOf("SUPPORT", dialect), std::nullopt);
}

TEST(DropDialect, TakesItsWordsFromSettings) {
  DropDialect dialect;
  SettingsSchema schema;
  describe(schema, dialect);
  schema.set("drop_program.discharge", "M42 P1");
  schema.set("drop_program.void_fill", "EXTRA");
  EXPECT_TRUE(isDischarge("M42 P1", dialect));
  EXPECT_FALSE(isDischarge("M42 P10", dialect));
  EXPECT_EQ(roleOf("EXTRA", dialect), PathRole::GapFill);
}

}  // namespace
}  // namespace lamina
