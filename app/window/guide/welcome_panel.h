#pragma once

#include <QScrollArea>
#include <vector>

class QAction;
class QVBoxLayout;

namespace hexoderm {

class RecentFiles;
class UnsavedSessions;

/// The middle of the window as long as nothing is open: ways to begin, recent files, and sessions that were not saved.
class WelcomePanel : public QScrollArea {
  Q_OBJECT

 public:
  /// A button each, the first one being the one that stands out. All must outlive the panel.
  WelcomePanel(const std::vector<QAction*>& choices, RecentFiles& recent, UnsavedSessions& unsaved,
               QWidget* parent = nullptr);

 signals:
  void openWanted(const QString& path);

 protected:
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace hexoderm
