// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/csv_table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::string refusalOf(const std::string& text) {
  try {
    parseCsvTable(text, "t.csv");
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(CsvTableTest, ReadsCellsUnderTheirHeaderAndSkipsRemarks) {
  const CsvTable table =
      parseCsvTable("# from a book\n\nlayer, link,\"time, s\"\r\n0.3,\"a,b\",\n 0.15 ,,9", "t");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"layer", "link", "time, s"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"0.3", "a,b", ""}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"0.15", "", "9"}));
  EXPECT_EQ(table.lines, (std::vector<std::size_t>{4, 5}));
  EXPECT_EQ(columnOf(table, "link"), 1U);
}

TEST(CsvTableTest, NamesWhatIsWrongAndWhere) {
  EXPECT_EQ(refusalOf("# nothing\n"), "'t.csv' holds no header; expected names of columns");
  EXPECT_EQ(refusalOf("a,b\n1,2\n1,2,3\n"), "'t.csv' line 3: 3 cells; expected 2, as many as the header");
  EXPECT_EQ(refusalOf("a,a\n"), "'t.csv' line 1: two columns have the same name");
  EXPECT_EQ(refusalOf("a,\n"), "'t.csv' line 1: a column without a name");
  EXPECT_EQ(refusalOf("a,b\n\"1,2\n"), "'t.csv' line 2: a double quote that is not closed");
}

std::string refusalOfColumn(const std::string& text) {
  try {
    columnOf(parseCsvTable(text, "t.csv"), "c");
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(CsvTableTest, NamesItsColumnsIfThereAreNumbersBelow) {
  EXPECT_EQ(refusalOfColumn("a,b\nx,2\n"), "'t.csv' has no column 'c'; it has a, b");
  for (const char* text : {"a,b\n", "a,b\nx,y\n", "a\n1\n"})
    EXPECT_EQ(refusalOfColumn(text), "'t.csv' has no column 'c'; it has no columns of numbers") << text;
}

TEST(CsvTableTest, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csvCell("plain text"), "plain text");
  EXPECT_EQ(csvCell("#1"), "\"#1\"");
  EXPECT_EQ(csvCell(" a"), "\" a\"");
  EXPECT_EQ(csvCell("5\" wide"), "\"5\"\" wide\"");
  EXPECT_EQ(parseCsvTable("a,b\n\"1\n2\",3\n# 5\"\n4,5\n", "t").lines, (std::vector<std::size_t>{2, 5}));
}

TEST(CsvTableTest, ReadsBackAnyCells) {
  const auto cell =
      rc::gen::container<std::string>(rc::gen::element(',', '"', '#', '\n', '\r', ' ', 'a', '7'));
  EXPECT_TRUE(rc::check([&] {
    const std::vector<std::string> row = *rc::gen::container<std::vector<std::string>>(3, cell);
    std::string text = "a,b,c\n";
    for (int i = 0; i < 2; ++i)
      text += csvCell(row[0]) + "," + csvCell(row[1]) + "," + csvCell(row[2]) + "\n";
    const CsvTable table = parseCsvTable(text, "t");
    RC_ASSERT(table.rows == (std::vector<std::vector<std::string>>{row, row}));
  }));
}

}  // namespace
}  // namespace lamina
