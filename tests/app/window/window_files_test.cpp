#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/session/simulated_session.h"
#include "tests/app/window/window_test.h"
#include "tests/support/paths.h"
#include "widgets/controls/finding_card.h"
#include "widgets/tables/finding_table.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QProcess>
#include <QToolButton>
#include <QUrl>
#include <algorithm>

namespace hexoderm {
namespace {

using WindowFilesTest = WindowTest;

/// Three cells in a row; cell 3 does not know that cell 2 sees it.
const QByteArray kSessionWithOneSidedLink = R"({"format": "hexoderm-session", "version": 1, "cell_model": "hex-bma150",
  "cells": [{"id": 1, "ports": [{"port": 1, "cell": 2, "cell_port": 4}]},
            {"id": 2, "ports": [{"port": 4, "cell": 1, "cell_port": 1}, {"port": 1, "cell": 3, "cell_port": 4}]},
            {"id": 3, "ports": []}],
  "poses": [{"id": 1, "label": "standing", "samples": [{"cell": 1, "mean_g": [0, 0, 1]},
             {"cell": 2, "mean_g": [0, 0.1, 0.99]}, {"cell": 3, "mean_g": [0, 0.2, 0.98]}]}]})";

void drop(QWidget* target, const QString& path) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  QDragEnterEvent enter(target->rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(target, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent event(target->rect().center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(target, &event);
}

TEST_F(WindowFilesTest, OpensADroppedSession) {
  drop(window_.get(), writeFile("row.session.json", kSessionWithOneSidedLink));
  ASSERT_TRUE(waitForPoses(1));
  EXPECT_EQ(controller().file().name(), "row.session.json");
  EXPECT_EQ(controller().reconstruction()->cellCount(), 3U);
  EXPECT_FALSE(action("actionCapture")->isEnabled());
  EXPECT_TRUE(action("actionCapture")->toolTip().contains("No skin is connected"));
  EXPECT_FALSE(controller().file().hasUnsavedChanges());
}

TEST_F(WindowFilesTest, AChangeOfThemeLeavesNothingBehind) {
  const QString path = writeFile("row.session.json", kSessionWithOneSidedLink);
  const auto openAtReview = [&] {
    window_->openFile(path);
    ASSERT_TRUE(waitForPoses(1));
    press(Qt::Key_4, Qt::ControlModifier);
    EXPECT_TRUE(std::ranges::any_of(window_->findChildren<FindingCard*>(), &QWidget::isVisible));
  };
  ASSERT_NO_FATAL_FAILURE(openAtReview());
  action("actionThemeDark")->trigger();
  const QImage changed = window_->picture();
  window_->close();
  openWindow();
  ASSERT_NO_FATAL_FAILURE(openAtReview());
  const QImage dark_from_the_start = window_->picture();
  keepPicture(changed, "theme-changed");
  keepPicture(dark_from_the_start, "theme-from-the-start");
  EXPECT_EQ(changed, dark_from_the_start);
}

TEST_F(WindowFilesTest, AClickOnAFindingPicksWhatItIsAbout) {
  window_->openFile(writeFile("row.session.json", kSessionWithOneSidedLink));
  ASSERT_TRUE(waitForPoses(1));
  const auto* findings = qobject_cast<FindingTable*>(find<QTableView>("findingView")->model());
  ASSERT_NE(findings, nullptr);
  bool seen_one_sided = false;
  for (int row = 0; row < findings->rowCount(); ++row) {
    const Finding& finding = findings->findingAt(row);
    if (finding.cells.empty()) continue;
    window_->selection().clear();
    clickRow("findingView", row);
    if (finding.code == FindingCode::OneSidedLink) {
      seen_one_sided = true;
      const Selection::Link link{{CellId(2), PortNumber(1)}, {CellId(3), PortNumber(4)}};
      EXPECT_TRUE(window_->selection().link() == link || window_->selection().cell() == CellId(2));
    } else {
      EXPECT_TRUE(window_->selection().cell() || window_->selection().link()) << finding.message.english();
    }
  }
  EXPECT_TRUE(seen_one_sided);
}

TEST_F(WindowFilesTest, ABadFileIsNamedAndNothingIsLost) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  controller().undoStack()->setClean();
  const QString bad = writeFile("broken.session.json", "{\"format\": \"hexoderm-session\", \"version\": 1,");
  drop(window_.get(), bad);
  ASSERT_TRUE(waitForMessage("broken.session.json")) << message().toStdString();
  EXPECT_EQ(controller().file().name(), "Demo skin (simulated)");
  EXPECT_EQ(posesShown(), 1U);
  keepPicture(window_->picture(), "message-light");

  window_->openFile(pathTo("missing.session.json"));
  ASSERT_TRUE(waitForMessage("missing.session.json")) << message().toStdString();
  press(Qt::Key_Space);
  EXPECT_TRUE(waitForPoses(2)) << "work goes on";
}

TEST_F(WindowFilesTest, SavesByKeysAndReopensTheSame) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  EXPECT_TRUE(window_->isWindowModified());
  press(Qt::Key_S, Qt::ControlModifier);
  const QString path = pathTo("mine.session.json");
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", path));
  ASSERT_TRUE(waitForMessage("Saved to " + path)) << message().toStdString();
  EXPECT_FALSE(controller().file().hasUnsavedChanges());
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_EQ(readSessionJson(path.toStdString()).poses().size(), 2U);

  // From now on Ctrl+S does not ask.
  clickRow("poseView", 0);
  press(Qt::Key_Delete);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_TRUE(controller().file().hasUnsavedChanges());
  press(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return !controller().file().hasUnsavedChanges(); }));
  EXPECT_TRUE(readSessionJson(path.toStdString()).poses()[0].disabled);

  press(Qt::Key_O, Qt::ControlModifier);
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("openDialog", path));
  ASSERT_TRUE(waitUntil([this] { return controller().session() && !controller().liveSession().isDemo(); }));
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_FALSE(controller().reconstruction()->poses[0].enabled);
}

