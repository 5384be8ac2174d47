#pragma once

#include "app/window/presenters/presenter.h"

#include <QImage>
#include <functional>

namespace hexoderm {

class FilePresenter;

/// Takes the pictures that the operator saves: of the window and of its views.
class PicturePresenter : public Presenter {
  Q_OBJECT

 public:
  PicturePresenter(const WindowParts& parts, FilePresenter& files);

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

  FilePresenter& files_;
};

}  // namespace hexoderm
