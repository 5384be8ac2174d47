#include "app/window/toolkit/once_per_turn.h"

#include "tests/support/qt_wait.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

namespace hexoderm {
namespace {

TEST(OncePerTurn, BringsRequestsOfOneTurnTogether) {
  int count = 0;
  OncePerTurn work([&] { ++count; });
  const QSignalSpy done(&work, &OncePerTurn::done);
  for (int k = 0; k < 5; ++k) work.request();
  EXPECT_EQ(count, 0);
  QCoreApplication::sendPostedEvents(&work);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(done.count(), 1);
  work.request();
  QCoreApplication::sendPostedEvents(&work);
  EXPECT_EQ(count, 2);
}

TEST(OncePerTurn, WorksAtOnceWhereItCannotWait) {
  int count = 0;
  OncePerTurn work([&] { ++count; });
  work.finish();
  EXPECT_EQ(count, 0) << "nobody requested it";
  work.request();
  work.finish();
  EXPECT_EQ(count, 1);
  QCoreApplication::sendPostedEvents(&work);
  EXPECT_EQ(count, 1) << "it is done";
}

TEST(OncePerTurn, WorkMayRequestItselfForALaterTurn) {
  int count = 0;
  OncePerTurn* again = nullptr;
  OncePerTurn work([&] {
    if (++count < 3) again->request();
  });
  again = &work;
  work.request();
  EXPECT_TRUE(test::waitUntil([&] { return count == 3; }));
}

}  // namespace
}  // namespace hexoderm
