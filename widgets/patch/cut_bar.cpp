#include "widgets/patch/cut_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

namespace hexoderm {

CutBar::CutBar(QWidget* parent) : QFrame(parent), slider_(new QSlider(Qt::Horizontal, this)) {
  setObjectName(QStringLiteral("cutBar"));
  // A plate, so that it is seen over cells.
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 0, 0, 0);
  layout->setSpacing(6);
  auto* label = new QLabel(tr("Cut"), this);
  label->setBuddy(slider_);
  slider_->setObjectName(QStringLiteral("cutDepth"));
  slider_->setRange(0, kSteps);
  slider_->setPageStep(kSteps / 10);
  slider_->setValue(kSteps / 2);
  slider_->setFixedWidth(110);
  slider_->setFocusPolicy(Qt::StrongFocus);
  slider_->setAccessibleName(tr("Depth of the cut"));
  slider_->setToolTip(tr("How much of the skin is taken away from in front"));
  auto* align = new QToolButton(this);
  align->setObjectName(QStringLiteral("cutAlign"));
  align->setText(tr("Face me"));
  align->setToolTip(tr("Turns the cut so that it faces you as you look now"));
  align->setFocusPolicy(Qt::TabFocus);
  layout->addWidget(label);
  layout->addWidget(slider_);
  layout->addWidget(align);
  connect(slider_, &QSlider::valueChanged, this, [this] { emit shareChanged(share()); });
  connect(align, &QToolButton::clicked, this, &CutBar::alignRequested);
}

double CutBar::share() const { return static_cast<double>(slider_->value()) / kSteps; }

}  // namespace hexoderm
