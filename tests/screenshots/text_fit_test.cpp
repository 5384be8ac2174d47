#include "tests/screenshots/text_fit.h"
#include "app/window/settings/translation.h"
#include "tests/app/window/window_test.h"
#include "tests/screenshots/screenshot_tour.h"
#include "tests/support/paths.h"

#include <QHBoxLayout>
#include <QProcess>
#include <QScrollArea>
#include <QTabBar>
#include <QTableWidget>
#include <QVBoxLayout>

namespace hexoderm {
namespace {

const QString kText = QStringLiteral("A text that is long enough to be cut off");

/// A window of a size, for parts that are put into it.
struct Window : QWidget {
  Window(int width, int height) { QWidget::resize(width, height); }
  void appear() {
    show();
    EXPECT_TRUE(test::waitUntilExposed(*this));
  }
};

TEST(TextFit, FindsTextsThatHaveLessRoomThanTheyNeed) {
  auto* wrapped = new QLabel(kText);
  wrapped->setWordWrap(true);
  auto* tabs = new QTabBar;
  tabs->addTab(kText);
  tabs->setElideMode(Qt::ElideRight);
  auto* table = new QTableWidget(1, 1);
  table->setHorizontalHeaderLabels({kText});
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  const struct {
    QWidget* part;
    QSize enough;
    QSize too_little;
  } cases[] = {{new QLabel(kText), {800, 300}, {60, 300}},
               {new QPushButton(kText), {800, 300}, {60, 300}},
               {tabs, {800, 300}, {60, 300}},
               {table, {800, 300}, {150, 300}},
               {wrapped, {120, 300}, {120, 10}}};
  for (const auto& [part, enough, too_little] : cases) {
    Window window(1000, 400);
    part->setParent(&window);
    part->resize(enough);
    window.appear();
    EXPECT_EQ(findCutTexts(window), QStringList()) << part->metaObject()->className();
    part->resize(too_little);
    test::letTurnsPass();
    EXPECT_FALSE(findCutTexts(window).filter(kText).isEmpty()) << part->metaObject()->className();
  }
}

TEST(TextFit, FindsWhatHangsOverAnEdgeUnlessItScrolls) {
  Window window(900, 300);
  auto* part = new QWidget(&window);
  auto* label = new QLabel(kText, part);
  part->setGeometry(0, 0, 500, 200);
  label->move(450, 0);
  label->adjustSize();
  window.appear();
  EXPECT_EQ(findCutTexts(window).filter(kText).size(), 1);
  label->move(0, 0);
  EXPECT_EQ(findCutTexts(window), QStringList());

  QScrollArea area;
  auto* inner = new QWidget;
  inner->resize(2000, 100);
  auto* far_out = new QLabel(kText, inner);
  far_out->move(1500, 10);
  area.setWidget(inner);
  area.resize(300, 200);
  area.show();
  ASSERT_TRUE(test::waitUntilExposed(area));
  EXPECT_EQ(findCutTexts(area), QStringList());
}

TEST(TextFit, BelievesAPartThatDrawsItself) {
  Window window(100, 100);
  auto* part = new QWidget(&window);
  part->resize(50, 50);
  window.appear();
  EXPECT_EQ(findCutTexts(window), QStringList());
  part->setProperty("textIsCut", true);
  EXPECT_EQ(findCutTexts(window).size(), 1);
}

TEST(TextFit, FindsTextsThatLieOverEachOtherAndNoOthers) {
  Window window(400, 200);
  auto* one = new QLabel(kText, &window);
  auto* other = new QPushButton(QStringLiteral("Another"), &window);
  one->setGeometry(10, 10, 200, 30);
  other->setGeometry(10, 60, 200, 30);
  window.appear();
  EXPECT_EQ(findOverlaps(window), QStringList());
  other->move(100, 30);
  EXPECT_EQ(findOverlaps(window).size(), 1);
  other->hide();
  EXPECT_EQ(findOverlaps(window), QStringList());
}

TEST(TextFit, FindsWhatScrollsSideways) {
  Window window(500, 300);
  auto* area = new QScrollArea(&window);
  area->setObjectName(QStringLiteral("area"));
  area->resize(400, 200);
  auto* inner = new QWidget;
  inner->resize(200, 100);
  area->setWidget(inner);
  window.appear();
  EXPECT_EQ(findSidewaysScrolling(window), QStringList());
  inner->resize(900, 100);
  test::letTurnsPass();
  EXPECT_EQ(findSidewaysScrolling(window), QStringList({QStringLiteral("area")}));
}

/// The real window, in both languages, at the smallest size that it must be usable in.
class NothingIsCutOff : public WindowTest, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    installTranslations(*qApp, QLatin1String(GetParam()));
    WindowTest::SetUp();
  }
  void TearDown() override {
    window_.reset();
    installTranslations(*qApp, QStringLiteral("en"));
  }
};

TEST_P(NothingIsCutOff, AnywhereOnATourThroughTheDemo) {
  const QDir folder(QStringLiteral(HEXODERM_SCREENSHOTS "/tour"));
  // Only what this tour pictures is counted.
  const QStringList kept{QString::fromLatin1(GetParam()) + QStringLiteral("-*.png")};
  for (const QString& earlier : folder.entryList(kept)) ASSERT_TRUE(QFile::remove(folder.filePath(earlier)));
  const QStringList problems = ScreenshotTour(*window_, folder, QString::fromLatin1(GetParam())).run(QSize(1280, 800));
  for (const QString& problem : problems) ADD_FAILURE() << problem.toStdString();
  EXPECT_GE(QDir(folder.path()).entryList(kept).size(), 12);
}

INSTANTIATE_TEST_SUITE_P(Languages, NothingIsCutOff, testing::Values("en", "de"),
                         [](const auto& language) { return std::string(language.param); });

int exitCodeOf(const char* path, const QStringList& arguments) {
  QProcess program;
  program.start(QString::fromLocal8Bit(path), arguments);
  EXPECT_TRUE(program.waitForFinished(test::kPatience_ms)) << path;
  return program.exitCode();
}

TEST(ScreenshotTour, IsAProgramThatRefusesArgumentsThatMakeNoSense) {
  const QTemporaryDir folder;
  EXPECT_EQ(exitCodeOf(HEXODERM_SCREENSHOTS_PROGRAM, {QStringLiteral("--size=nonsense"), folder.path()}), 2);
  EXPECT_EQ(exitCodeOf(HEXODERM_SCREENSHOTS_PROGRAM, {QStringLiteral("--theme=pink"), folder.path()}), 2);
  EXPECT_EQ(exitCodeOf(HEXODERM_SCREENSHOTS_PROGRAM, {}), 2);
  EXPECT_EQ(exitCodeOf(HEXODERM_PROGRAM, {QStringLiteral("--screenshots"), folder.path()}), 1) << "not of the shipped";
}

}  // namespace
}  // namespace hexoderm
