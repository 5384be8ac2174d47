#include "hexoderm/base/error.h"
#include "tests/app/window/presenters/presenter_test.h"

namespace hexoderm {
namespace {

class HistoryPresenterTest : public PresenterTest {
 protected:
  QToolButton* recentButton(const QString& file_name) {
    for (auto* button : window_->findChildren<QToolButton*>("recentOpen")) {
      if (button->isVisible() && QFileInfo(button->property("recentPath").toString()).fileName() == file_name) {
        return button;
      }
    }
    return nullptr;
  }
};

TEST_F(HistoryPresenterTest, RemembersRecentFilesAcrossStarts) {
  const QString first = writeSession(pathTo("first.hexo"), 2);
  const QString second = writeSession(pathTo("second.hexo"), 3);
  ASSERT_NO_FATAL_FAILURE(openFile(first));
  ASSERT_NO_FATAL_FAILURE(openFile(second));
  reopenWindow();
  ASSERT_EQ(window_->recentFiles().files().size(), 2U);
  EXPECT_EQ(window_->recentFiles().files()[0].title, "second.hexo");
  EXPECT_EQ(window_->recentFiles().files()[0].poses, 3);
  EXPECT_TRUE(describeRecent(window_->recentFiles().files()[0]).contains("3 poses"));
  QMenu* menu = window_->actions().recent;
  ASSERT_GE(menu->actions().size(), 2);
  EXPECT_TRUE(menu->actions()[1]->text().contains("first.hexo"));
  menu->actions()[1]->trigger();
  ASSERT_TRUE(waitForPoses(2));
  EXPECT_EQ(controller().file().name(), "first.hexo");
  EXPECT_EQ(window_->recentFiles().files()[0].title, "first.hexo");
}

TEST_F(HistoryPresenterTest, ARecentFileWithALongNameLeavesTheStepsNarrow) {
  const QString name = QStringLiteral("left-forearm-of-the-second-robot-").repeated(3) + ".hexo";
  ASSERT_NO_FATAL_FAILURE(openFile(writeSession(pathTo(name), 2)));
  reopenWindow();
  press(Qt::Key_1, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([&] { return recentButton(name); }));
  test::letTurnsPass();
  EXPECT_LT(find<QWidget>("stepsDock")->width(), window_->width() / 3);
  keepPicture(window_->picture(), "recent-step-light");
}

TEST_F(HistoryPresenterTest, ARecentFileThatIsGoneSaysSoAndLeavesTheListByDel) {
  const QString gone = writeSession(pathTo("gone.hexo"), 1);
  const QString there = writeSession(pathTo("there.hexo"), 1);
  window_->recentFiles().note(there, 1);
  window_->recentFiles().note(gone, 1);
  ASSERT_TRUE(QFile::remove(gone));
  reopenWindow();
  ASSERT_TRUE(waitUntil([&] { return !window_->recentFiles().files()[0].problem.isEmpty(); }));
  QToolButton* button = recentButton("gone.hexo");
  ASSERT_NE(button, nullptr);
  EXPECT_TRUE(button->accessibleDescription().contains("not there"));
  EXPECT_TRUE(waitUntil([&] { return !window_->actions().recent->actions()[0]->isEnabled(); }));
  click(button);
  EXPECT_TRUE(controller().work().activity().isEmpty()) << "nothing to open";
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Delete);
  EXPECT_EQ(window_->recentFiles().files().size(), 1U);
  QToolButton* other = recentButton("there.hexo");
  ASSERT_NE(other, nullptr);
  EXPECT_TRUE(other->hasFocus());
  QTest::keyClick(other, Qt::Key_Return);
  ASSERT_TRUE(waitForPoses(1));
}

TEST_F(HistoryPresenterTest, TheMenuOfRecentFilesIsClearedFromWithin) {
  window_->recentFiles().note(pathTo("a.hexo"), 1);
  QMenu* menu = window_->actions().recent;
  menu->popup(window_->mapToGlobal(QPoint(100, 100)));
  ASSERT_TRUE(waitUntil([&] { return menu->isVisible() && menu->actions().size() == 3; }));
  QTest::mouseClick(menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(menu->actions().back()).center());
  EXPECT_TRUE(window_->recentFiles().files().empty());
  EXPECT_TRUE(waitUntil([&] { return menu->actions().size() == 2; }));
}

TEST_F(HistoryPresenterTest, KeepsTenRecentFilesAtMost) {
  for (int k = 0; k < 14; ++k) window_->recentFiles().note(pathTo(QStringLiteral("%1.hexo").arg(k)), k);
  window_->recentFiles().note(pathTo("9.hexo"), -1);
  ASSERT_EQ(window_->recentFiles().files().size(), RecentFiles::kMax);
  EXPECT_EQ(window_->recentFiles().files()[0].title, "9.hexo");
  EXPECT_EQ(window_->recentFiles().files()[0].poses, 9) << "what was known stays";
}

TEST_F(HistoryPresenterTest, FindsUnsavedSessionsThatNobodyHasOpen) {
  const QString folder = pathTo("unsaved");
  const QString left = writeSession(folder + "/left.hexo", 3);
  writeSession(folder + "/empty.hexo", 0);
  const QString in_use = writeSession(folder + "/used.hexo", 2);
  writeFile("unsaved/broken.hexo", "no session");
  const SessionStore user = SessionStore::open(in_use.toStdString());
  const std::vector<UnsavedSession> found = findUnsavedSessions(folder);
  ASSERT_EQ(found.size(), 2U);
  const auto& whole = found[0].problem.isEmpty() ? found[0] : found[1];
  const auto& broken = found[0].problem.isEmpty() ? found[1] : found[0];
  EXPECT_EQ(whole.path, left);
  EXPECT_EQ(whole.poses, 3U);
  EXPECT_EQ(whole.cells, 17U);
  EXPECT_TRUE(describeUnsaved(whole).contains("3 poses of 17 cells was not saved"));
  EXPECT_TRUE(broken.path.endsWith("broken.hexo"));
  EXPECT_TRUE(findUnsavedSessions(pathTo("no such folder")).empty());
}

TEST_F(HistoryPresenterTest, WhatIsDiscardedCanBeTakenBackForAWeek) {
  const QString folder = pathTo("unsaved");
  const QString path = writeSession(folder + "/left.hexo", 1);
  const QString discarded = discardUnsaved(path);
  EXPECT_FALSE(QFile::exists(path));
  EXPECT_TRUE(findUnsavedSessions(folder).empty());
  removeOldDiscarded(folder);
  EXPECT_TRUE(QFile::exists(discarded));
  EXPECT_EQ(restoreDiscarded(discarded), path);
  EXPECT_EQ(findUnsavedSessions(folder).size(), 1U);

  const QString again = discardUnsaved(path);
  {
    QFile file(again);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addDays(-8), QFileDevice::FileModificationTime));
  }
  removeOldDiscarded(folder);
  EXPECT_FALSE(QFile::exists(again));

  const QString in_use = writeSession(folder + "/used.hexo", 1);
  const SessionStore user = SessionStore::open(in_use.toStdString());
  EXPECT_THROW(discardUnsaved(in_use), Error);
  EXPECT_TRUE(QFile::exists(in_use));
}