TEST_F(WindowFilesTest, AKeyThatIsHitTwiceOpensOneDialogAndAClosedOneIsNotKept) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  press(Qt::Key_S, Qt::ControlModifier);
  press(Qt::Key_S, Qt::ControlModifier);
  auto* dialog = waitForDialog<QDialog>("saveDialog");
  ASSERT_NE(dialog, nullptr);
  EXPECT_EQ(window_->findChildren<QDialog*>("saveDialog").size(), 1);
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_TRUE(waitUntil([this] { return window_->findChildren<QDialog*>("saveDialog").isEmpty(); }));
  press(Qt::Key_S, Qt::ControlModifier);
  EXPECT_NE(waitForDialog<QDialog>("saveDialog"), nullptr) << "and another can be opened";
}

TEST_F(WindowFilesTest, TheButtonsOfAFileDialogHaveRoomForTheirPictures) {
  press(Qt::Key_O, Qt::ControlModifier);
  auto* dialog = waitForDialog<QDialog>("openDialog");
  ASSERT_NE(dialog, nullptr);
  const auto buttons = dialog->findChildren<QToolButton*>();
  ASSERT_FALSE(buttons.isEmpty());
  for (const QToolButton* button : buttons) {
    EXPECT_LE(button->sizeHint().width(), button->width()) << button->objectName().toStdString();
    EXPECT_LE(button->sizeHint().height(), button->height()) << button->objectName().toStdString();
  }
}

TEST_F(WindowFilesTest, AFailedSaveIsSaidAndTheWorkStaysUnsaved) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  controller().file().saveSession(pathTo("no/such/folder/a.session.json"));
  ASSERT_TRUE(waitForMessage("a.session.json")) << message().toStdString();
  EXPECT_TRUE(controller().file().hasUnsavedChanges());
}

TEST_F(WindowFilesTest, ACalibrationIsShownWithoutASession) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  const QString path = pathTo("arm.calibration.json");
  controller().resultFiles().exportTo({std::nullopt, path, {}});
  ASSERT_TRUE(waitForMessage("Exported to " + path)) << message().toStdString();
  controller().undoStack()->setClean();
  window_->openFile(path);
  ASSERT_TRUE(waitUntil([this] { return controller().file().name() == "arm.calibration.json"; }));
  EXPECT_EQ(controller().session(), nullptr);
  EXPECT_EQ(controller().reconstruction()->cellCount(), 17U);
  EXPECT_FALSE(action("actionSave")->isEnabled());
  EXPECT_TRUE(action("actionSave")->toolTip().contains("calibration is open"))
      << action("actionSave")->toolTip().toStdString();
  EXPECT_TRUE(action("actionExport")->isEnabled());
  clickRow("poseView", 0);
  EXPECT_FALSE(action("actionTogglePose")->isEnabled());
}

TEST_F(WindowFilesTest, ClosingAsksForUnsavedPosesAndEscapeGoesBack) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  press(Qt::Key_Q, Qt::ControlModifier);
  auto* box = waitForDialog<QMessageBox>("unsavedBox");
  ASSERT_NE(box, nullptr);
  QTest::keyClick(box, Qt::Key_Escape);
  ASSERT_TRUE(waitUntil([&] { return window_->findChild<QMessageBox*>("unsavedBox") == nullptr; }));
  EXPECT_TRUE(window_->isVisible());

  press(Qt::Key_Q, Qt::ControlModifier);
  box = waitForDialog<QMessageBox>("unsavedBox");
  ASSERT_NE(box, nullptr);
  click(box->button(QMessageBox::Discard));
  EXPECT_TRUE(waitUntil([&] { return !window_->isVisible(); }));
}

