#include "widgets/patch/patch_controls.h"

#include "widgets/coloring/coloring_words.h"
#include "widgets/controls/folding_row.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/patch/cut_bar.h"
#include "widgets/patch/patch_words.h"

#include <QActionGroup>
#include <QMenu>
#include <QResizeEvent>
#include <QToolButton>
#include <optional>

namespace hexoderm {
namespace {

/// An action tells its purpose while it can be used, and otherwise the reason why not.
void allow(QAction* action, const QString& purpose, const QString& why_not) {
  action->setEnabled(why_not.isEmpty());
  action->setToolTip(why_not.isEmpty() ? purpose : why_not);
  action->setStatusTip(action->toolTip());
}

}  // namespace

PatchControls::PatchControls(QWidget* parent) : QFrame(parent), buttons_(new FoldingRow(this)) {
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

QToolButton* PatchControls::addButton(const QString& text, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::TabFocus);
  buttons_->addWidget(button);
  return button;
}

QMenu* PatchControls::addMenu(QToolButton* button, const char* name, const QString& title) {
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = named(new QMenu(title, button), name);
  menu->setToolTipsVisible(true);
  button->setMenu(menu);
  return menu;
}

void PatchControls::buildColoringMenu() {
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

void PatchControls::buildShowMenu() {
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

void PatchControls::buildViewMenu() {
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

void PatchControls::setWhyNot(Coloring coloring, const QString& why_not) {
  allow(action(coloring), patchTitle(coloring), why_not);
}

void PatchControls::setWhyNot(SceneItem item, const QString& why_not) { allow(action(item), itemTip(item), why_not); }

void PatchControls::setRenderer(const QString& words) {
  show_menu_->addSeparator();
  show_menu_->addAction(tr("Drawn by %1").arg(words))->setEnabled(false);
}

void PatchControls::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  if (event->size().height() != event->oldSize().height()) emit heightChanged(event->size().height());
}

}  // namespace hexoderm
