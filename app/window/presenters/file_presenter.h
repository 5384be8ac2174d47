#pragma once

#include "app/window/presenters/presenter.h"

#include <QString>
#include <functional>

namespace hexoderm {

class CsvActions;

/// Asks the operator for the files that are read or written. Before a session is replaced or the window closes, it asks
/// whether unsaved changes are to be saved.
class FilePresenter : public Presenter {
  Q_OBJECT

 public:
  explicit FilePresenter(const WindowParts& parts);

  void openFile(const QString& path);
  void startDemo();
  /// A session of a simulated robot, to place its patches.
  void startRobotDemo();

  /// Calls `proceed` at once where nothing would be lost, else after the operator has answered, unless they cancel.
  void afterAskingToSave(std::function<void()> proceed);
  /// Whether the window may close now. If it may not, the operator is asked, or a file is finished, and the window is
  /// closed after that.
  [[nodiscard]] bool mayClose();

  /// Asks where to save. `name`: suggested, without folder; `filter` as QFileDialog has it; `extension`: ".png".
  void askForPath(const QString& title, const QString& name, const QString& filter, const QString& extension,
                  std::function<void(QString)> chosen);
  /// The name of what is open, without folder and extension.
  [[nodiscard]] QString suggestedName() const;
  /// Shows the folder of a file in the desktop's program for that; says so if there is none.
  void openFolderOf(const QString& path);
  /// Serves "Save as CSV…" of a table.
  void saveTablesOf(CsvActions* of_table);

 private:
  void askToOpen();
  void saveSession(bool always_ask);
  void saveCalibration();
  void showDone(const QString& text, const QString& path, Tone tone = Tone::Good);
  /// What waits for the session to be saved does not happen.
  void forgetPlans();

  std::function<void()> after_saving_;  ///< what waits for the session to be on disk
  bool may_close_ = false;
  bool close_when_written_ = false;
};

}  // namespace hexoderm
