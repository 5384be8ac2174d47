// Heavy work falls due in turns of the event loop of its own.

#include "widgets/controls/heavy_turn.h"
#include "tests/support/qt_wait.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace hexoderm {
namespace {

/// Counts the turns of the event loop.
class Turns : public QObject {
 public:
  Turns() {
    connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::awake, this, [this] { ++count; });
  }
  int count = 0;
};

/// Makes what is due in so many ms due in one turn.
void oversleep(int ms) { QThread::msleep(static_cast<unsigned long>(ms)); }

TEST(HeavyTurn, PiecesThatAreDueTogetherHaveTurnsOfTheirOwn) {
  Turns turns;
  std::vector<int> done;
  std::vector<std::unique_ptr<HeavyTurn>> pieces;
  for (int k = 0; k < 3; ++k) {
    pieces.push_back(std::make_unique<HeavyTurn>(1, [&] { done.push_back(turns.count); }));
    pieces.back()->start();
  }
  oversleep(20);
  ASSERT_TRUE(test::waitUntil([&] { return done.size() == 3; }));
  EXPECT_LT(done[0], done[1]);
  EXPECT_LT(done[1], done[2]);
}

TEST(HeavyTurn, WaitsForATurnInWhichNothingHeavyWasDone) {
  Turns turns;
  int noted = -1;
  int done = -1;
  HeavyTurn piece(5, [&] { done = turns.count; });
  QTimer other;
  other.setSingleShot(true);
  QObject::connect(&other, &QTimer::timeout, [&] {
    HeavyTurn::note();
    noted = turns.count;
  });
  other.start(1);
  piece.start();
  oversleep(20);
  ASSERT_TRUE(test::waitUntil([&] { return done >= 0; }));
  EXPECT_GE(noted, 0);
  EXPECT_GT(done, noted);
}

TEST(HeavyTurn, IsDoneInTheEndWhereEveryTurnIsTaken) {
  bool is_done = false;
  HeavyTurn piece(1, [&] { is_done = true; });
  // Told of each turn after HeavyTurn, which ends them.
  HeavyTurn::note();
  const QMetaObject::Connection always = QObject::connect(QAbstractEventDispatcher::instance(),
                                                          &QAbstractEventDispatcher::awake, [] { HeavyTurn::note(); });
  piece.start();
  EXPECT_TRUE(test::waitUntil([&] { return is_done; }));
  QObject::disconnect(always);
}

TEST(HeavyTurn, StopsAndIsDoneOnceForSeveralStarts) {
  int done = 0;
  HeavyTurn piece(1, [&] { ++done; });
  piece.start();
  piece.start();
  EXPECT_TRUE(piece.isActive());
  ASSERT_TRUE(test::waitUntil([&] { return !piece.isActive(); }));
  EXPECT_EQ(done, 1);
  piece.start();
  piece.stop();
  EXPECT_FALSE(piece.isActive());
  HeavyTurn after(5, [&] { done += 10; });
  after.start();
  ASSERT_TRUE(test::waitUntil([&] { return done > 1; }));
  EXPECT_EQ(done, 11);
}

}  // namespace
}  // namespace hexoderm
