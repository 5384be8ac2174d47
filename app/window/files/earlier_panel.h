#pragma once

#include <QWidget>

namespace hexoderm {

class RecentFiles;
class UnsavedSessions;

/// The sessions of earlier times, for the step Connect: those that were not saved, and the newest of the recent files.
class EarlierPanel : public QWidget {
  Q_OBJECT

 public:
  /// Both outlive the panel.
  EarlierPanel(RecentFiles& recent, UnsavedSessions& unsaved, QWidget* parent = nullptr);

 signals:
  void openWanted(const QString& path);
};

}  // namespace hexoderm
