#include "widgets/controls/selection.h"

#include <gtest/gtest.h>
#include <QSignalSpy>

namespace hexoderm {
namespace {

TEST(Selection, WhatIsSoughtIsPickedFirst) {
  Selection selection;
  std::optional<CellId> picked_then;
  QObject::connect(&selection, &Selection::sought, &selection, [&] { picked_then = selection.cell(); });
  QSignalSpy changed(&selection, &Selection::changed);
  selection.seekCell(CellId(7));
  EXPECT_EQ(picked_then, CellId(7));
  EXPECT_EQ(changed.count(), 1);
  // It may have gone out of sight since.
  picked_then.reset();
  selection.seekCell(CellId(7));
  EXPECT_EQ(picked_then, CellId(7));
  EXPECT_EQ(changed.count(), 1);
}

TEST(Selection, PickingSeeksNothing) {
  Selection selection;
  QSignalSpy sought(&selection, &Selection::sought);
  selection.selectCell(CellId(7));
  selection.selectLink({CellId(2), PortNumber(1)}, {CellId(1), PortNumber(3)});
  EXPECT_EQ(sought.count(), 0);
  selection.seekLink({CellId(5), PortNumber(1)}, {CellId(4), PortNumber(3)});
  EXPECT_EQ(sought.count(), 1);
  EXPECT_EQ(selection.link()->first.cell, CellId(4)) << "the smaller first";
}

}  // namespace
}  // namespace hexoderm
