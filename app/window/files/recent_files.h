#pragma once

#include "app/window/files/job_queue.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/words/formatting.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QList>
#include <QLocale>
#include <QMenu>
#include <QObject>
#include <QSettings>
#include <QString>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace hexoderm {

/// A session or calibration that was open lately.
struct RecentFile {
  QString path;
  QString title;           ///< the file's name
  std::int64_t at_ms = 0;  ///< when it was open last, milliseconds since 1970, UTC
  int poses = -1;          ///< -1: not known, as for a calibration
  QString problem;         ///< why it can't be opened; empty if nothing is known against it
};

/// "today, 14:32 · 3 poses".
inline QString describeRecent(const RecentFile& file);

/// The files that were open lately, the newest first, at most kMax; kept in the settings. Whether a file is still
/// there is looked up on another thread, as a folder on a network can be slow.
class RecentFiles : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kMax = 10;

  /// `jobs` must outlive this object.
  explicit RecentFiles(JobQueue& jobs, QObject* parent = nullptr) : QObject(parent), jobs_(jobs) {
    constexpr int kSoon_ms = 1500;
    setUpOnce(write_soon_, kSoon_ms, this, &RecentFiles::write);
    QSettings settings;
    const int count = settings.beginReadArray(kSetting);
    for (int k = 0; k < count && files_.size() < kMax; ++k) {
      settings.setArrayIndex(k);
      RecentFile file;
      file.path = settings.value(QStringLiteral("path")).toString();
      file.title = QFileInfo(file.path).fileName();
      file.at_ms = settings.value(QStringLiteral("at_ms")).toLongLong();
      file.poses = settings.value(QStringLiteral("poses"), -1).toInt();
      if (!file.title.isEmpty()) files_.push_back(std::move(file));
    }
    settings.endArray();
  }

  ~RecentFiles() override {
    if (write_soon_.isActive()) write();
  }

  [[nodiscard]] const std::vector<RecentFile>& files() const { return files_; }

  /// It is open now. Moves it to the top; `poses` of -1 keeps what was known.
  void note(const QString& path, int poses) {
    RecentFile file;
    file.path = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
    file.title = QFileInfo(path).fileName();
    file.at_ms = QDateTime::currentMSecsSinceEpoch();
    file.poses = poses;
    const auto known = std::ranges::find(files_, file.path, &RecentFile::path);
    if (known != files_.end()) {
      if (poses < 0) file.poses = known->poses;
      files_.erase(known);
    }
    files_.insert(files_.begin(), std::move(file));
    if (files_.size() > kMax) files_.resize(kMax);
    changeFiles();
  }

  void remove(const QString& path) {
    if (std::erase_if(files_, [&](const RecentFile& file) { return file.path == path; }) > 0) changeFiles();
  }

  void clear() {
    files_.clear();
    changeFiles();
  }

  /// Looks again which files are there; changed() follows if that is news.
  void check() {
    std::vector<QString> paths;
    for (const RecentFile& file : files_) paths.push_back(file.path);
    jobs_.addFor(this, [paths = std::move(paths)] {
      std::map<QString, QString> problems;
      for (const QString& path : paths) problems[path] = problemWith(path);
      return [problems = std::move(problems)](RecentFiles& self) {
        bool news = false;
        for (RecentFile& file : self.files_) {
          const auto found = problems.find(file.path);
          if (found != problems.end() && std::exchange(file.problem, found->second) != found->second) news = true;
        }
        if (news) emit self.changed();
      };
    });
  }

  /// Fills a menu each time it is about to show; `open` is called with the path that was chosen.
  void serve(QMenu* menu, std::function<void(QString)> open) {
    menu->setToolTipsVisible(true);
    const auto fill = [this, menu, open = std::move(open)] {
      menu->clear();
      int number = 0;
      for (const RecentFile& file : files_) {
        QString title = file.title;
        title.replace(QLatin1Char('&'), QStringLiteral("&&"));
        QAction* action = menu->addAction(QStringLiteral("&%1  %2").arg(++number % 10).arg(title));
        action->setEnabled(file.problem.isEmpty());
        action->setToolTip(QStringLiteral("%1\n%2").arg(describeRecent(file), QDir::toNativeSeparators(file.path)));
        action->setStatusTip(describeRecent(file));
        connect(action, &QAction::triggered, this, [open, path = file.path] { open(path); });
      }
      menu->addSeparator();
      QAction* clean = menu->addAction(files_.empty() ? tr("Nothing was open yet") : tr("Clear this list"));
      clean->setEnabled(!files_.empty());
      clean->setToolTip(tr("Takes all files from this list; the files themselves stay"));
      connect(clean, &QAction::triggered, this, &RecentFiles::clear);
    };
    connect(menu, &QMenu::aboutToShow, this, &RecentFiles::check);
    connect(menu, &QMenu::aboutToShow, menu, fill);
    // Not while it is shown, nor while one of its actions is at work, which would go.
    connect(
        this, &RecentFiles::changed, menu,
        [menu, fill] {
          if (!menu->isVisible()) fill();
        },
        Qt::QueuedConnection);
    fill();
  }

 signals:
  void changed();

 private:
  static inline const QString kSetting = QStringLiteral("recent/files");

  static QString problemWith(const QString& path) {
    const QFileInfo file(path);
    if (!file.exists()) {
      return QDir(file.absolutePath()).exists() ? RecentFiles::tr("The file is not there any more")
                                                : RecentFiles::tr("Its folder is not there: removed, or not connected");
    }
    if (!file.isReadable()) return RecentFiles::tr("You may not read this file");
    return {};
  }

  void changeFiles() {
    // Settings wait for the disk; a row of poses makes it wait once.
    write_soon_.start();
    emit changed();
  }

  void write() {
    QSettings settings;
    settings.remove(kSetting);
    settings.beginWriteArray(kSetting, static_cast<int>(files_.size()));
    for (std::size_t k = 0; k < files_.size(); ++k) {
      settings.setArrayIndex(static_cast<int>(k));
      settings.setValue(QStringLiteral("path"), files_[k].path);
      settings.setValue(QStringLiteral("at_ms"), static_cast<qlonglong>(files_[k].at_ms));
      settings.setValue(QStringLiteral("poses"), files_[k].poses);
    }
    settings.endArray();
  }

  JobQueue& jobs_;
  std::vector<RecentFile> files_;
  QTimer write_soon_;
};

