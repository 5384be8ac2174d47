#pragma once

#include "hexoderm/base/units.h"
#include "hexoderm/capture/calm_up.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "widgets/capture/capture_words.h"
#include "widgets/style/palette.h"
#include "widgets/words/words.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QToolTip>
#include <QWidget>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace hexoderm {

/// The directions of gravity seen so far: both halves of the sphere as discs, since a sphere hides its far side, with
/// the poses as numbers, the next one as a dashed ring and the present direction as a moving dot. Below: the three
/// singular values with their limit, their class, and the missing direction in words. A click or the arrow keys pick a
/// pose.
class CoverageView : public QWidget {
  Q_OBJECT

 public:
  explicit CoverageView(QWidget* parent = nullptr) : QWidget(parent) {
    setObjectName(QStringLiteral("coverageView"));
    setAccessibleName(tr("Directions of gravity seen"));
    setFocusPolicy(Qt::StrongFocus);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setCoverage({});
  }

  void setCoverage(const PoseCoverage& coverage) {
    coverage_ = coverage;
    sayAnew();
  }

  /// Shown in place of the class of an empty coverage, where there is no skin.
  void setEmptyHint(const QString& hint) {
    empty_hint_ = hint;
    sayAnew();
  }

  /// What is going on while there is no result, in words, which stand in the hint's place; empty: nothing is.
  void setAwaited(const QString& awaited) {
    awaited_ = awaited;
    sayAnew();
  }

  /// Unit vectors in the frame of the coverage; none hides the mark. The present one is shown as CalmUp makes it.
  /// Cheap: may be called 20 times a second.
  void setCurrent(const std::optional<Eigen::Vector3d>& up_o) {
    const std::optional<Eigen::Vector3d> shown = calm_up_.follow(up_o);
    if (shown == current_) return;
    update(aroundCurrent());
    current_ = shown;
    update(aroundCurrent());
  }

  void setNext(const std::optional<Eigen::Vector3d>& up_o) {
    if (next_ == up_o) return;
    next_ = up_o;
    sayAnew();
  }

  void setPickedPose(std::optional<PoseId> pose) {
    if (picked_ == pose) return;
    picked_ = pose;
    changed();
  }

  [[nodiscard]] std::optional<PoseId> pickedPose() const { return picked_; }
  /// Position of a direction, in the widget's coordinates.
  [[nodiscard]] QPointF placeOf(const Eigen::Vector3d& up_o) const { return place(arranged(), up_o); }

  QSize sizeHint() const override {
    const int width = static_cast<int>(20 * line());
    return {width, heightForWidth(width)};
  }

  QSize minimumSizeHint() const override {
    const int width = static_cast<int>(2 * kMinDisc + 4 * nowSign() + 2);
    return {width,
            static_cast<int>(kMinDisc + nowSign() + 1 + kBottom + mostBelowDiscs(std::max(width, this->width())))};
  }

  bool hasHeightForWidth() const override { return true; }

  int heightForWidth(int width) const override {
    const double disc = std::clamp(acrossOf(width), kMinDisc, kMaxDisc);
    return static_cast<int>(disc + nowSign() + 1 + kBottom + mostBelowDiscs(width));
  }

