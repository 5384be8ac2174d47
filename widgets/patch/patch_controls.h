#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/scene/patch_scene.h"

#include <QAction>
#include <QFrame>
#include <map>
#include <vector>

class QMenu;
class QToolButton;

namespace hexoderm {

class CutBar;
class FoldingRow;

/// The buttons over the 3D scene: the meaning of the colours, the things that are shown, measuring, and from where and
/// how it is looked at. They stand in one row, and fold into a menu where it is too narrow.
class PatchControls : public QFrame {
  Q_OBJECT

 public:
  explicit PatchControls(QWidget* parent = nullptr);

  /// `why_not`: the reason why cells can't be coloured by it, or why something can't be shown; empty if they can.
  void setWhyNot(Coloring coloring, const QString& why_not);
  void setWhyNot(SceneItem item, const QString& why_not);
  /// Names the renderer in the last line of the menu.
  void setRenderer(const QString& words);

  [[nodiscard]] QAction* action(Coloring coloring) const { return colorings_.at(coloring); }
  [[nodiscard]] QAction* action(SceneItem item) const { return items_.at(item); }
  /// Hidden and without a text until the part can be turned.
  [[nodiscard]] QToolButton* turnButton() const { return turn_button_; }
  [[nodiscard]] QAction* measureAction() const { return measure_; }
  [[nodiscard]] QAction* parallelAction() const { return parallel_; }
  [[nodiscard]] QAction* pictureAction() const { return picture_; }
  [[nodiscard]] QAction* fitAction() const { return fit_; }
  /// Cuts the skin open; while it is checked, a slider for the depth stands beside the buttons.
  [[nodiscard]] QAction* cutAction() const { return cut_; }
  [[nodiscard]] CutBar* cutBar() const { return cut_bar_; }
  /// The directions to look from, in the order of the menu.
  [[nodiscard]] const std::vector<QAction*>& viewActions() const { return views_; }
  [[nodiscard]] QMenu* coloringMenu() const { return coloring_menu_; }
  [[nodiscard]] QMenu* showMenu() const { return show_menu_; }

 signals:
  void coloringChosen(hexoderm::Coloring coloring);
  /// The operator chose it in the menu; coloringChosen() has been sent.
  void coloringPicked(hexoderm::Coloring coloring);
  void itemToggled(hexoderm::SceneItem item, bool shown);
  void viewRequested(hexoderm::PatchScene::View view);
  void fitRequested();
  void heightChanged(int height);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QToolButton* addButton(const QString& text, const QString& tip);
  static QMenu* addMenu(QToolButton* button, const char* name, const QString& title);
  void buildColoringMenu();
  void buildShowMenu();
  void buildViewMenu();

  FoldingRow* buttons_;
  QToolButton* coloring_button_ = nullptr;
  QToolButton* turn_button_ = nullptr;
  QMenu* coloring_menu_ = nullptr;
  QMenu* show_menu_ = nullptr;
  CutBar* cut_bar_ = nullptr;
  std::vector<QAction*> views_;
  std::map<Coloring, QAction*> colorings_;
  std::map<SceneItem, QAction*> items_;
  QAction* measure_ = new QAction(tr("&Measure"), this);
  QAction* parallel_ = new QAction(tr("Parallel pro&jection"), this);
  QAction* picture_ = new QAction(tr("Save picture of the 3D &view…"), this);
  QAction* fit_ = new QAction(tr("Fit"), this);
  QAction* cut_ = new QAction(tr("&Cut open"), this);
};

}  // namespace hexoderm
