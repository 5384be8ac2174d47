#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/controls/folding_row.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/patch/cut_bar.h"
#include "widgets/patch/patch_words.h"
#include "widgets/scene/patch_scene.h"

#include <QAction>
#include <QActionGroup>
#include <QFrame>
#include <QMenu>
#include <QResizeEvent>
#include <QToolButton>
#include <map>
#include <optional>
#include <vector>

namespace hexoderm {

/// The buttons over the 3D scene: the meaning of the colours, the things that are shown, measuring, and from where and
/// how it is looked at. They stand in one row, and fold into a menu where it is too narrow.
class PatchControls : public QFrame {
  Q_OBJECT

 public:
  explicit PatchControls(QWidget* parent = nullptr) : QFrame(parent) {
    const auto describe = [](QAction* action, const char* name, bool checkable, const QString& tip) {
      action->setObjectName(QLatin1String(name));
      action->setCheckable(checkable);
      action->setToolTip(tip);
    };
    describe(measure_, "actionMeasure", true, tr("Distance between two cells, and the angle between their faces"));
    describe(parallel_, "actionParallel", true,
             tr("Without perspective: equal lengths look equally long wherever they are"));
    describe(picture_, "actionScenePicture", false, tr("The scene with its legend as an image file"));
    describe(fit_, "actionSceneFit", false, tr("Show the whole skin, and all that is drawn with it"));
    connect(fit_, &QAction::triggered, this, &PatchControls::fitRequested);
    describe(cut_, "actionCut", true,
             tr("Takes away what is nearer to you than a plane, so that you see what lies behind"));
    buttons_->setContentsMargins(10, 10, 10, 0);
    buttons_->setSpacing(6);
    buildColoringMenu();
    buildShowMenu();
    turn_button_ = addButton({}, {});
    turn_button_->hide();
    cut_bar_ = new CutBar(this);
    cut_bar_->hide();
    buttons_->addWidget(cut_bar_);
    connect(cut_, &QAction::toggled, cut_bar_, &QWidget::setVisible);
    buttons_->beginSecondGroup();
    buildViewMenu();
  }

  /// `why_not`: the reason why cells can't be coloured by it, or why something can't be shown; empty if they can.
  void setWhyNot(Coloring coloring, const QString& why_not) { allow(action(coloring), patchTitle(coloring), why_not); }

  void setWhyNot(SceneItem item, const QString& why_not) { allow(action(item), itemTip(item), why_not); }

  /// Names the renderer in the last line of the menu.
  void setRenderer(const QString& words) {
    show_menu_->addSeparator();
    show_menu_->addAction(tr("Drawn by %1").arg(words))->setEnabled(false);
  }

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
  void resizeEvent(QResizeEvent* event) override {
    QFrame::resizeEvent(event);
    if (event->size().height() != event->oldSize().height()) emit heightChanged(event->size().height());
  }

 private:
  QToolButton* addButton(const QString& text, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setText(text);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    buttons_->addWidget(button);
    return button;
  }

  static QMenu* addMenu(QToolButton* button, const char* name, const QString& title) {
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = named(new QMenu(title, button), name);
    menu->setToolTipsVisible(true);
    button->setMenu(menu);
    return menu;
  }

  void buildColoringMenu() {
    coloring_button_ = addButton({}, tr("What the cells' colour shows"));
    coloring_menu_ = addMenu(coloring_button_, "coloringMenu", tr("C&olour"));
    auto* group = new QActionGroup(coloring_menu_);
    std::optional<ColoringGroup> group_before;
    for (const ColoringRow& row : coloringTable()) {
      if (row.patch_title == nullptr) continue;
      if (group_before && *group_before != row.group) coloring_menu_->addSeparator();
      group_before = row.group;
      const QString name = coloringName(row.coloring);
      QAction* action = coloring_menu_->addAction(name);
      action->setCheckable(true);
      group->addAction(action);
      colorings_.emplace(row.coloring, action);
      setWhyNot(row.coloring, {});
      connect(action, &QAction::toggled, this, [this, coloring = row.coloring, name](bool chosen) {
        if (!chosen) return;
        coloring_button_->setText(tr("Colour: %1 ▾").arg(name));
        coloring_button_->setAccessibleName(tr("Colour of the cells: %1").arg(name));
        emit coloringChosen(coloring);
      });
      connect(action, &QAction::triggered, this, [this, coloring = row.coloring] { emit coloringPicked(coloring); });
    }
    colorings_.at(Coloring::LinkQuality)->setChecked(true);
  }

  void buildShowMenu() {
    QToolButton* button = addButton(tr("Show ▾"), tr("What is drawn over the cells, and how"));
    button->setAccessibleName(tr("Show"));
    show_menu_ = addMenu(button, "showMenu", tr("&Show"));
    for (const SceneItem item : kSceneItems) {
      if (item == SceneItem::Links || item == SceneItem::Truth) show_menu_->addSeparator();
      QAction* action = show_menu_->addAction(itemName(item));
      action->setCheckable(true);
      action->setChecked(kShownAtFirst.at(indexOf(item)));
      items_.emplace(item, action);
      allow(action, itemTip(item), {});
      connect(action, &QAction::toggled, this, [this, item](bool shown) { emit itemToggled(item, shown); });
    }
    show_menu_->addSeparator();
    show_menu_->addAction(picture_);
  }

  void buildViewMenu() {
    for (QAction* action : {measure_, fit_}) {
      auto* button = addButton({}, {});
      button->setDefaultAction(action);
      button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    }
    QToolButton* button = addButton(tr("View ▾"), tr("From where the skin is looked at, and how"));
    button->setAccessibleName(tr("View"));
    QMenu* menu = addMenu(button, "viewMenu", {});
    const auto look = [&](const QString& text, const QString& tip, PatchScene::View view) {
      QAction* action = menu->addAction(text);
      allow(action, tip, {});
      connect(action, &QAction::triggered, this, [this, view] { emit viewRequested(view); });
      views_.push_back(action);
    };
    look(tr("Front"), tr("Look at the origin cell's front face"), PatchScene::View::Front);
    look(tr("Back"), tr("Look at the origin cell from behind"), PatchScene::View::Back);
    look(tr("Side"), tr("Look along the origin cell's x axis"), PatchScene::View::Side);
    look(tr("Top"), tr("Look along the origin cell's y axis"), PatchScene::View::Top);
    look(tr("Isometric"), tr("Look from between the three axes"), PatchScene::View::Isometric);
    menu->addSeparator();
    menu->addActions({parallel_, cut_});
  }

  FoldingRow* buttons_ = new FoldingRow(this);
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

  /// An action tells its purpose while it can be used, and otherwise the reason why not.
  static void allow(QAction* action, const QString& purpose, const QString& why_not) {
    action->setEnabled(why_not.isEmpty());
    action->setToolTip(why_not.isEmpty() ? purpose : why_not);
    action->setStatusTip(action->toolTip());
  }
};

}  // namespace hexoderm