 signals:
  /// By the mouse or by a key.
  void posePicked(hexoderm::PoseId pose);

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    if (is_stale_ || still_.size() != size() * devicePixelRatioF()) paintStill();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawPixmap(0, 0, still_);
    if (current_) paintCurrent(painter, placeOf(*current_), nowSign());
    if (hasFocus()) {
      painter.setPen(QPen(colors().accent, 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(rect().adjusted(2, 2, -2, -2), 4, 4);
    }
  }

  void mousePressEvent(QMouseEvent* event) override {
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    const SeenDirection* seen = at(event->pos());
    if (seen == nullptr) return;
    setPickedPose(seen->pose);
    emit posePicked(seen->pose);
  }

  void keyPressEvent(QKeyEvent* event) override {
    const bool forth = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down;
    const bool back = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up;
    const std::vector<SeenDirection>& seen = coverage_.seen;
    if ((!forth && !back) || seen.empty()) return QWidget::keyPressEvent(event);
    const auto at = std::find_if(seen.begin(), seen.end(), [&](const SeenDirection& s) { return s.pose == picked_; });
    auto index = forth ? std::size_t{0} : seen.size() - 1;
    if (at != seen.end()) {
      index = static_cast<std::size_t>(at - seen.begin());
      index = (index + (forth ? 1 : seen.size() - 1)) % seen.size();
    }
    setPickedPose(seen[index].pose);
    emit posePicked(seen[index].pose);
  }

  bool event(QEvent* event) override {
    const QEvent::Type type = event->type();
    if (type == QEvent::FontChange || type == QEvent::StyleChange || type == QEvent::PaletteChange) changed();
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const SeenDirection* seen = at(help->pos());
    QString text =
        tr("Front: up is where the origin cell faces. Back: the other half, seen from behind.\nThe bars say how "
           "much the directions seen differ, along three axes (their singular values). Two that reach their mark, %1, "
           "fix "
           "how the cells are turned; the third tells the sensors' errors apart from that.")
            .arg(QLocale().toString(coverage_.threshold, 'f', 2));
    if (seen != nullptr) {
      text = tr("Pose %1").arg(seen->pose.value());
      if (!seen->label.empty()) text += QStringLiteral(" · ") + words(seen->label);
      if (!seen->enabled) text += QStringLiteral(" · ") + tr("disabled");
    }
    QToolTip::showText(help->globalPos(), text, this);
    return true;
  }

 private:
  /// Positions from top to bottom.
  struct Layout {
    double radius = 0;
    std::array<QPointF, 2> centers;  ///< front, back
    double names_top = 0;
    double legend_top = 0;  ///< beside the discs' names where there is room, else below
    double gauges_top = 0;
    double words_top = 0;
  };

  [[nodiscard]] double line() const { return fontMetrics().height(); }
  [[nodiscard]] double gaugeStep() const { return 1.15 * line(); }
  [[nodiscard]] double mark() const { return 0.56 * line(); }  ///< radius of a pose's number
  /// Below a disc: a pose's number on its edge hides no name, whose letters begin below the top of their line.
  [[nodiscard]] double namesGap() const { return mark() - 1; }
  /// Half the width of the sign of the present direction: drawn round a pose's number, which stays readable.
  [[nodiscard]] double nowSign() const { return 1.42 * (mark() + 1.5); }
  /// Diameter of the discs, if it is the width that limits it: signs on their rims are neither cut nor on both.
  [[nodiscard]] double acrossOf(double width) const { return (width - 4 * nowSign() - 2) / 2; }
  [[nodiscard]] bool isEmpty() const {
    return coverage_.seen.empty() && coverage_.unplaced.empty() && !coverage_.missing;
  }
  double legendWidth() const {
    const QFontMetrics metrics = fontMetrics();
    return metrics.horizontalAdvance(nowName()) + metrics.horizontalAdvance(nextName()) + 2 * (line() + kSignGap) +
           line();
  }

  /// Between the centres of the discs, so that the legend stands between their names.
  double apartForLegend() const {
    const QFontMetrics metrics = fontMetrics();
    const int widest = std::max(metrics.horizontalAdvance(frontName()), metrics.horizontalAdvance(backName()));
    return legendWidth() + widest + 1.2 * line();
  }

  QString sentence() const {
    if (!isEmpty()) return missingText(coverage_, next_);
    return awaited_.isEmpty() ? empty_hint_ : awaited_;
  }

  double wordsHeight(int width) const { return sentence().isEmpty() ? 0 : heightOf(sentence(), width); }
  double heightOf(const QString& text, int width) const {
    const QRect room(0, 0, std::max(1, width - 2 * kMargin), 10000);
    return fontMetrics().boundingRect(room, Qt::TextWordWrap, text).height() + 4;
  }

  double belowDiscs(int width) const {
    const double legend = apartForLegend() <= width / 2.0 ? 0 : 1.1 * line();
    return namesGap() + legend + 1.3 * line() + 3 * gaugeStep() + (isEmpty() ? 0 : 1.3 * line()) + wordsHeight(width);
  }

  /// With the longest of the usual sentences, whatever is said just now: the panels around this one stay where they
  /// are.
  double mostBelowDiscs(int width) const {
    const double longer = heightOf(longMissingText(), width) - wordsHeight(width);
    return belowDiscs(width) + (isEmpty() ? 1.3 * line() : 0) + std::max(0.0, longer);
  }

  Layout arranged() const {
    const double width = this->width();
    const double across = acrossOf(width);
    const double top = nowSign() + 1;
    const double high = height() - belowDiscs(this->width()) - top - kBottom;
    Layout layout;
    layout.radius = 0.5 * std::max(kMinDisc, std::min({across, high, kMaxDisc}));
    const double apart =
        std::max(2 * layout.radius + 2 * nowSign(), std::min(width - 2 * (nowSign() + 1) - 2 * layout.radius,
                                                             std::max(3 * layout.radius, apartForLegend() + line())));
    const double y = top + layout.radius;
    layout.centers = {QPointF(width / 2 - apart / 2, y), QPointF(width / 2 + apart / 2, y)};
    layout.names_top = y + layout.radius + namesGap();
    layout.legend_top = layout.names_top + (apartForLegend() <= width / 2 ? 0 : 1.1 * line());
    layout.gauges_top = layout.legend_top + 1.3 * line();
    layout.words_top = layout.gauges_top + 3 * gaugeStep();
    return layout;
  }

  QPointF place(const Layout& layout, const Eigen::Vector3d& up_o) const {
    const DiscPoint point = onDisc(up_o);
    const QPointF& center = layout.centers.at(point.side == Hemisphere::Front ? 0 : 1);
    return center + layout.radius * QPointF(point.at.x(), -point.at.y());
  }

  const SeenDirection* at(const QPointF& point) const {
    const Layout where = arranged();
    // The last drawn is on top.
    for (auto seen = coverage_.seen.rbegin(); seen != coverage_.seen.rend(); ++seen) {
      const QPointF away = point - place(where, seen->up_o);
      if (std::hypot(away.x(), away.y()) <= mark() + 2) return &*seen;
    }
    return nullptr;
  }

  QRect aroundCurrent() const {
    if (!current_) return {};
    const double reach = nowSign() + 4;
    const QPointF center = place(arranged(), *current_);
    return QRectF(center.x() - reach, center.y() - reach, 2 * reach, 2 * reach).toAlignedRect();
  }

  void changed() {
    is_stale_ = true;
    update();
  }

  /// The words have changed, and with them the room that they need.
  void sayAnew() {
    setAccessibleDescription(coverageText(coverage_, next_));
    const double height = mostBelowDiscs(width());
    if (std::exchange(said_height_, height) != height) updateGeometry();
    changed();
  }

  void paintStill() {
    const qreal ratio = devicePixelRatioF();
    still_ = QPixmap(size() * ratio);
    still_.setDevicePixelRatio(ratio);
    still_.fill(Qt::transparent);
    is_stale_ = false;
    QPainter painter(&still_);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    const Layout where = arranged();
    paintDisc(painter, where, 0);
    paintDisc(painter, where, 1);
    if (next_) paintNext(painter, place(where, *next_), mark() + 3);
    paintPoses(painter, where);
    paintLegend(painter, where);
    paintGauges(painter, where);
    paintWords(painter, where);
  }

  static constexpr int kLeft = Qt::AlignLeft | Qt::AlignVCenter;
  static void write(QPainter& painter, const QRectF& box, int flags, const QColor& color, const QString& text) {
    painter.setPen(color);
    painter.drawText(box, flags, text);
  }

  void paintDisc(QPainter& painter, const Layout& layout, std::size_t side) const {
    const QPointF& center = layout.centers.at(side);
    painter.setPen(QPen(colors().border, 1));
    painter.setBrush(colors().panel_active);
    painter.drawEllipse(center, layout.radius, layout.radius);
    painter.setBrush(Qt::NoBrush);
    for (const double angle_deg : kCircles_deg) {
      const double radius = layout.radius * discRadius(angle_deg * kDegree);
      painter.drawEllipse(center, radius, radius);
    }
    painter.drawLine(center - QPointF(layout.radius, 0), center + QPointF(layout.radius, 0));
    painter.drawLine(center - QPointF(0, layout.radius), center + QPointF(0, layout.radius));
    write(painter, {center.x() - layout.radius, layout.names_top, 2 * layout.radius, line()}, Qt::AlignCenter,
          colors().text_muted, side == 0 ? frontName() : backName());
  }

  void paintPoses(QPainter& painter, const Layout& layout) const {
    const QColor full = linkStroke(EdgeQuality::Fully, theme()).color;
    QFont small = font();
    small.setPointSizeF(0.8 * small.pointSizeF());
    small.setBold(true);
    painter.save();
    painter.setFont(small);
    for (const SeenDirection& seen : coverage_.seen) {
      const QPointF center = place(layout, seen.up_o);
      painter.setPen(seen.enabled ? QPen(colors().panel, 1) : QPen(colors().text_muted, 1.2, Qt::DotLine));
      painter.setBrush(seen.enabled ? full : colors().panel);
      painter.drawEllipse(center, mark(), mark());
      const QColor& on_full = theme() == Theme::Dark ? colors().accent_text : colors().text;
      write(painter, {center.x() - 20, center.y() - 20, 40, 40}, Qt::AlignCenter,
            seen.enabled ? on_full : colors().text_muted, QString::number(seen.pose.value()));
      if (seen.pose != picked_) continue;
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(colors().selection, 2));
      painter.drawEllipse(center, mark() + 2, mark() + 2);
    }
    painter.restore();
  }