/// "today, 14:32", "yesterday, 09:10" or the date.
inline QString timeText(std::int64_t at_ms) {
  const QDateTime at = QDateTime::fromMSecsSinceEpoch(at_ms);
  const QLocale locale;
  const QString time = locale.toString(at.time(), QLocale::ShortFormat);
  const qint64 days = at.date().daysTo(QDate::currentDate());
  if (days == 0) return RecentFiles::tr("today, %1").arg(time);
  if (days == 1) return RecentFiles::tr("yesterday, %1").arg(time);
  return locale.toString(at.date(), QLocale::ShortFormat);
}

inline QString describeRecent(const RecentFile& file) {
  if (!file.problem.isEmpty()) return file.problem;
  QString words = timeText(file.at_ms);
  if (file.poses >= 0) words += QStringLiteral(" · ") + posesText(static_cast<std::size_t>(file.poses));
  return words;
}

/// Takes all widgets out of a layout; one whose button led here is still at work.
inline void clearRows(QLayout& layout) {
  while (QLayoutItem* item = layout.takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
}

/// The recent files as a list of buttons: title, when, how many poses. Up and Down move, Return opens, Del takes a file
/// from the list. A file that is gone is greyed and says why.
class RecentList : public QWidget {
  Q_OBJECT

 public:
  /// `files` must outlive the list. `most`: how many are shown; `title_characters`: longer names lose their middle.
  RecentList(RecentFiles& files, std::size_t most, int title_characters, QWidget* parent = nullptr)
      : QWidget(parent), files_(files), most_(most), title_characters_(title_characters) {
    setObjectName(QStringLiteral("recentList"));
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(2);
    connect(&files_, &RecentFiles::changed, this, &RecentList::rebuild);
    rebuild();
  }

 signals:
  void openWanted(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* button = qobject_cast<QToolButton*>(watched);
    if (!button || (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)) {
      return QWidget::eventFilter(watched, event);
    }
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool ours = key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Delete || key == Qt::Key_Return ||
                      key == Qt::Key_Enter;
    if (!ours) return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::ShortcutOverride) {
      event->accept();
      return true;
    }
    const QString path = button->property("recentPath").toString();
    const QList<QToolButton*> shown = openButtons();
    const auto at = static_cast<int>(std::find(shown.begin(), shown.end(), button) - shown.begin());
    if (key == Qt::Key_Delete) {
      files_.remove(path);
      const QList<QToolButton*> left = openButtons();
      if (!left.isEmpty()) left[std::min(at, static_cast<int>(left.size()) - 1)]->setFocus();
    } else if (key == Qt::Key_Up || key == Qt::Key_Down) {
      const int next = at + (key == Qt::Key_Up ? -1 : 1);
      if (next >= 0 && next < shown.size()) shown[next]->setFocus(Qt::TabFocusReason);
    } else {
      static_cast<QToolButton*>(watched)->click();
    }
    return true;
  }

 private:
  void rebuild() {
    const QWidget* focus = focusWidget();
    const QString focused = focus && focus->hasFocus() ? focus->property("recentPath").toString() : QString();
    clearRows(*layout_);
    if (files_.files().empty()) {
      auto* hint = styledAs(new QLabel(tr("Sessions and calibrations that you open will be listed here.")), "muted");
      hint->setWordWrap(true);
      layout_->addWidget(hint);
    }
    const std::size_t count = std::min(most_, files_.files().size());
    for (std::size_t k = 0; k < count; ++k) {
      QWidget* row = makeRow(files_.files()[k]);
      layout_->addWidget(row);
      // The row is shown at once, not when there is time: the focus goes on to it.
      row->show();
    }
    if (focused.isEmpty()) return;
    for (QToolButton* button : openButtons()) {
      if (button->property("recentPath").toString() == focused) button->setFocus();
    }
  }

  /// The folder, in the form in which the operator would see it in a shell.
  static QString shortFolder(const QString& path) {
    const QString folder = QDir::toNativeSeparators(QFileInfo(path).absolutePath());
    const QString home = QDir::toNativeSeparators(QDir::homePath());
    const QChar separator = QDir::separator();
    return home.size() > 1 && (folder + separator).startsWith(home + separator)
               ? QLatin1Char('~') + folder.mid(home.size())
               : folder;
  }

  [[nodiscard]] QWidget* makeRow(const RecentFile& file) {
    auto* row = new QWidget;
    const bool is_there = file.problem.isEmpty();
    auto* open = named(new QToolButton, "recentOpen");
    open->setProperty("flat", true);
    open->setProperty("recentPath", file.path);
    open->setFocusPolicy(Qt::StrongFocus);
    open->setToolButtonStyle(Qt::ToolButtonTextOnly);
    open->setText(open->fontMetrics().elidedText(file.title, Qt::ElideMiddle,
                                                 title_characters_ * open->fontMetrics().averageCharWidth()));
    // One that is gone keeps the focus, so that Del can take it from the list.
    open->setAccessibleName(is_there ? tr("Open %1").arg(file.title) : file.title);
    open->setAccessibleDescription(describeRecent(file));
    open->setToolTip(QStringLiteral("%1\n%2").arg(
        is_there ? shortFolder(file.path) : tr("%1. Del takes it from the list.").arg(file.problem),
        QDir::toNativeSeparators(file.path)));
    if (!is_there) {
      QPalette grey = open->palette();
      open->setStyleSheet(QStringLiteral("QToolButton { color: %1; }")
                              .arg(grey.color(QPalette::Disabled, QPalette::ButtonText).name()));
    }
    connect(open, &QToolButton::clicked, this, [this, path = file.path, is_there] {
      if (is_there) emit openWanted(path);
    });
    open->installEventFilter(this);
    auto* when = styledAs(new QLabel(describeRecent(file)), "muted");
    when->setTextFormat(Qt::PlainText);
    auto* remove = named(new QToolButton, "recentRemove");
    remove->setProperty("flat", true);
    remove->setProperty("recentPath", file.path);
    remove->setText(QStringLiteral("\u2715"));
    remove->setFocusPolicy(Qt::StrongFocus);
    remove->setToolTip(tr("Take it from this list; the file itself stays"));
    remove->setAccessibleName(tr("Take %1 from the list").arg(file.title));
    connect(remove, &QToolButton::clicked, this, [this, path = file.path] { files_.remove(path); });
    auto* layout = spaced(new QHBoxLayout(row), {0, 0, 0, 0}, 6);
    // In a narrow place, such as the step's, the words stand one below the other, so that a file with a long name keeps
    // the column narrow.
    auto* words = new FlowLayout;
    words->setSpacing(6);
    addWidgets(words, {open, when});
    layout->addLayout(words, 1);
    layout->addWidget(remove, 0, Qt::AlignTop);
    return row;
  }

  [[nodiscard]] QList<QToolButton*> openButtons() const {
    QList<QToolButton*> shown;
    // Rows on their way out are still children.
    for (auto* button : findChildren<QToolButton*>(QStringLiteral("recentOpen"))) {
      if (button->isVisibleTo(this)) shown << button;
    }
    return shown;
  }

  RecentFiles& files_;
  std::size_t most_;
  int title_characters_;
  QVBoxLayout* layout_ = new QVBoxLayout(this);
};

}  // namespace hexoderm
