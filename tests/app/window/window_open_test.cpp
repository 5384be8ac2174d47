// Opening each kind of file, whole and in every way broken: a message names the file and the place in it, and what was
// open stays as it was.

#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/session/simulated_session.h"
#include "tests/app/window/recorded_skin.h"
#include "tests/app/window/window_test.h"
#include "tests/support/paths.h"

#include <QComboBox>
#include <functional>

namespace hexoderm {
namespace {

class WindowOpenTest : public WindowTest {
 protected:
  static Session simulated(std::size_t poses = 3) {
    SimulatedSkin skin(builtInCellModel("hex-bma150"), {});
    return simulateSession(skin, poses, 20);
  }
  QString writeStore(const QString& name, std::size_t poses = 3) {
    writeSessionStore(simulated(poses), pathTo(name).toStdString());
    return pathTo(name);
  }
  static QByteArray contentOf(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
  }
  /// By the dialog of Ctrl+O.
  void openByKeys(const QString& path) {
    press(Qt::Key_O, Qt::ControlModifier);
    ASSERT_NO_FATAL_FAILURE(typeIntoFileDialog("openDialog", path));
  }
  bool waitForName(const QString& name) {
    return waitUntil([&] { return controller().file().name() == name; }) && waitUntilIdle();
  }
};

TEST_F(WindowOpenTest, SessionsOfBothKindsCalibrationsAndTumFilesOpenByTheSameKeys) {
  const Session session = simulated();
  writeSessionJson(session, pathTo("a.session.json").toStdString());
  writeSessionStore(session, pathTo("b.hexo").toStdString());
  ASSERT_NO_FATAL_FAILURE(openByKeys(pathTo("a.session.json")));
  ASSERT_TRUE(waitForName("a.session.json")) << message().toStdString();
  EXPECT_EQ(posesShown(), 3U);
  EXPECT_FALSE(controller().file().isKept());
  ASSERT_NO_FATAL_FAILURE(openByKeys(pathTo("b.hexo")));
  ASSERT_TRUE(waitForName("b.hexo")) << message().toStdString();
  EXPECT_EQ(posesShown(), 3U);
  EXPECT_TRUE(controller().file().isKept()) << "a session store keeps every change";
  writeCalibrationJson(*controller().reconstruction(), pathTo("c.calibration.json").toStdString());
  ASSERT_NO_FATAL_FAILURE(openByKeys(pathTo("c.calibration.json")));
  ASSERT_TRUE(waitForName("c.calibration.json")) << message().toStdString();
  EXPECT_EQ(controller().session(), nullptr);
  EXPECT_EQ(controller().reconstruction()->cellCount(), 17U);
  ASSERT_NO_FATAL_FAILURE(openByKeys(QStringLiteral(HEXODERM_TEST_DATA "/two_patches.tum.xml")));
  ASSERT_TRUE(waitForName("two_patches.tum.xml")) << message().toStdString();
  EXPECT_EQ(controller().reconstruction()->patches.size(), 2U);
  EXPECT_FALSE(find<QWidget>("messageBar")->isVisible()) << message().toStdString();
}

TEST_F(WindowOpenTest, AFileIsKnownByWhatIsInItAndNotByItsName) {
  writeSessionJson(simulated(), pathTo("misnamed.xml").toStdString());
  window_->openFile(pathTo("misnamed.xml"));
  ASSERT_TRUE(waitForName("misnamed.xml")) << message().toStdString();
  EXPECT_EQ(posesShown(), 3U);
}

TEST_F(WindowOpenTest, ARecordingIsPlayedByTheDialogThatConnects) {
  const QString path = pathTo("arm.skinrec");
  ASSERT_NO_FATAL_FAILURE(recordSkin("sim:x17?speed=20", path.toStdString(), 3000));
  press(Qt::Key_K, Qt::ControlModifier);
  auto* dialog = waitForDialog<QDialog>("connectDialog");
  ASSERT_NE(dialog, nullptr);
  dialog->findChild<QComboBox*>("connectKind")->setCurrentText("Recording");
  auto* address = dialog->findChild<QComboBox*>("connectAddress")->lineEdit();
  address->selectAll();
  QTest::keyClicks(address, pathTo("no.skinrec"));
  auto* button = dialog->findChild<QPushButton*>("connectButton");
  EXPECT_FALSE(button->isEnabled());
  EXPECT_TRUE(dialog->findChild<QLabel*>("connectNote")->text().contains("no.skinrec"));
  address->selectAll();
  QTest::keyClicks(address, path + "?speed=max");
  ASSERT_TRUE(button->isEnabled()) << dialog->findChild<QLabel*>("connectNote")->text().toStdString();
  click(button);
  ASSERT_TRUE(waitForPoses(1)) << message().toStdString();
  ASSERT_TRUE(waitUntil([this] { return find<QLabel>("liveText")->text().contains("recording is over"); }))
      << find<QLabel>("liveText")->text().toStdString();
  EXPECT_EQ(controller().reconstruction()->cellCount(), 17U);
}

TEST_F(WindowOpenTest, ARecordingThatIsOpenedAsAFileSaysWhereItBelongs) {
  window_->openFile(writeFile("arm.skinrec", QByteArray("SKINREC1") + QByteArray(100, '\0')));
  ASSERT_TRUE(waitForMessage("arm.skinrec")) << message().toStdString();
  EXPECT_TRUE(message().contains("connect", Qt::CaseInsensitive)) << message().toStdString();
}

/// A way of breaking a file, and the words that its message must have beside the file's name.
struct Broken {
  const char* name;
  const char* file;
  std::function<QByteArray(WindowOpenTest&)> content;
  QStringList said;
};
void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }

class WindowBrokenFileTest : public WindowOpenTest, public testing::WithParamInterface<Broken> {
 public:
  QByteArray session() { return QByteArray::fromStdString(sessionToJson(simulated())); }
  QByteArray store() { return contentOf(writeStore("whole.hexo")); }
  QByteArray calibration() {
    const std::string path = pathTo("whole.calibration.json").toStdString();
    openAndWait(writeStore("for_calibration.hexo"));
    writeCalibrationJson(*controller().reconstruction(), path);
    return contentOf(QString::fromStdString(path));
  }
  static QByteArray tum() { return contentOf(QStringLiteral(HEXODERM_TEST_DATA "/two_patches.tum.xml")); }
  /// The store of a program of the future.
  QByteArray newerStore() {
    QByteArray content = contentOf(writeStore("newer.hexo"));
    constexpr int kUserVersion = 60;  // in the header of an SQLite file, big-endian
    content.replace(kUserVersion, 4, QByteArray("\0\0\0\x63", 4));
    return content;
  }