TEST_F(WindowFilesTest, ClosingCanSaveFirst) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  window_->close();
  auto* box = waitForDialog<QMessageBox>("unsavedBox");
  ASSERT_NE(box, nullptr);
  click(box->button(QMessageBox::Save));
  const QString path = pathTo("last.session.json");
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", path));
  EXPECT_TRUE(waitUntil([&] { return !window_->isVisible(); }));
  EXPECT_EQ(readSessionJson(path.toStdString()).poses().size(), 1U);
}

TEST_F(WindowFilesTest, AnotherFileAsksForUnsavedPosesToo) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  const QString path = writeFile("row.session.json", kSessionWithOneSidedLink);
  drop(window_.get(), path);
  auto* box = waitForDialog<QMessageBox>("unsavedBox");
  ASSERT_NE(box, nullptr);
  EXPECT_TRUE(controller().liveSession().isDemo());
  click(box->button(QMessageBox::Discard));
  ASSERT_TRUE(waitUntil([this] { return controller().file().name() == "row.session.json"; }));
  EXPECT_TRUE(waitForPoses(1));
}

/// The program as a user starts it.
struct Finished {
  int code = -1;
  QString errors;
};
Finished runProgram(const QStringList& arguments, const QString& demo_source = {}) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  const QTemporaryDir home;
  environment.insert("XDG_CONFIG_HOME", home.path());
  environment.insert("XDG_DATA_HOME", home.path());
  if (!demo_source.isEmpty()) {
    QSettings(home.filePath("Hexoderm/hexoderm.conf"), QSettings::IniFormat).setValue("demo/source", demo_source);
  }
  process.setProcessEnvironment(environment);
  process.start(QStringLiteral(HEXODERM_PROGRAM), arguments);
  if (!process.waitForFinished(test::kPatience_ms) || process.exitStatus() != QProcess::NormalExit) process.kill();
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          QString::fromUtf8(process.readAllStandardError())};
}

TEST(WindowProgram, PicturesTheDemo) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("demo.png");
  const Finished run = runProgram({"--demo", "--poses", "2", "--theme", "dark", "--screenshot", path});
  EXPECT_EQ(run.code, 0) << run.errors.toStdString();
  const QImage picture(path);
  ASSERT_FALSE(picture.isNull());
  EXPECT_LT(picture.pixelColor(3, picture.height() / 2).lightness(), 60);
}

TEST(WindowProgram, TheDemoTakesAsManyPosesAsItIsToldThoughFewerAreEnough) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("demo.png");
  const Finished run = runProgram({"--demo", "--poses", "8", "--screenshot", path}, "sim:x17?speed=20");
  EXPECT_EQ(run.code, 0) << run.errors.toStdString();
  EXPECT_FALSE(QImage(path).isNull());
}

TEST(WindowProgram, RefusesWhatItDoesNotUnderstand) {
  EXPECT_EQ(runProgram({"--demo", "a.session.json"}).code, 2);
  EXPECT_EQ(runProgram({"--theme", "pink"}).code, 2);
  EXPECT_EQ(runProgram({"--demo", "--poses", "many"}).code, 2);
  EXPECT_EQ(runProgram({"--screenshot", "a.png"}).code, 2);
  EXPECT_EQ(runProgram({"--version"}).code, 0);
  const QTemporaryDir folder;
  const Finished missing = runProgram({folder.filePath("none.session.json"), "--screenshot", folder.filePath("a.png")});
  EXPECT_EQ(missing.code, 3);
  EXPECT_TRUE(missing.errors.contains("none.session.json")) << missing.errors.toStdString();
}

TEST(WindowProgram, ThePictureReplacesNeitherTheFileThatIsShownNorASession) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("arm.session.json");
  SimulatedSkin skin(builtInCellModel("hex-bma150"), {});
  const Session session = simulateSession(skin, 2, 20);
  writeSessionJson(session, file.toStdString());
  const Finished same = runProgram({file, "--screenshot", folder.filePath("./arm.session.json")});
  EXPECT_EQ(same.code, 2);
  EXPECT_TRUE(same.errors.contains("is one of the inputs")) << same.errors.toStdString();
  EXPECT_NO_THROW(readSessionJson(file.toStdString()));
  const QString other = folder.filePath("other.png");
  writeSessionStore(session, other.toStdString());
  const Finished kept = runProgram({file, "--screenshot", other});
  EXPECT_EQ(kept.code, 5);
  EXPECT_TRUE(kept.errors.contains("as a Hexoderm session")) << kept.errors.toStdString();
  EXPECT_TRUE(isSessionStore(other.toStdString()));
}

}  // namespace
}  // namespace hexoderm
