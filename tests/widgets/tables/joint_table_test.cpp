#include "widgets/tables/joint_table.h"

#include "hexoderm/base/units.h"
#include "tests/support/qt_wait.h"
#include "tests/widgets/tables/table_texts.h"
#include "widgets/tables/joint_table_view.h"

#include <gmock/gmock.h>

namespace hexoderm {
namespace {

using test::text;
using testing::HasSubstr;

RobotJoint joint(const std::string& name, JointType type, std::optional<JointLimits> limits = {}) {
  RobotJoint joint;
  joint.name = name;
  joint.type = type;
  joint.limits = limits;
  return joint;
}

/// An elbow (0 to 120 degrees), a wrist that turns on and on, a lift in three poses; the last is not known at all.
JointSheet sheetOfThreePoses() {
  JointSheet sheet;
  sheet.joints = {joint("elbow", JointType::Revolute, JointLimits{0, 120 * kDegree}),
                  joint("wrist", JointType::Continuous), joint("lift", JointType::Prismatic, JointLimits{0, 0.3})};
  sheet.rows = {{PoseId(1), {{{"elbow", 30 * kDegree}, {"wrist", -90 * kDegree}, {"lift", 0.1234}}}},
                {PoseId(2), {{{"elbow", 45.126 * kDegree}}}},
                {PoseId(5), {}}};
  return sheet;
}

class JointTableTest : public testing::Test {
 protected:
  JointTableTest() {
    QLocale::setDefault(QLocale::c());
    table.setSheet(sheetOfThreePoses());
    QObject::connect(&table, &JointTable::typed, [this](const std::vector<TypedAngle>& angles) { typed = angles; });
    QObject::connect(&table, &JointTable::refused, [this](const QString& why) { refusals << why; });
  }
  ~JointTableTest() override { QLocale::setDefault(QLocale::system()); }

  bool type(int row, int column, const QString& what) {
    return table.setData(table.index(row, column), what, Qt::EditRole);
  }
  /// The session does what was typed.
  void follow() {
    JointSheet sheet = table.sheet();
    for (const TypedAngle& angle : typed) {
      auto& positions = sheet.rows[angle.row].angles.positions;
      if (angle.position) {
        positions[angle.joint] = *angle.position;
      } else {
        positions.erase(angle.joint);
      }
    }
    typed.clear();
    table.setSheet(sheet);
  }

