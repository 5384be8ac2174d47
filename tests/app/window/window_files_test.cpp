// Opening each kind of file, whole and broken; saving; and the program as a user starts it.

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/app/window/window_test.h"
#include "widgets/patch/patch_view.h"

namespace hexoderm {
namespace {

class WindowOpenTest : public WindowTest {
 protected:
  /// By the dialog of Ctrl+O.
  void openByKeys(const QString& path) {
    press(Qt::Key_O, Qt::ControlModifier);
    ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("openDialog", path));
  }
  /// The same, to its result.
  void openAndWait(const QString& path) {
    ASSERT_NO_FATAL_FAILURE(openByKeys(path));
    const QString name = QFileInfo(path).fileName();
    ASSERT_TRUE(waitUntil([&] { return controller().file().name() == name; })) << name.toStdString();
    ASSERT_TRUE(waitUntilIdle());
  }
};

TEST_F(WindowOpenTest, SessionsOfBothKindsCalibrationsAndTumFilesOpenByTheSameKeysWhateverTheyAreCalled) {
  const Session session = simulated(3);
  writeSessionJson(session, pathTo("misnamed.xml").toStdString());
  ASSERT_NO_FATAL_FAILURE(openAndWait(pathTo("misnamed.xml")));
  EXPECT_EQ(posesShown(), 3U);
  EXPECT_FALSE(controller().file().isKept());

  ASSERT_NO_FATAL_FAILURE(openAndWait(writeSession("b.hexo", session)));
  EXPECT_EQ(posesShown(), 3U);
  EXPECT_TRUE(controller().file().isKept()) << "a session store keeps every change";

  writeCalibrationJson(*controller().reconstruction(), pathTo("c.calibration.json").toStdString());
  ASSERT_NO_FATAL_FAILURE(openAndWait(pathTo("c.calibration.json")));
  EXPECT_EQ(controller().session(), nullptr);
  EXPECT_EQ(controller().reconstruction()->cellCount(), 17U);
  expectDisabled("actionSave", "calibration is open");
  EXPECT_TRUE(action("actionExport")->isEnabled());
  clickRow("poseView", 0);
  EXPECT_FALSE(action("actionTogglePose")->isEnabled());

  ASSERT_NO_FATAL_FAILURE(openAndWait(HEXODERM_TEST_DATA "/two_patches.tum.xml"));
  EXPECT_EQ(controller().reconstruction()->patches.size(), 2U);
  EXPECT_FALSE(find<QWidget>("messageBar")->isVisible()) << message().toStdString();
}

// What is wrong within files is for the tests of their readers to find in full.
TEST_F(WindowOpenTest, ABrokenFileIsNamedWithItsPlaceAndNothingIsLost) {
  const Session session = simulated(3);
  QByteArray wrong_types = QByteArray::fromStdString(sessionToJson(session));
  wrong_types.replace("\"mean_g\": [", "\"mean_g\": [\"up\", ");
  const auto half = [](const QByteArray& content) { return content.left(content.size() / 2); };
  const struct {
    QString file;
    QByteArray content;
    QString said;  ///< beside the file's name
  } broken[] = {
      {"png.session.json", "\x89PNG\r\n\x1a\n", "none of the files"},
      {"types.session.json", wrong_types, "poses[0].samples[0].mean_g"},
      {"cut.hexo", half(contentOf(writeSession("whole.hexo", session))), {}},
      {"cut.calibration.json", half(QByteArray::fromStdString(calibrationToJson(*reconstruct(*session.snapshot())))),
       "line"},
      {"cut.xml", half(contentOf(HEXODERM_TEST_DATA "/two_patches.tum.xml")), "line"},
  };
  ASSERT_NO_FATAL_FAILURE(openSession("open.hexo", simulated(2)));
  ASSERT_NO_FATAL_FAILURE(disablePose(1));
  for (const auto& [file, content, said] : broken) {
    const QString path = writeFile(file, content);
    ASSERT_NO_FATAL_FAILURE(openByKeys(path));
    ASSERT_TRUE(waitForMessage(file));
    EXPECT_THAT(message(), HasText(said));
    EXPECT_TRUE(find<QWidget>("messageBar")->isVisible()) << "it stays until somebody has read it";
    EXPECT_FALSE(message().contains('\n')) << "one line";
    EXPECT_EQ(contentOf(path), content) << "no file that was opened is changed";
  }
  EXPECT_EQ(controller().file().name(), "open.hexo");
  EXPECT_EQ(posesShown(), 2U);
  EXPECT_EQ(controller().undoStack()->count(), 1);
  EXPECT_TRUE(controller().session()->poses()[1].disabled);
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_FALSE(controller().session()->poses()[1].disabled) << "the work goes on";
}

TEST_F(WindowOpenTest, AFileThatIsGoneAFolderAndARecordingAreSaid) {
  ASSERT_TRUE(QDir(folder_.path()).mkdir("folder.session.json"));
  writeFile("arm.skinrec", QByteArray("SKINREC1") + QByteArray(100, '\0'));
  for (const char* name : {"gone.hexo", "folder.session.json", "arm.skinrec"}) {
    window_->openFile(pathTo(name));
    ASSERT_TRUE(waitForMessage(name));
    EXPECT_TRUE(controller().isEmpty()) << name;
  }
  EXPECT_TRUE(message().contains("connect", Qt::CaseInsensitive)) << "where a recording belongs";
}

TEST_F(WindowOpenTest, ASessionThatIsOpenInTwoWindowsIsKeptByTheFirst) {
  const QString path = writeSession("shared.hexo", simulated(3));
  ASSERT_NO_FATAL_FAILURE(openFile(path));
  ASSERT_TRUE(waitUntil([this] { return controller().file().isKept(); }));
  const std::unique_ptr<MainWindow> first = std::move(window_);

  openWindow();
  window_->openFile(path);
  ASSERT_TRUE(waitForPoses(3));
  ASSERT_TRUE(waitForMessage("will not be kept in this file"));
  EXPECT_FALSE(controller().file().isKept());
  ASSERT_NO_FATAL_FAILURE(disablePose(0));
  EXPECT_TRUE(controller().file().hasUnsavedChanges()) << "what is done here must be saved elsewhere";
  EXPECT_FALSE(readSessionStore(path.toStdString()).poses()[0].disabled);
  EXPECT_FALSE(first->controller().session()->poses()[0].disabled);
  first->controller().removePose(2);
  ASSERT_TRUE(waitUntil([&] { return readSessionStore(path.toStdString()).poses().size() == 2; }))
      << "the first goes on";
}

using WindowFilesTest = WindowTest;

/// Three cells in a row; cell 3 does not know that cell 2 sees it.
const QByteArray kSessionWithOneSidedLink = R"({"format": "hexoderm-session", "version": 1, "cell_model": "hex-bma150",
  "cells": [{"id": 1, "ports": [{"port": 1, "cell": 2, "cell_port": 4}]},
            {"id": 2, "ports": [{"port": 4, "cell": 1, "cell_port": 1}, {"port": 1, "cell": 3, "cell_port": 4}]},
            {"id": 3, "ports": []}],
  "poses": [{"id": 1, "label": "standing", "samples": [{"cell": 1, "mean_g": [0, 0, 1]},
             {"cell": 2, "mean_g": [0, 0.1, 0.99]}, {"cell": 3, "mean_g": [0, 0.2, 0.98]}]}]})";