TEST_F(HistoryPresenterTest, OffersAnUnsavedSessionAndRecoversIt) {
  writeSession(unsavedFolder() + "/one.hexo", 3);
  writeSession(unsavedFolder() + "/two.hexo", 2);
  reopenWindow();
  ASSERT_TRUE(waitUntil([&] { return visible<QPushButton>("recoverButton") != nullptr; }));
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  keepPicture(window_->picture(), "recovery-light");
  ASSERT_EQ(window_->unsavedSessions().all().size(), 2U);
  const std::size_t poses = window_->unsavedSessions().all()[0].poses;

  click(visible<QPushButton>("discardButton"));
  ASSERT_TRUE(waitUntil([&] { return visible<QPushButton>("undoDiscardButton") != nullptr; }));
  click(visible<QPushButton>("undoDiscardButton"));
  ASSERT_TRUE(waitUntil([&] { return visible<QPushButton>("undoDiscardButton") == nullptr; }));
  click(visible<QPushButton>("recoverButton"));
  ASSERT_TRUE(waitForPoses(poses));
  EXPECT_EQ(window_->unsavedSessions().all().size(), 1U);
  EXPECT_TRUE(window_->recentFiles().files().empty()) << "a scratch file is no recent file";
}

TEST_F(HistoryPresenterTest, AnUnsavedSessionStaysInTheListUntilItIsOpen) {
  writeSession(unsavedFolder() + "/one.hexo", 3);
  reopenWindow();
  ASSERT_TRUE(waitUntil([&] { return window_->unsavedSessions().all().size() == 1; }));
  const QString path = window_->unsavedSessions().all()[0].path;
  ASSERT_NO_FATAL_FAILURE(takeDemoPoses(1));

  window_->unsavedSessions().recover(path);
  auto* box = waitForDialog<QMessageBox>("unsavedBox");
  click(box->button(QMessageBox::Cancel));
  ASSERT_TRUE(waitUntilGone("unsavedBox"));
  EXPECT_EQ(window_->unsavedSessions().all().size(), 1U) << "nothing was opened";

  // It is not there for a moment: it can't be opened, and can be tried again.
  ASSERT_TRUE(QFile::rename(path, path + ".away"));
  window_->unsavedSessions().recover(path);
  box = waitForDialog<QMessageBox>("unsavedBox");
  click(box->button(QMessageBox::Discard));
  ASSERT_TRUE(waitForMessage("one.hexo"));
  EXPECT_EQ(window_->unsavedSessions().all().size(), 1U);
  ASSERT_TRUE(QFile::rename(path + ".away", path));
  ASSERT_TRUE(waitUntilGone("unsavedBox"));
  window_->unsavedSessions().recover(path);
  box = waitForDialog<QMessageBox>("unsavedBox");
  click(box->button(QMessageBox::Discard));
  ASSERT_TRUE(waitForPoses(3));
  EXPECT_TRUE(window_->unsavedSessions().all().empty());
}