  void paintNext(QPainter& painter, const QPointF& center, double radius) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors().accent, 2, Qt::DashLine));
    painter.drawEllipse(center, radius, radius);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors().accent);
    painter.drawEllipse(center, 2, 2);
  }

  void paintCurrent(QPainter& painter, const QPointF& center, double size) const {
    const std::array<QPointF, 4> diamond = {center + QPointF(0, -size), center + QPointF(size, 0),
                                            center + QPointF(0, size), center + QPointF(-size, 0)};
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(colors().panel, 3), QPen(colors().text, 2)}) {
      painter.setPen(pen);
      painter.drawPolygon(diamond.data(), 4);
    }
  }

  void paintLegend(QPainter& painter, const Layout& layout) const {
    double x = (width() - legendWidth()) / 2;
    const double y = layout.legend_top + 0.5 * line();
    paintCurrent(painter, {x + 0.5 * line(), y}, 0.42 * line());
    x = writeName(painter, x, layout.legend_top, nowName());
    paintNext(painter, {x + 0.5 * line(), y}, 0.38 * line());
    writeName(painter, x, layout.legend_top, nextName());
  }

  /// Beside its sign; returns where the next sign stands.
  double writeName(QPainter& painter, double x, double top, const QString& name) const {
    const double advance = fontMetrics().horizontalAdvance(name);
    write(painter, {x + line() + kSignGap, top, advance + 2, line()}, kLeft, colors().text_muted, name);
    return x + line() + kSignGap + advance + line();
  }

  void paintGauges(QPainter& painter, const Layout& layout) const {
    const QFontMetrics metrics = fontMetrics();
    const std::array<QString, 3> names = {tr("1st"), tr("2nd"), tr("3rd")};
    int names_width = 0;
    for (const QString& each : names) names_width = std::max(names_width, metrics.horizontalAdvance(each));
    const double left = kMargin + names_width + 10;
    const double value_width = metrics.horizontalAdvance(QStringLiteral("✓ 00.00"));
    const double bar = std::max(20.0, width() - left - kMargin - value_width - 10);
    // The mark stays where it is from pose to pose; a value beyond the end fills the bar.
    const double scale = 4 * coverage_.threshold;
    const double thick = 0.42 * line();
    for (int k = 0; k < 3; ++k) {
      const double value = coverage_.singular_values(k);
      const bool reached = value >= coverage_.threshold;
      const double top = layout.gauges_top + k * gaugeStep();
      const double middle = top + 0.5 * line();
      write(painter, {kMargin, top, left, line()}, kLeft, colors().text_muted, names.at(static_cast<std::size_t>(k)));
      painter.setPen(Qt::NoPen);
      painter.setBrush(colors().border);
      painter.drawRoundedRect(QRectF(left, middle - thick / 2, bar, thick), 2, 2);
      // A value below its limit is hatched as well as of another hue.
      const QColor hue = linkStroke(reached ? EdgeQuality::Fully : EdgeQuality::Partially, theme()).color;
      const QRectF filled(left, middle - thick / 2, std::clamp(bar * value / scale, 2.0, bar), thick);
      painter.setBrush(reached ? QBrush(hue) : QBrush(hue, Qt::BDiagPattern));
      if (!reached) painter.setPen(QPen(hue, 1));
      if (value > kNoValue) painter.drawRoundedRect(filled, 2, 2);
      const double limit = left + bar * coverage_.threshold / scale;
      painter.setPen(QPen(colors().text, 2));
      painter.drawLine(QPointF(limit, middle - 0.42 * line()), QPointF(limit, middle + 0.42 * line()));
      const QString text = QLocale().toString(value, 'f', 2);
      write(painter, {left + bar + 6, top, value_width + 4, line()}, Qt::AlignRight | Qt::AlignVCenter,
            reached ? colors().text : colors().text_muted, reached ? QStringLiteral("✓ ") + text : text);
    }
  }

  void paintWords(QPainter& painter, const Layout& layout) const {
    const double width = this->width() - 2 * kMargin;
    QRectF all(kMargin, layout.words_top, width, wordsHeight(this->width()));
    if (!isEmpty()) {
      const double middle = layout.words_top + 0.5 * line();
      drawStroke(painter, linkStroke(coverage_.quality, theme()), QLineF(kMargin, middle, kMargin + 26, middle), 3);
      const QString quality = tr("%1 · mark: enough").arg(qualityWord(coverage_.quality));
      write(painter, {kMargin + 33, layout.words_top, width - 33, line()}, kLeft, colors().text,
            fontMetrics().elidedText(quality, Qt::ElideRight, static_cast<int>(width - 33)));
      all.translate(0, 1.3 * line());
    }
    write(painter, all, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, colors().text_muted, sentence());
  }

  [[nodiscard]] Theme theme() const { return themeOf(palette()); }
  [[nodiscard]] const Colors& colors() const { return Colors::of(palette()); }

  PoseCoverage coverage_;
  CalmUp calm_up_;
  std::optional<Eigen::Vector3d> current_;
  std::optional<Eigen::Vector3d> next_;
  std::optional<PoseId> picked_;
  QPixmap still_;  ///< everything but the present direction
  bool is_stale_ = true;
  double said_height_ = 0;  ///< height of the words below the discs
  QString empty_hint_;
  QString awaited_;

  static constexpr int kMargin = 12;
  static constexpr int kBottom = 8;
  static constexpr double kMinDisc = 56;
  static constexpr double kNoValue = 0.005;  // written 0.00
  static constexpr double kMaxDisc = 260;
  static constexpr std::array<double, 2> kCircles_deg = {30, 60};
  static constexpr int kSignGap = 4;  // between a sign of the legend and its name

  static QString frontName() { return tr("front"); }
  static QString backName() { return tr("back"); }
  static QString nowName() { return tr("now"); }
  static QString nextName() { return tr("next"); }
};

}  // namespace hexoderm