TEST_F(WindowFilesTest, ADroppedSessionIsOpened) {
  dropFile(writeFile("row.session.json", kSessionWithOneSidedLink));
  ASSERT_TRUE(waitForPoses(1));
  EXPECT_EQ(controller().file().name(), "row.session.json");
  EXPECT_EQ(controller().reconstruction()->cellCount(), 3U);
  expectDisabled("actionCapture", "No skin is connected");
  EXPECT_FALSE(controller().file().hasUnsavedChanges());
}

TEST_F(WindowFilesTest, SavesByKeysAndReopensTheSame) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(2));
  EXPECT_TRUE(window_->isWindowModified());
  press(Qt::Key_S, Qt::ControlModifier);
  const QString path = pathTo("mine.session.json");
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", path));
  ASSERT_TRUE(waitForMessage("Saved to " + path));
  EXPECT_FALSE(controller().file().hasUnsavedChanges());
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_EQ(readSessionJson(path.toStdString()).poses().size(), 2U);

  // From now on Ctrl+S does not ask.
  ASSERT_NO_FATAL_FAILURE(disablePose(0));
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

TEST_F(WindowFilesTest, AKeyThatIsHitTwiceOpensOneFileDialogInWhichButtonsHaveRoomAndAClosedOneIsNotKept) {
  press(Qt::Key_O, Qt::ControlModifier);
  press(Qt::Key_O, Qt::ControlModifier);
  auto* dialog = waitForDialog("openDialog");
  EXPECT_EQ(window_->findChildren<QDialog*>("openDialog").size(), 1);
  const auto buttons = dialog->findChildren<QToolButton*>();
  ASSERT_FALSE(buttons.isEmpty());
  for (const QToolButton* button : buttons) {
    EXPECT_LE(button->sizeHint().width(), button->width()) << button->objectName().toStdString();
    EXPECT_LE(button->sizeHint().height(), button->height()) << button->objectName().toStdString();
  }
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_TRUE(waitUntilGone("openDialog"));
  press(Qt::Key_O, Qt::ControlModifier);
  waitForDialog("openDialog");
}

