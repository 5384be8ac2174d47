#include "widgets/patch/patch_legend_view.h"

#include "widgets/coloring/coloring_words.h"
#include "widgets/patch/range_popup.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

namespace hexoderm {
namespace {

QPointF placeOf(const QMouseEvent& event) {
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  return event.position();
#else
  return event.localPos();
#endif
}

}  // namespace

PatchLegendView::PatchLegendView(QWidget* parent)
    : QWidget(parent), button_(new QToolButton(this)), popup_(new RangePopup(this)) {
  setObjectName(QStringLiteral("patchLegend"));
  setAttribute(Qt::WA_NoSystemBackground);
  setMouseTracking(true);
  button_->setObjectName(QStringLiteral("scaleRange"));
  button_->setProperty("flat", true);
  button_->setFocusPolicy(Qt::TabFocus);
  button_->setToolTip(tr("The range of the colours: fitted to what is shown, the usual one, or as you type it"));
  connect(button_, &QToolButton::clicked, this, &PatchLegendView::openPopup);
  connect(popup_, &RangePopup::rangeWanted, this, &PatchLegendView::rangeFixed);
  connect(popup_, &RangePopup::fitWanted, this, &PatchLegendView::rangeReleased);
  parent->installEventFilter(this);
  hide();
}

void PatchLegendView::setContent(const std::optional<LegendContent>& content) {
  content_ = content;
  const bool has_scale = content_ && content_->scale;
  if (!has_scale || probed_.value_or(0) > static_cast<int>(ScaleLegend::kBins)) probed_.reset();
  // The view below is turned through a legend that offers nothing.
  setAttribute(Qt::WA_TransparentForMouseEvents, !has_scale);
  setFocusPolicy(has_scale ? Qt::TabFocus : Qt::NoFocus);
  if (has_scale) {
    popup_->setScale(*content_->scale);
    button_->setText(scaleStateWord(*content_->scale) + QStringLiteral(" ▾"));
    button_->setAccessibleName(tr("Range of the colours: %1").arg(scaleStateWord(*content_->scale)));
  }
  button_->setVisible(has_scale);
  arrange();
  describe();
}

void PatchLegendView::setMarkedValue(std::optional<double> value, const QString& word) {
  if (value == marked_ && word == marked_word_) return;
  marked_ = value;
  marked_word_ = word;
  update();
}

void PatchLegendView::paintPicture(QPainter& painter, const QSize& area) const {
  if (!content_) return;
  PatchLegend(*content_, themeOf(palette()), font(), area, {}).paint(painter, marked_, marked_word_, std::nullopt);
}

void PatchLegendView::arrange() {
  legend_.reset();
  if (content_) {
    const bool has_scale = content_->scale.has_value();
    legend_.emplace(*content_, themeOf(palette()), font(), parentWidget()->size(),
                    has_scale ? button_->sizeHint() : QSize());
  }
  const bool is_there = legend_ && !legend_->place().isEmpty();
  if (is_there) {
    setGeometry(legend_->place().toAlignedRect());
    if (!legend_->buttonPlace().isEmpty()) {
      button_->setGeometry(QRect(legend_->buttonPlace().topLeft().toPoint() - pos(), button_->sizeHint()));
    }
  }
  setVisible(is_there);
  emit heightChanged(is_there ? parentWidget()->height() - geometry().top() : 0);
  update();
}

void PatchLegendView::describe() {
  if (!content_) return;
  setAccessibleName(content_->scale ? tr("Scale of the colours: %1").arg(patchTitle(content_->coloring))
                                    : tr("Legend of the colours"));
  setAccessibleDescription(content_->scale && probed_ ? binInWords(*content_->scale, *probed_)
                                                      : legendInWords(*content_));
}

void PatchLegendView::paintEvent(QPaintEvent* /*event*/) {
  if (!legend_) return;
  QPainter painter(this);
  painter.translate(-pos());
  legend_->paint(painter, marked_, marked_word_, probed_);
  if (!hasFocus() || legend_->strip() == nullptr) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Colors::of(palette()).accent, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(geometry()).adjusted(1.5, 1.5, -1.5, -1.5), 5, 5);
}

void PatchLegendView::probe(std::optional<int> bin) {
  if (bin && content_ && content_->scale) {
    const ValueHistogram& counts = content_->scale->counts;
    const auto bins = static_cast<int>(counts.counts.size());
    // Beyond the ends there is something to say only where something lies.
    bin = std::clamp(*bin, counts.below > 0 ? -1 : 0, counts.above > 0 ? bins : bins - 1);
  }
  if (bin == probed_) return;
  probed_ = bin;
  describe();
  update();
}

void PatchLegendView::toggleFixed() {
  if (!content_ || !content_->scale) return;
  if (content_->scale->is_fixed) {
    emit rangeReleased();
  } else {
    emit rangeFixed(content_->scale->range);
  }
}

void PatchLegendView::openPopup() { popup_->openAt(button_->mapToGlobal(QPoint(button_->width(), 0))); }

bool PatchLegendView::event(QEvent* event) {
  // Clicks on the plate are not for the view below, as one sees no view there.
  const QEvent::Type type = event->type();
  if (type == QEvent::FontChange || type == QEvent::StyleChange || type == QEvent::PaletteChange) arrange();
  return QWidget::event(event);
}

bool PatchLegendView::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (event->type() == QEvent::Resize) arrange();
  return false;
}

void PatchLegendView::mouseMoveEvent(QMouseEvent* event) {
  if (legend_ && legend_->strip() != nullptr) probe(legend_->strip()->binAt(placeOf(*event) + pos()));
}

void PatchLegendView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !legend_ || legend_->strip() == nullptr) return;
  if (legend_->strip()->binAt(placeOf(*event) + pos())) toggleFixed();
}

void PatchLegendView::leaveEvent(QEvent* event) {
  probe(std::nullopt);
  QWidget::leaveEvent(event);
}

void PatchLegendView::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(ScaleLegend::kBins);
  switch (event->key()) {
    case Qt::Key_Left:
      probe(probed_ ? *probed_ - 1 : last);
      return;
    case Qt::Key_Right:
      probe(probed_ ? *probed_ + 1 : -1);
      return;
    case Qt::Key_Home:
      probe(-1);
      return;
    case Qt::Key_End:
      probe(last);
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      toggleFixed();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void PatchLegendView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void PatchLegendView::focusOutEvent(QFocusEvent* event) {
  probe(std::nullopt);
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace hexoderm
