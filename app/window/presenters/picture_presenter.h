#pragma once

#include <QImage>
#include <QObject>
#include <functional>

class QWidget;

namespace hexoderm {

class FilePresenter;
class GraphView;
class OncePerTurn;
class PatchView;
class RobotView;
class SessionController;
class WindowActions;

/// Takes the pictures that the operator saves: of the window and of its views.
class PicturePresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    QWidget& window;
    PatchView& patch;
    RobotView& robot;
    GraphView& graph;
  };
  /// All outlive the presenter. `refresh`: of the window, which is finished before a picture is taken.
  PicturePresenter(const Views& views, SessionController& controller, const WindowActions& actions,
                   FilePresenter& files, OncePerTurn& refresh);

  /// The whole window as it looks now. Waits for the 3D view to be up to date (PatchView::waitUntilUpToDate()).
  [[nodiscard]] QImage picture();

 private:
  void settle();
  QImage pictureAsDrawn();
  void savePicture();
  void drawAndSave(const QString& path);
  /// Does it when every window that is shown wears the chosen theme.
  void afterTheme(std::function<void()> work);
  void savePatch();
  void saveGraph();

  Views views_;
  SessionController& controller_;
  FilePresenter& files_;
  OncePerTurn& refresh_;
};

}  // namespace hexoderm
