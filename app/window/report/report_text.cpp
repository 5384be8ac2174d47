#include "app/window/report/report_text.h"

#include "app/window/report/report_plots.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRegularExpression>
#include <QTextLayout>
#include <QTextOption>
#include <algorithm>

namespace hexoderm {
namespace {

constexpr double kLineHeight = 1.12;

QString inLines(QString text) { return text.replace(QLatin1Char('\n'), QChar::LineSeparator); }

}  // namespace

ReportText::ReportText(const QString& text, const ReportTextStyle& style, double width, Qt::Alignment alignment)
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

ReportText::~ReportText() = default;
ReportText::ReportText(ReportText&&) noexcept = default;
ReportText& ReportText::operator=(ReportText&&) noexcept = default;

void ReportText::draw(QPainter& painter, const QPointF& top_left) const {
  painter.setPen(color_);
  layout_->draw(&painter, top_left);
}

double ReportText::widthOf(const QString& text, const ReportTextStyle& style) {
  const QFontMetricsF metrics(reportFont(style.pixels, style.is_bold));
  double width = 0;
  for (const QString& line : text.split(QLatin1Char('\n'))) width = std::max(width, metrics.horizontalAdvance(line));
  return width;
}

double ReportText::longestWordOf(const QString& text, const ReportTextStyle& style) {
  static const QRegularExpression kBlank(QStringLiteral("[ \\n\\-/]"));
  const QFontMetricsF metrics(reportFont(style.pixels, style.is_bold));
  double width = 0;
  for (const QString& word : text.split(kBlank)) {
    width = std::max(width, metrics.horizontalAdvance(word + QLatin1Char('-')));
  }
  return width;
}

}  // namespace hexoderm
