// Opening each kind of file, whole and in every way broken: a message names the file and the place in it, and what was
// open stays as it was.

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/app/window/window_test.h"

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
  clickRow("poseView", 1);
  press(Qt::Key_Delete);
  ASSERT_TRUE(waitUntilIdle());
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
  clickRow("poseView", 0);
  press(Qt::Key_Delete);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_TRUE(controller().file().hasUnsavedChanges()) << "what is done here must be saved elsewhere";
  EXPECT_FALSE(readSessionStore(path.toStdString()).poses()[0].disabled);
  EXPECT_FALSE(first->controller().session()->poses()[0].disabled);
  first->controller().removePose(2);
  ASSERT_TRUE(waitUntil([&] { return readSessionStore(path.toStdString()).poses().size() == 2; }))
      << "the first goes on";
}

}  // namespace
}  // namespace hexoderm
