#pragma once

#include "widgets/coloring/coloring.h"
#include "widgets/coloring/scale_legend.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/patch/patch_legend.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QRadioButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace hexoderm {

/// Asks for the range of a scale: fitted to what is shown, the usual one, or one that is typed. What is chosen holds at
/// once; Esc, or a click beside it, closes the popup.
class RangePopup : public QFrame {
  Q_OBJECT

 public:
  explicit RangePopup(QWidget* parent) : QFrame(parent, Qt::Popup) {
    setObjectName(QStringLiteral("rangePopup"));
    setProperty("card", true);
    setAccessibleName(tr("Range of the colours"));
    complaint_->setWordWrap(true);
    auto* ends = new QHBoxLayout;
    addWidgets(ends, {typed_, low_});
    ends->addWidget(new QLabel(tr("to")));
    addWidgets(ends, {high_, unit_});
    auto* layout = new QVBoxLayout(this);
    addWidgets(layout, {fitted_, usual_});
    layout->addLayout(ends);
    layout->addWidget(complaint_);
    for (QRadioButton* choice : {fitted_, usual_, typed_}) {
      connect(choice, &QRadioButton::clicked, this, &RangePopup::choose);
    }
    for (QDoubleSpinBox* end : {low_, high_}) {
      connect(end, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &RangePopup::takeTyped);
    }
  }

  void setScale(const ScaleLegend& scale) {
    scale_ = scale;
    const ColoringRow& row = coloringRow(scale_.coloring);
    const double step = std::pow(10.0, std::floor(std::log10((scale_.range.high - scale_.range.low) / 10)));
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 1, 6);
    unit_->setText(QString::fromUtf8(row.unit));
    fitted_->setVisible(row.is_fitted);
    if (row.range) {
      usual_->setText(tr("&Usual range, %1 to %2")
                          .arg(QLocale().toString(row.range->low, 'g', 6),
                               valueWithUnit(row.range->high, *row.range, scale_.coloring)));
    }
    usual_->setVisible(row.range.has_value());
    const bool is_usual = row.range && scale_.range == *row.range && (scale_.is_fixed || !row.is_fitted);
    (is_usual ? usual_ : scale_.is_fixed ? typed_ : fitted_)->setChecked(true);
    complaint_->hide();
    // An end that is being typed stays as it is.
    const auto show = [&](QDoubleSpinBox* end, double value) {
      const QSignalBlocker quiet(end);
      end->setDecimals(decimals);
      end->setSingleStep(step);
      end->setValue(value);
    };
    show(low_, scale_.range.low);
    show(high_, scale_.range.high);
  }

  /// Opens with its lower right corner at a place on the screen.
  void openAt(const QPoint& lower_right) {
    adjustSize();
    QRect place(QPoint(0, 0), size());
    place.moveBottomRight(lower_right);
    const QRect room = parentWidget()->screen()->availableGeometry();
    place.moveLeft(std::clamp(place.left(), room.left(), std::max(room.left(), room.right() - place.width())));
    place.moveTop(std::clamp(place.top(), room.top(), std::max(room.top(), room.bottom() - place.height())));
    move(place.topLeft());
    show();
    for (QRadioButton* choice : {fitted_, usual_, typed_}) {
      if (choice->isChecked()) choice->setFocus(Qt::PopupFocusReason);
    }
  }

 signals:
  /// low < high
  void rangeWanted(hexoderm::ColorRange range);
  void fitWanted();

 private:
  static constexpr double kLargestEnd = 1e6;
  static QDoubleSpinBox* makeEnd(const QString& name, const QString& words) {
    auto* end = new QDoubleSpinBox;
    setNames(end, name, words);
    end->setRange(-kLargestEnd, kLargestEnd);
    end->setKeyboardTracking(false);  // a number that is half typed is none
    return end;
  }

  void choose() {
    const ColoringRow& row = coloringRow(scale_.coloring);
    if (fitted_->isChecked() || (usual_->isChecked() && !row.is_fitted)) {
      emit fitWanted();
    } else if (usual_->isChecked()) {
      emit rangeWanted(*row.range);
    } else {
      takeTyped();
    }
  }

  void takeTyped() {
    const ColorRange range{low_->value(), high_->value()};
    const bool is_one = range.low < range.high;
    complaint_->setVisible(!is_one);
    adjustSize();
    if (is_one) emit rangeWanted(range);
  }

  ScaleLegend scale_;
  QRadioButton* fitted_ = named(new QRadioButton(tr("&Fitted to what is shown")), "rangeFitted");
  QRadioButton* usual_ = named(new QRadioButton, "rangeUsual");
  QRadioButton* typed_ = named(new QRadioButton(tr("F&ixed:")), "rangeTyped");
  QDoubleSpinBox* low_ = makeEnd(QStringLiteral("rangeLow"), tr("Lower end of the range"));
  QDoubleSpinBox* high_ = makeEnd(QStringLiteral("rangeHigh"), tr("Upper end of the range"));
  QLabel* unit_ = new QLabel;
  QLabel* complaint_ = styledAs(new QLabel(tr("The lower end must be below the upper one.")), "muted");
};

