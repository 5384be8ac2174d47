#pragma once

#include "widgets/coloring/cell_coloring.h"
#include "widgets/scene/patch_scene.h"

#include <QFrame>
#include <map>

class QAction;
class QMenu;
class QToolButton;

namespace hexoderm {

class FlowLayout;

/// The buttons over the 3D scene: what the colours mean, what is shown, measuring, and where to look from. In several
/// rows where one is too narrow.
class PatchControls : public QFrame {
  Q_OBJECT

 public:
  explicit PatchControls(QWidget* parent = nullptr);

  /// Why cells can't be coloured by it, or something can't be shown; empty: they can.
  void setWhyNot(CellColoring coloring, const QString& why_not);
  void setWhyNot(SceneItem item, const QString& why_not);
  /// Shows the renderer's name, as the last line of the menu.
  void setRenderer(const QString& words);

  [[nodiscard]] QAction* action(CellColoring coloring) const { return colorings_.at(coloring); }
  [[nodiscard]] QAction* action(SceneItem item) const { return items_.at(item); }
  /// For who makes the part turnable: hidden, and without a text.
  [[nodiscard]] QToolButton* turnButton() const { return turn_button_; }
  [[nodiscard]] QAction* measureAction() const { return measure_; }
  [[nodiscard]] QAction* parallelAction() const { return parallel_; }
  [[nodiscard]] QAction* pictureAction() const { return picture_; }

 signals:
  void coloringChosen(hexoderm::CellColoring coloring);
  void itemToggled(hexoderm::SceneItem item, bool shown);
  void viewRequested(hexoderm::PatchScene::View view);
  void fitRequested();
  void heightChanged(int height);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QToolButton* addButton(const QString& text, const QString& tip);
  void buildColoringMenu();
  void buildShowMenu();
  void buildViewButtons();

  FlowLayout* buttons_;
  QToolButton* coloring_button_ = nullptr;
  QToolButton* turn_button_ = nullptr;
  QMenu* show_menu_ = nullptr;
  std::map<CellColoring, QAction*> colorings_;
  std::map<SceneItem, QAction*> items_;
  QAction* measure_;
  QAction* parallel_;
  QAction* picture_;
};

}  // namespace hexoderm