TEST_F(HistoryPresenterTest, RecoversWhatAKilledProgramLeft) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  const QTemporaryDir home;
  environment.insert("XDG_CONFIG_HOME", home.path());
  environment.insert("XDG_DATA_HOME", home.path());
  process.setProcessEnvironment(environment);
  QSettings(home.filePath("Hexoderm/hexoderm.conf"), QSettings::IniFormat).setValue("demo/source", "sim:x17?speed=20");
  process.start(HEXODERM_PROGRAM, {"--demo", "--poses", "4"});
  ASSERT_TRUE(process.waitForStarted(test::kPatience_ms));
  // Until it has taken two poses that nobody has saved.
  const QString its_folder = home.filePath("Hexoderm/hexoderm/unsaved");
  QString scratch;
  ASSERT_TRUE(waitUntil([&] {
    const QStringList files = QDir(its_folder).entryList({"*.hexo"}, QDir::Files);
    if (files.isEmpty()) return false;
    scratch = QDir(its_folder).filePath(files.front());
    try {
      return readSessionStore(scratch.toStdString()).poses().size() >= 2;
    } catch (const Error&) {
      return false;  // it is being made
    }
  })) << process.readAllStandardError().toStdString();
  EXPECT_TRUE(isSessionStoreInUse(scratch.toStdString()));
  EXPECT_TRUE(findUnsavedSessions(its_folder).empty()) << "somebody works on it";
  process.kill();
  ASSERT_TRUE(process.waitForFinished(test::kPatience_ms));
  const std::vector<UnsavedSession> left = findUnsavedSessions(its_folder);
  ASSERT_EQ(left.size(), 1U);

  QDir().mkpath(unsavedFolder());
  for (const QFileInfo& file : QDir(its_folder).entryInfoList(QDir::Files)) {
    ASSERT_TRUE(QFile::copy(file.absoluteFilePath(), QDir(unsavedFolder()).filePath(file.fileName())));
  }
  reopenWindow();
  ASSERT_TRUE(waitUntil([&] { return visible<QPushButton>("recoverButton") != nullptr; }));
  activateWindow();
  click(visible<QPushButton>("recoverButton"));
  ASSERT_TRUE(waitForPoses(left[0].poses));
  EXPECT_TRUE(QFile::exists(QDir(unsavedFolder()).filePath(QFileInfo(scratch).fileName()))) << "until it is saved";
  EXPECT_FALSE(controller().file().isKept());
}

}  // namespace
}  // namespace hexoderm