TEST_F(WindowFilesTest, ClosingAsksForWhatAFailedSaveLeftUnsavedGoesBackByEscapeAndCanSaveFirst) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  controller().file().saveSession(pathTo("no/such/folder/a.session.json"));
  ASSERT_TRUE(waitForMessage("a.session.json"));
  EXPECT_TRUE(controller().file().hasUnsavedChanges());
  press(Qt::Key_Q, Qt::ControlModifier);
  QTest::keyClick(waitForDialog<QMessageBox>("unsavedBox"), Qt::Key_Escape);
  ASSERT_TRUE(waitUntilGone("unsavedBox"));
  EXPECT_TRUE(window_->isVisible());
  window_->close();
  click(waitForDialog<QMessageBox>("unsavedBox")->button(QMessageBox::Save));
  const QString path = pathTo("last.session.json");
  ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("saveDialog", path));
  EXPECT_TRUE(waitUntil([&] { return !window_->isVisible(); }));
  EXPECT_EQ(readSessionJson(path.toStdString()).poses().size(), 1U);
}

TEST_F(WindowFilesTest, AnotherFileAsksForUnsavedPosesTooAndBothCanDiscardThem) {
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));
  dropFile(writeFile("row.session.json", kSessionWithOneSidedLink));
  auto* box = waitForDialog<QMessageBox>("unsavedBox");
  EXPECT_TRUE(controller().liveSession().isDemo());
  click(box->button(QMessageBox::Discard));
  ASSERT_TRUE(waitUntil([this] { return controller().file().name() == "row.session.json"; }));
  ASSERT_TRUE(waitForPoses(1));
  ASSERT_TRUE(waitUntilGone("unsavedBox"));
  controller().setPoseDisabled(0, true);
  press(Qt::Key_Q, Qt::ControlModifier);
  click(waitForDialog<QMessageBox>("unsavedBox")->button(QMessageBox::Discard));
  EXPECT_TRUE(waitUntil([&] { return !window_->isVisible(); }));
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
  process.start(HEXODERM_PROGRAM, arguments);
  if (!process.waitForFinished(test::kPatience_ms) || process.exitStatus() != QProcess::NormalExit) process.kill();
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          QString::fromUtf8(process.readAllStandardError())};
}

TEST(WindowProgram, PicturesTheDemoWithAsManyPosesAsItIsToldThoughFewerAreEnough) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("demo.png");
  const Finished run =
      runProgram({"--demo", "--poses", "8", "--theme", "dark", "--screenshot", path}, "sim:x17?speed=20");
  EXPECT_EQ(run.code, 0) << run.errors.toStdString();
  const QImage picture(path);
  ASSERT_FALSE(picture.isNull());
  EXPECT_LT(picture.pixelColor(3, picture.height() / 2).lightness(), 60);
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
  EXPECT_THAT(missing.errors, HasText("none.session.json"));
}

TEST(WindowProgram, ThePictureReplacesNeitherTheFileThatIsShownNorASession) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("arm.session.json");
  SimulatedSkin skin(builtInCellModel("hex-bma150"), {});
  const Session session = simulateSession(skin, 2, 20);
  writeSessionJson(session, file.toStdString());
  const Finished same = runProgram({file, "--screenshot", folder.filePath("./arm.session.json")});
  EXPECT_EQ(same.code, 2);
  EXPECT_THAT(same.errors, HasText("is one of the inputs"));
  EXPECT_NO_THROW(readSessionJson(file.toStdString()));
  const QString other = folder.filePath("other.png");
  writeSessionStore(session, other.toStdString());
  const Finished kept = runProgram({file, "--screenshot", other});
  EXPECT_EQ(kept.code, 5);
  EXPECT_THAT(kept.errors, HasText("as a Hexoderm session"));
  EXPECT_TRUE(isSessionStore(other.toStdString()));
}

TEST_F(WindowFilesTest, AChangeOfThemeIsSeenBesideThePanelsAndInThe3DView) {
  window_->openFile(writeFile("row.session.json", kSessionWithOneSidedLink));
  ASSERT_TRUE(waitForPoses(1));
  // A corner of the 3D view, which draws when it has time and must be up to date all the same.
  const auto* patch = window_->findChild<PatchView*>();
  const QPoint in_patch = patch->mapTo(window_.get(), QPoint(patch->width() / 2, 6));
  const QPoint points[] = {QPoint(3, window_->height() / 2), in_patch};
  const QImage light = window_->picture();
  for (const QPoint& point : points) EXPECT_GT(light.pixelColor(point).lightness(), 200);
  action("actionThemeDark")->trigger();
  const QImage dark = window_->picture();
  for (const QPoint& point : points) EXPECT_LT(dark.pixelColor(point).lightness(), 60);
  window_->close();
  openWindow();
  EXPECT_TRUE(action("actionThemeDark")->isChecked());
}

}  // namespace
}  // namespace hexoderm
