#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <vector>

class QLayout;
class QMenu;
class QToolButton;

namespace hexoderm {

class JobQueue;

/// A session or calibration that was open lately.
struct RecentFile {
  QString path;
  QString title;           ///< the file's name
  std::int64_t at_ms = 0;  ///< when it was open last, milliseconds since 1970, UTC
  int poses = -1;          ///< -1: not known, as for a calibration
  QString problem;         ///< why it can't be opened; empty if nothing is known against it
};

/// The files that were open lately, the newest first, at most kMax; kept in the settings. Whether a file is still
/// there is looked up on another thread, as a folder on a network can be slow.
class RecentFiles : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kMax = 10;

  /// `jobs` must outlive this object.
  explicit RecentFiles(JobQueue& jobs, QObject* parent = nullptr);
  ~RecentFiles() override;

  [[nodiscard]] const std::vector<RecentFile>& files() const { return files_; }
  /// It is open now. Moves it to the top; `poses` of -1 keeps what was known.
  void note(const QString& path, int poses);
  void remove(const QString& path);
  void clear();
  /// Looks again which files are there; changed() follows if that is news.
  void check();

  /// Fills a menu each time it is about to show; `open` is called with the path that was chosen.
  void serve(QMenu* menu, std::function<void(QString)> open);

 signals:
  void changed();

 private:
  void changeFiles();
  void write();

  JobQueue& jobs_;
  std::vector<RecentFile> files_;
  QTimer write_soon_;
};

/// "today, 14:32", "yesterday, 09:10" or the date.
QString timeText(std::int64_t at_ms);
/// "today, 14:32 · 3 poses".
QString describeRecent(const RecentFile& file);

/// Takes all widgets out of a layout; one whose button led here is still at work.
void clearRows(QLayout& layout);

/// The recent files as a list of buttons: title, when, how many poses. Up and Down move, Return opens, Del takes a file
/// from the list. A file that is gone is greyed and says why.
class RecentList : public QWidget {
  Q_OBJECT

 public:
  /// `files` must outlive the list. `most`: how many are shown; `title_characters`: longer names lose their middle.
  RecentList(RecentFiles& files, std::size_t most, int title_characters, QWidget* parent = nullptr);

 signals:
  void openWanted(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void rebuild();
  [[nodiscard]] QWidget* makeRow(const RecentFile& file);
  [[nodiscard]] QList<QToolButton*> openButtons() const;

  RecentFiles& files_;
  std::size_t most_;
  int title_characters_;
  QVBoxLayout* layout_ = new QVBoxLayout(this);
};

}  // namespace hexoderm
