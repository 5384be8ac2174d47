#pragma once

#include "widgets/controls/panel_parts.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

namespace hexoderm {

/// How deep the skin is cut open: a slider, which the arrow keys move too, and a button that turns the cut to the
/// viewer.
class CutBar : public QFrame {
  Q_OBJECT

 public:
  explicit CutBar(QWidget* parent = nullptr) : QFrame(parent) {
    setObjectName(QStringLiteral("cutBar"));
    // A plate, so that it is seen over cells.
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    auto* layout = spaced(new QHBoxLayout(this), {8, 0, 0, 0}, 6);
    slider_->setRange(0, kSteps);
    slider_->setPageStep(kSteps / 10);
    slider_->setValue(kSteps / 2);
    slider_->setFixedWidth(110);
    slider_->setFocusPolicy(Qt::StrongFocus);
    slider_->setToolTip(tr("How much of the skin is taken away from in front"));
    auto* align = quiet(new QToolButton(this), "cutAlign");
    align->setText(tr("Face me"));
    align->setToolTip(tr("Turns the cut so that it faces you as you look now"));
    addWidgets(layout, {labelFor(slider_, tr("Cut")), slider_, align});
    connect(slider_, &QSlider::valueChanged, this, [this] { emit shareChanged(share()); });
    connect(align, &QToolButton::clicked, this, &CutBar::alignRequested);
  }

  /// Of the skin's depth, 0 to 1.
  [[nodiscard]] double share() const { return static_cast<double>(slider_->value()) / kSteps; }

 signals:
  void shareChanged(double share);
  void alignRequested();

 private:
  static constexpr int kSteps = 100;
  QSlider* slider_ = named(new QSlider(Qt::Horizontal, this), "cutDepth", tr("Depth of the cut"));
};

}  // namespace hexoderm