/// The legend at the lower edge of its parent, a view. On a scale that is pointed at, by the mouse or by the arrow
/// keys, it says which values lie there and how many cells have them. A click on the bar, or Enter, fixes the range as
/// it is, or lets it be fitted again; a button beside it opens a popup in which a range is chosen or typed. A legend of
/// classes lets the mouse through.
class PatchLegendView : public QWidget {
  Q_OBJECT

 public:
  explicit PatchLegendView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("patchLegend"));
    setAttribute(Qt::WA_NoSystemBackground);
    setMouseTracking(true);
    button_->setToolTip(tr("The range of the colours: fitted to what is shown, the usual one, or as you type it"));
    connect(button_, &QToolButton::clicked, this, &PatchLegendView::openPopup);
    connect(popup_, &RangePopup::rangeWanted, this, &PatchLegendView::rangeFixed);
    connect(popup_, &RangePopup::fitWanted, this, &PatchLegendView::rangeReleased);
    parent->installEventFilter(this);
    hide();
  }

  /// None hides it.
  void setContent(const std::optional<LegendContent>& content) {
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

  /// Points at a value on the scale, and says whose it is ("cell 5: 0.42 mm"); none points at nothing.
  void setMarkedValue(std::optional<double> value, const QString& word = {}) {
    if (value == marked_ && word == marked_word_) return;
    marked_ = value;
    marked_word_ = word;
    update();
  }

  [[nodiscard]] std::optional<double> markedValue() const { return marked_; }

  /// Paints the legend into a picture of the parent of this size.
  void paintPicture(QPainter& painter, const QSize& area) const {
    if (!content_) return;
    PatchLegend(*content_, themeOf(palette()), font(), area, {}).paint(painter, marked_, marked_word_, std::nullopt);
  }

 signals:
  void rangeFixed(hexoderm::ColorRange range);
  void rangeReleased();
  /// It covers this much of its parent's bottom, in pixels; 0 while it is hidden.
  void heightChanged(int pixels);

 protected:
  bool event(QEvent* event) override {
    // Clicks on the plate are not for the view below, as one sees no view there.
    const QEvent::Type type = event->type();
    if (type == QEvent::FontChange || type == QEvent::StyleChange || type == QEvent::PaletteChange) arrange();
    return QWidget::event(event);
  }

  bool eventFilter(QObject* /*watched*/, QEvent* event) override {
    if (event->type() == QEvent::Resize) arrange();
    return false;
  }

  void paintEvent(QPaintEvent* /*event*/) override {
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

  void mouseMoveEvent(QMouseEvent* event) override {
    if (legend_ && legend_->strip() != nullptr) probe(legend_->strip()->binAt(placeOf(*event) + pos()));
  }

  void mousePressEvent(QMouseEvent* event) override {
    if (event->button() != Qt::LeftButton || !legend_ || legend_->strip() == nullptr) return;
    if (legend_->strip()->binAt(placeOf(*event) + pos())) toggleFixed();
  }

  void leaveEvent(QEvent* event) override {
    probe(std::nullopt);
    QWidget::leaveEvent(event);
  }

  void keyPressEvent(QKeyEvent* event) override {
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

  void focusInEvent(QFocusEvent* event) override {
    QWidget::focusInEvent(event);
    update();
  }

  void focusOutEvent(QFocusEvent* event) override {
    probe(std::nullopt);
    QWidget::focusOutEvent(event);
    update();
  }

 private:
  static QPointF placeOf(const QMouseEvent& event) {
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
    return event.position();
#else
    return event.localPos();
#endif
  }

  void arrange() {
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
    const int covered = is_there ? parentWidget()->height() - geometry().top() : 0;
    if (std::exchange(covered_px_, covered) != covered) emit heightChanged(covered);
    update();
  }

  void probe(std::optional<int> bin) {
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

  void toggleFixed() {
    if (!content_ || !content_->scale) return;
    if (content_->scale->is_fixed) {
      emit rangeReleased();
    } else {
      emit rangeFixed(content_->scale->range);
    }
  }

  void openPopup() { popup_->openAt(button_->mapToGlobal(QPoint(button_->width(), 0))); }
  void describe() {
    if (!content_) return;
    setAccessibleName(content_->scale ? tr("Scale of the colours: %1").arg(patchTitle(content_->coloring))
                                      : tr("Legend of the colours"));
    setAccessibleDescription(content_->scale && probed_ ? binText(*content_->scale, *probed_) : legendText(*content_));
  }

  std::optional<LegendContent> content_;
  std::optional<PatchLegend> legend_;
  int covered_px_ = 0;  ///< of the bottom of the parent, as heightChanged() says
  QToolButton* button_ = styledAs(quiet(new QToolButton(this), "scaleRange"), "flat");
  RangePopup* popup_ = new RangePopup(this);
  std::optional<double> marked_;
  QString marked_word_;
  std::optional<int> probed_;
};

}  // namespace hexoderm