  JointTable table;
  std::vector<TypedAngle> typed;
  QStringList refusals;
};

TEST_F(JointTableTest, ShowsDegreesAndMillimetresAndNothingWhereNothingIsKnown) {
  EXPECT_THAT(test::headers(table), testing::ElementsAre("elbow °", "wrist °", "lift mm"));
  EXPECT_THAT(test::rowTexts(table, 0), testing::ElementsAre("30.00", "−90.00", "123.40"));
  EXPECT_THAT(test::rowTexts(table, 1), testing::ElementsAre("45.13", "", ""));
  EXPECT_EQ(text(table, 1, 0, Qt::EditRole), "45.126") << "all that was typed";
  EXPECT_EQ(table.headerData(2, Qt::Vertical, Qt::DisplayRole).toString(), "Pose 5");
  EXPECT_THAT(text(table, 2, 1, Qt::AccessibleTextRole), testing::AllOf(HasSubstr("wrist"), HasSubstr("not known")));
}

TEST_F(JointTableTest, WhatIsTypedIsSaidInRadiansAndMetresAndShownOnlyOnceItIsSo) {
  ASSERT_TRUE(type(1, 1, "-12.5"));
  ASSERT_EQ(typed.size(), 1U);
  EXPECT_EQ(typed[0].row, 1U);
  EXPECT_EQ(typed[0].joint, "wrist");
  EXPECT_DOUBLE_EQ(typed[0].position.value(), -12.5 * kDegree);
  EXPECT_EQ(text(table, 1, 1), "");
  ASSERT_TRUE(type(2, 2, "80 mm"));
  EXPECT_DOUBLE_EQ(typed[0].position.value(), 0.08);
  ASSERT_TRUE(type(0, 0, QString()));
  EXPECT_FALSE(typed[0].position) << "an empty cell is an angle that is not known";
  typed.clear();
  EXPECT_TRUE(type(0, 1, "-90"));
  EXPECT_TRUE(type(2, 0, " "));
  EXPECT_TRUE(typed.empty()) << "nothing is new";
}

TEST_F(JointTableTest, TheCommaOfALanguageAndThePointOfProgramsAreOneAndTheSame) {
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  ASSERT_TRUE(type(2, 0, "12,5"));
  EXPECT_DOUBLE_EQ(typed[0].position.value(), 12.5 * kDegree);
  ASSERT_TRUE(type(2, 0, "1.234"));
  EXPECT_DOUBLE_EQ(typed[0].position.value(), 1.234 * kDegree) << "no thousands";
  EXPECT_EQ(text(table, 1, 0, Qt::EditRole), "45,126");
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
  EXPECT_FALSE(type(2, 0, "1,234"));
}

TEST_F(JointTableTest, WhatIsNoNumberIsRefusedText) {
  for (const char* wrong : {"abc", "12 13", "nan", "inf", "1e400"}) {
    EXPECT_FALSE(type(1, 0, QLatin1String(wrong))) << wrong;
    EXPECT_THAT(refusals.back().toStdString(), testing::AllOf(HasSubstr(wrong), HasSubstr("joint elbow in pose 2")));
  }
  EXPECT_FALSE(type(1, 0, "1e12"));
  EXPECT_THAT(refusals.back().toStdString(), HasSubstr("is no position of joint elbow"));
  EXPECT_TRUE(typed.empty());
}

TEST_F(JointTableTest, AnAngleBeyondTheLimitsOfItsJointIsMarkedAndSaysSo) {
  EXPECT_TRUE(table.index(0, 0).data(Qt::DecorationRole).isNull());
  ASSERT_TRUE(type(0, 0, "150"));
  follow();
  EXPECT_FALSE(table.index(0, 0).data(Qt::DecorationRole).value<QIcon>().isNull());
  EXPECT_THAT(text(table, 0, 0, Qt::ToolTipRole),
              testing::AllOf(HasSubstr("elbow"), HasSubstr("150"), HasSubstr("its limits are 0")));
  ASSERT_TRUE(type(0, 1, "720"));
  follow();
  EXPECT_TRUE(table.index(0, 1).data(Qt::DecorationRole).isNull()) << "the wrist turns on and on";
}

TEST_F(JointTableTest, ABlockOfASpreadsheetIsPastedAsAWholeOrNotAtAll) {
  table.paste(table.index(1, 0), "10\t20\r\n30\t\r\n");
  ASSERT_EQ(typed.size(), 3U) << "the last is not known before and after";
  EXPECT_EQ(typed[2].row, 2U);
  EXPECT_DOUBLE_EQ(typed[2].position.value(), 30 * kDegree);
  follow();
  EXPECT_THAT(test::rowTexts(table, 1), testing::ElementsAre("10.00", "20.00", ""));
  table.paste(table.index(1, 1), "1\t2\n3\tx\n");
  EXPECT_TRUE(typed.empty());
  EXPECT_THAT(refusals.back().toStdString(),
              testing::AllOf(HasSubstr("\"x\" is no number"), HasSubstr("lift in pose 5")));
  table.paste(table.index(2, 1), "1\t2\n3\t4\n");
  EXPECT_TRUE(typed.empty());
  EXPECT_THAT(refusals.back().toStdString(),
              HasSubstr("2 rows and 2 columns, and from here there is room for 1 and 2"));
  // What is copied can be pasted.
  const QString block = table.block({table.index(0, 0), table.index(1, 1)});
  EXPECT_EQ(block, "30\t-90\n10\t20\n");
}

TEST_F(JointTableTest, TheKeyboardTypesGoesOnClearsCopiesAndPastes) {
  JointTableView view(&table);
  view.resize(400, 200);
  view.show();
  view.activateWindow();
  ASSERT_TRUE(test::waitUntilExposed(view));
  view.setFocus();
  view.setCurrentIndex(table.index(0, 0));
  QTest::keyClicks(&view, "7");
  QWidget* editor = view.viewport()->findChild<QWidget*>();
  ASSERT_NE(editor, nullptr) << "a digit begins";
  table.setSheet(table.sheet());  // figures of a solve that ends meanwhile
  QTest::keyClicks(editor, "5");
  QTest::keyClick(editor, Qt::Key_Return);
  // Qt takes what is in an editor in the next turn of the event loop.
  ASSERT_TRUE(test::waitUntil([this] { return typed.size() == 1; }));
  EXPECT_DOUBLE_EQ(typed[0].position.value(), 75 * kDegree);
  EXPECT_EQ(view.currentIndex(), table.index(1, 0)) << "the pose below is next";
  follow();
  EXPECT_EQ(view.currentIndex(), table.index(1, 0)) << "new figures leave the cell where it is";
  QTest::keyClick(&view, Qt::Key_Delete);
  ASSERT_EQ(typed.size(), 1U);
  EXPECT_FALSE(typed[0].position);
  typed.clear();
  QApplication::clipboard()->setText("1\t2");
  view.paste();
  EXPECT_EQ(typed.size(), 2U);
  view.setCurrentIndex(table.index(0, 0));
  view.copy();
  EXPECT_EQ(QApplication::clipboard()->text(), "75\n");
  // The window's keys for poses do not act while the table has the keyboard.
  QKeyEvent override(QEvent::ShortcutOverride, Qt::Key_Delete, Qt::NoModifier);
  override.ignore();
  QApplication::sendEvent(&view, &override);
  EXPECT_TRUE(override.isAccepted());
}

}  // namespace
}  // namespace hexoderm
