#pragma once

#include "app/window/presenters/file_presenter.h"
#include "app/window/presenters/presenter.h"
#include "app/window/settings/theme.h"
#include "app/window/toolkit/coalesced_refresh.h"

#include <QDateTime>
#include <QDir>
#include <QImage>
#include <QStandardPaths>
#include <QTimer>
#include <functional>

namespace hexoderm {

/// Takes the pictures that the operator saves: of the window and of its views.
class PicturePresenter : public Presenter {
  Q_OBJECT

 public:
  PicturePresenter(const WindowParts& parts, FilePresenter& files) : Presenter(parts), files_(files) {
    connect(actions.screenshot, &QAction::triggered, this, &PicturePresenter::savePicture);
    connect(views.patch, &PatchView::pictureRequested, this, &PicturePresenter::savePatch);
    connect(views.graph, &GraphView::pictureWanted, this, &PicturePresenter::saveGraph);
  }

  /// The whole window as it looks now. Waits for the 3D view to be up to date (PatchView::waitUntilUpToDate()).
  [[nodiscard]] QImage picture() {
    // Large views draw when there is time; until then a picture of the window would show their last state.
    settle();
    views.graph->drawNow();
    views.patch->waitUntilUpToDate();
    views.patch->drawNow();
    if (views.robot->isVisible()) views.robot->drawNow();
    return pictureAsDrawn();
  }

 private:
  /// Layouts have not caught up with a text that has just changed, inner ones ask outer ones for room; and a theme that
  /// was just chosen may still wait for its turn.
  void settle() {
    coalesced_refresh.finish();
    finishTheme();
    constexpr int kNested = 4;
    for (int k = 0; k < kNested; ++k) QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  }

  QImage pictureAsDrawn() {
    settle();
    return window.grab().toImage();
  }

  void savePicture() {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    const QDir folder(QDir(pictures).exists() ? pictures : lastFolder());
    const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"));
    const QString path = folder.filePath(QStringLiteral("hexoderm-%1.png").arg(stamp));
    views.patch->whenUpToDate([this, path] { drawAndSave(path); });
  }

  /// In turns of their own, because a theme, drawing and the picture all take their time without a graphics card. A
  /// pause of 0 would be none: what is posted comes before everything that waits.
  void drawAndSave(const QString& path) {
    afterTheme([this, path] {
      settle();
      views.graph->drawNow();
      QTimer::singleShot(kNextTurn_ms, this, [this, path] {
        views.patch->drawNow();
        QTimer::singleShot(kNextTurn_ms, this, [this, path] {
          afterTheme([this, path] { controller.resultFiles().saveImage(pictureAsDrawn(), path); });
        });
      });
    });
  }

  /// Does it when every window that is shown wears the chosen theme.
  void afterTheme(std::function<void()> work) {
    if (isThemeFinished()) {
      work();
    } else {
      constexpr int kTurn_ms = 10;
      QTimer::singleShot(kTurn_ms, this, [this, work = std::move(work)] { afterTheme(work); });
    }
  }

  void savePatch() {
    files_.askForPath(tr("Save a picture of the 3D view"), files_.suggestedName() + tr("-3d"), tr("Pictures (*.png)"),
                      QStringLiteral(".png"), [this](const QString& path) {
                        views.patch->whenUpToDate(
                            [this, path] { controller.resultFiles().saveImage(views.patch->screenshot(), path); });
                      });
  }

  void saveGraph() {
    files_.askForPath(tr("Save a picture of the graph"), files_.suggestedName() + tr("-graph"),
                      tr("Vector graphics (*.svg);;Pictures (*.png)"), QStringLiteral(".svg"),
                      [this](const QString& path) {
                        controller.resultFiles().savePicture(
                            [picture = views.graph->picture(), path] { return picture.save(path); }, path);
                      });
  }

  FilePresenter& files_;
};

}  // namespace hexoderm
