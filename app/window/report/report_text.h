#pragma once

#include "app/window/report/report_plots.h"

#include <QColor>
#include <QFontMetricsF>
#include <QPainter>
#include <QPointF>
#include <QRegularExpression>
#include <QString>
#include <QTextLayout>
#include <QTextOption>
#include <Qt>
#include <algorithm>
#include <memory>

namespace hexoderm {

struct ReportTextStyle {
  double pixels = 12;
  bool is_bold = false;
  QColor color;
};

/// A text laid out in lines of a width, which breaks within a word where it must.
class ReportText {
 public:
  ReportText(const QString& text, const ReportTextStyle& style, double width, Qt::Alignment alignment = Qt::AlignLeft)
      : layout_(std::make_unique<QTextLayout>(inLines(text), reportFont(style.pixels, style.is_bold))),
        color_(style.color) {
    QTextOption option(alignment);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout_->setTextOption(option);
    layout_->setCacheEnabled(true);
    layout_->beginLayout();
    for (QTextLine line = layout_->createLine(); line.isValid(); line = layout_->createLine()) {
      line.setLineWidth(width);
      line.setPosition({0, height_});
      height_ += line.height() * kLineHeight;
    }
    layout_->endLayout();
  }

  [[nodiscard]] double height() const { return height_; }
  void draw(QPainter& painter, const QPointF& top_left) const {
    painter.setPen(color_);
    layout_->draw(&painter, top_left);
  }

  /// Of the text in one line, and of its longest word.
  static double widthOf(const QString& text, const ReportTextStyle& style) {
    const QFontMetricsF metrics(reportFont(style.pixels, style.is_bold));
    double width = 0;
    for (const QString& line : text.split(QLatin1Char('\n'))) width = std::max(width, metrics.horizontalAdvance(line));
    return width;
  }

  static double longestWordOf(const QString& text, const ReportTextStyle& style) {
    static const QRegularExpression kBlank(QStringLiteral("[ \\n\\-/]"));
    const QFontMetricsF metrics(reportFont(style.pixels, style.is_bold));
    double width = 0;
    for (const QString& word : text.split(kBlank)) {
      width = std::max(width, metrics.horizontalAdvance(word + QLatin1Char('-')));
    }
    return width;
  }

 private:
  static constexpr double kLineHeight = 1.12;
  static QString inLines(QString text) { return text.replace(QLatin1Char('\n'), QChar::LineSeparator); }

  std::unique_ptr<QTextLayout> layout_;
  QColor color_;
  double height_ = 0;
};

}  // namespace hexoderm
