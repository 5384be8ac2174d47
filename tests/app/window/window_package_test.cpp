// A package by the export dialog: what is said before and after, what is in it, and that a cancelled or failed one
// leaves nothing.

#include "hexoderm/io/calibration_json.h"
#include "tests/app/window/keyboard.h"
#include "tests/support/failing_disk.h"

#include <future>

namespace hexoderm {
namespace {

class WindowPackageTest : public KeyboardTest {
 protected:
  void SetUp() override {
    KeyboardTest::SetUp();
    ASSERT_NO_FATAL_FAILURE(openSession("arm.hexo", simulated(4)));
  }
  static void choosePackage(QDialog* dialog) { dialog->findChild<QTabBar*>("exportKinds")->setCurrentIndex(1); }
  static void tick(QDialog* dialog, const QStringList& names) {
    auto* list = dialog->findChild<QListWidget*>("packageFormats");
    for (int k = 0; k < list->count(); ++k) {
      list->item(k)->setCheckState(names.contains(list->item(k)->text()) ? Qt::Checked : Qt::Unchecked);
    }
  }
  static QStringList ticked(QDialog* dialog) {
    QStringList names;
    const auto* list = dialog->findChild<QListWidget*>("packageFormats");
    for (int k = 0; k < list->count(); ++k) {
      if (list->item(k)->checkState() == Qt::Checked) names << list->item(k)->text();
    }
    return names;
  }
  /// Ticks the files, and starts to write them.
  void exportPackage(const QStringList& names, const QString& path) {
    QDialog* dialog = openExportDialog();
    choosePackage(dialog);
    tick(dialog, names);
    auto* edit = dialog->findChild<QLineEdit*>("exportPath");
    edit->setFocus();
    typeInto(edit, path);
    auto* button = dialog->findChild<QPushButton*>("exportButton");
    ASSERT_TRUE(button->isEnabled()) << dialog->findChild<QLabel*>("exportNote")->text().toStdString();
    click(button);
    ASSERT_TRUE(waitUntilGone("exportDialog"));
  }
  void sayNoTitle() { click(waitForDialog("reportTitleDialog")->findChild<QPushButton*>("reportTitleButton")); }
  QDialog* waitUntilWritten() {
    auto* dialog = waitForDialog("packageDialog");
    const auto* files = dialog->findChild<QTreeWidget*>("packageFiles");
    EXPECT_TRUE(waitUntil([&] { return files->topLevelItemCount() > 0; }));
    return dialog;
  }
  [[nodiscard]] QStringList filesIn(const QString& folder) const {
    return QDir(pathTo(folder)).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
  }
};

TEST_F(WindowPackageTest, IsPreviewedWrittenAndListed) {
  QDialog* dialog = openExportDialog();
  choosePackage(dialog);
  tick(dialog, {"URDF", "Calibration"});
  EXPECT_THAT(dialog->findChild<QTextBrowser*>("packagePreview")->toPlainText(),
              HasTexts({"skin.urdf", "its place on the robot is not known", "A URDF holds no uncertainties.",
                        "skin.calibration.json", "manifest.json"}));
  QTest::keyClick(dialog, Qt::Key_Escape);
  ASSERT_TRUE(waitUntilGone("exportDialog"));

  ASSERT_NO_FATAL_FAILURE(exportPackage({"Report, PDF", "URDF", "Calibration"}, pathTo("out")));
  ASSERT_NO_FATAL_FAILURE(sayNoTitle());
  QDialog* written = waitUntilWritten();
  EXPECT_EQ(written->findChild<QTreeWidget*>("packageFiles")->topLevelItemCount(), 4);
  const QString sentence = written->findChild<QLabel*>("packageSentence")->text();
  EXPECT_THAT(sentence, HasText("4 files. Each was read back"));
  EXPECT_EQ(filesIn("out"), QStringList({"manifest.json", "report.pdf", "skin.calibration.json", "skin.urdf"}));
  EXPECT_EQ(readCalibrationJson(pathTo("out/skin.calibration.json").toStdString())->cellCount(), 17U);
  EXPECT_TRUE(contentOf(pathTo("out/report.pdf")).startsWith("%PDF"));
  keepPicture(written->grab().toImage(), "package-written");
}

TEST_F(WindowPackageTest, ThatIsCancelledOrFindsAFullDiskLeavesNothing) {
  const QStringList before = filesIn(".");
  for (const char* name : {"out", "arm.zip"}) {
    // The thread for files is kept busy until the operator has pressed the button.
    std::promise<void> pressed;
    controller().resultFiles().savePicture(
        [&pressed] {
          pressed.get_future().wait();
          return true;
        },
        "busy");
    ASSERT_NO_FATAL_FAILURE(exportPackage({"CSV", "PLY", "URDF"}, pathTo(name)));
    auto* writing = waitForDialog("packageDialog");
    click(writing->findChild<QPushButton*>("packageCancel"));
    EXPECT_EQ(writing->findChild<QLabel*>("packageSentence")->text(), "Cancelling …");
    pressed.set_value();
    ASSERT_TRUE(waitUntilGone("packageDialog"));
    EXPECT_FALSE(controller().work().isWriting());
    EXPECT_EQ(filesIn("."), before) << name;
  }
  const test::NoFileGrows full;
  ASSERT_NO_FATAL_FAILURE(exportPackage({"CSV", "PLY"}, pathTo("arm.zip")));
  auto* writing = waitForDialog("packageDialog");
  const auto* sentence = writing->findChild<QLabel*>("packageSentence");
  ASSERT_TRUE(waitUntil([&] { return sentence->text().startsWith("Nothing was written."); }))
      << sentence->text().toStdString();
  QTest::keyClick(writing, Qt::Key_Escape);
  ASSERT_TRUE(waitUntilGone("packageDialog"));
  EXPECT_EQ(filesIn("."), before);
}

TEST_F(WindowPackageTest, RemembersWhatWasChosen) {
  ASSERT_NO_FATAL_FAILURE(exportPackage({"PLY", "TF-YAML"}, pathTo("arm.zip")));
  QDialog* written = waitUntilWritten();
  QTest::keyClick(written, Qt::Key_Escape);
  ASSERT_TRUE(waitUntilGone("packageDialog"));
  QDialog* dialog = openExportDialog();
  EXPECT_EQ(dialog->findChild<QTabBar*>("exportKinds")->currentIndex(), 1);
  EXPECT_EQ(ticked(dialog), QStringList({"PLY", "TF-YAML"}));
  EXPECT_EQ(dialog->findChild<QComboBox*>("exportContainer")->currentText(), "Zip archive");
  EXPECT_TRUE(dialog->findChild<QLineEdit*>("exportPath")->text().endsWith(".zip"));
  dialog->findChild<QTabBar*>("exportKinds")->setCurrentIndex(0);
  EXPECT_TRUE(dialog->findChild<QLineEdit*>("exportPath")->text().endsWith(".calibration.json"));
  click(dialog->findChild<QPushButton*>("exportButton"));
  ASSERT_TRUE(waitForMessage("Exported to "));
  dialog = openExportDialog();
  EXPECT_EQ(dialog->findChild<QTabBar*>("exportKinds")->currentIndex(), 0);
}

TEST_F(WindowPackageTest, IsMadeByTheKeyboardAlone) {
  QDialog* dialog = openExportDialog();
  const auto* button = dialog->findChild<QPushButton*>("exportButton");
  ASSERT_NO_FATAL_FAILURE(tabTo("exportKinds"));
  key(Qt::Key_Right);
  ASSERT_NO_FATAL_FAILURE(tabTo("packageFormats"));
  tick(dialog, {});
  EXPECT_FALSE(button->isEnabled()) << "a package of nothing";
  key(Qt::Key_End);
  key(Qt::Key_Space);
  EXPECT_EQ(ticked(dialog), QStringList("MJCF"));
  ASSERT_NO_FATAL_FAILURE(tabTo("exportContainer"));
  key(Qt::Key_Down);
  EXPECT_TRUE(dialog->findChild<QLineEdit*>("exportPath")->text().endsWith("arm.zip"));
  ASSERT_NO_FATAL_FAILURE(tabTo("packagePreview"));
  ASSERT_NO_FATAL_FAILURE(tabTo("exportPath"));
  key(Qt::Key_Return);
  waitUntilWritten();
  EXPECT_TRUE(QFile::exists(pathTo("arm.zip")));
}

}  // namespace
}  // namespace hexoderm