 private:
  void openAndWait(const QString& path) {
    window_->openFile(path);
    ASSERT_TRUE(waitForName(QFileInfo(path).fileName())) << message().toStdString();
  }
};

QByteArray replaced(QByteArray content, const char* what, const char* by) {
  const int at = content.indexOf(what);
  EXPECT_GE(at, 0) << what;
  return content.replace(at, static_cast<int>(qstrlen(what)), by);
}
QByteArray cut(const QByteArray& content) { return content.left(content.size() / 2); }

using Test = WindowBrokenFileTest;
const Broken kBroken[] = {
    {"EmptyFile", "b.session.json", [](WindowOpenTest&) { return QByteArray(); }, {"empty"}},
    {"NoneOfOurs",
     "b.session.json",
     [](WindowOpenTest&) { return QByteArray("\x89PNG\r\n\x1a\n"); },
     {"none of the files"}},
    {"OtherJson",
     "b.json",
     [](WindowOpenTest&) { return QByteArray(R"({"format": "urdf-as-json"})"); },
     {"urdf-as-json"}},
    {"TruncatedSession",
     "b.session.json",
     [](WindowOpenTest& t) { return cut(static_cast<Test&>(t).session()); },
     {"line"}},
    {"NewerSession",
     "b.session.json",
     [](WindowOpenTest& t) { return replaced(static_cast<Test&>(t).session(), "\"version\": 1", "\"version\": 7"); },
     {"7", "1"}},
    {"SessionOfWrongTypes",
     "b.session.json",
     [](WindowOpenTest& t) {
       return replaced(static_cast<Test&>(t).session(), "\"mean_g\": [", "\"mean_g\": [\"up\", ");
     },
     {"poses[0].samples[0].mean_g"}},
    {"SessionWithANumberThatIsNone",
     "b.session.json",
     [](WindowOpenTest& t) {
       return replaced(static_cast<Test&>(t).session(), "\"mean_g\": [", "\"mean_g\": [1e999, ");
     },
     {"poses[0].samples[0].mean_g[0]"}},
    {"SessionWithANegativeCount",
     "b.session.json",
     [](WindowOpenTest& t) { return replaced(static_cast<Test&>(t).session(), "\"count\": 20", "\"count\": -20"); },
     {"poses[0].samples[0].count"}},
    {"SessionWithACellOutOfRange",
     "b.session.json",
     [](WindowOpenTest& t) { return replaced(static_cast<Test&>(t).session(), "\"id\": 1", "\"id\": 4294967296"); },
     {"cells[0].id"}},
    {"TruncatedStore", "b.hexo", [](WindowOpenTest& t) { return cut(static_cast<Test&>(t).store()); }, {}},
    {"StoreOfNoise", "b.hexo", [](WindowOpenTest&) { return QByteArray(5000, '#'); }, {}},
    {"NewerStore", "b.hexo", [](WindowOpenTest& t) { return static_cast<Test&>(t).newerStore(); }, {"99"}},
    {"TruncatedCalibration",
     "b.calibration.json",
     [](WindowOpenTest& t) { return cut(static_cast<Test&>(t).calibration()); },
     {"line"}},
    {"NewerCalibration",
     "b.calibration.json",
     [](WindowOpenTest& t) {
       return replaced(static_cast<Test&>(t).calibration(), "\"version\": 2", "\"version\": 8");
     },
     {"8", "2"}},
    {"TruncatedTum", "b.xml", [](WindowOpenTest&) { return cut(Test::tum()); }, {"line"}},
    {"OtherXml", "b.xml", [](WindowOpenTest&) { return QByteArray("<robot name=\"arm\"/>"); }, {"robot"}},
};

TEST_P(WindowBrokenFileTest, IsNamedWithItsPlaceAndNothingIsLost) {
  const QByteArray content = GetParam().content(*this);
  const QString good = writeStore("open.hexo", 2);
  window_->openFile(good);
  ASSERT_TRUE(waitForName("open.hexo")) << message().toStdString();
  clickRow("poseView", 1);
  press(Qt::Key_Delete);
  ASSERT_TRUE(waitUntilIdle());
  const int undo_steps = controller().undoStack()->count();

  const QString path = writeFile(GetParam().file, content);
  ASSERT_NO_FATAL_FAILURE(openByKeys(path));
  ASSERT_TRUE(waitForMessage(GetParam().file)) << message().toStdString();
  for (const QString& part : GetParam().said) {
    EXPECT_TRUE(message().contains(part)) << part.toStdString() << " is not in: " << message().toStdString();
  }
  EXPECT_TRUE(find<QWidget>("messageBar")->isVisible()) << "it stays until somebody has read it";
  EXPECT_FALSE(message().contains('\n')) << "one line";
  EXPECT_EQ(contentOf(path), content) << "no file that was opened is changed";

  EXPECT_EQ(controller().file().name(), "open.hexo");
  EXPECT_EQ(posesShown(), 2U);
  EXPECT_TRUE(controller().session()->poses()[1].disabled);
  EXPECT_EQ(controller().undoStack()->count(), undo_steps);
  press(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_FALSE(controller().session()->poses()[1].disabled) << "the work goes on";
}

INSTANTIATE_TEST_SUITE_P(Files, WindowBrokenFileTest, testing::ValuesIn(kBroken),
                         [](const testing::TestParamInfo<Broken>& file) { return std::string(file.param.name); });

TEST_F(WindowOpenTest, AFileThatIsGoneAndAFolderAreSaid) {
  window_->openFile(pathTo("gone.hexo"));
  ASSERT_TRUE(waitForMessage("gone.hexo")) << message().toStdString();
  EXPECT_TRUE(controller().isEmpty());
  ASSERT_TRUE(QDir(folder_.path()).mkdir("folder.session.json"));
  window_->openFile(pathTo("folder.session.json"));
  ASSERT_TRUE(waitForMessage("folder.session.json")) << message().toStdString();
  EXPECT_TRUE(controller().isEmpty());
}

TEST_F(WindowOpenTest, ASessionThatIsOpenInTwoWindowsIsKeptByTheFirst) {
  const QString path = writeStore("shared.hexo");
  window_->openFile(path);
  ASSERT_TRUE(waitForName("shared.hexo")) << message().toStdString();
  ASSERT_TRUE(waitUntil([this] { return controller().file().isKept(); }));
  const std::unique_ptr<MainWindow> first = std::move(window_);

  openWindow();
  window_->openFile(path);
  ASSERT_TRUE(waitForPoses(3)) << message().toStdString();
  ASSERT_TRUE(waitForMessage("will not be kept in this file")) << message().toStdString();
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
