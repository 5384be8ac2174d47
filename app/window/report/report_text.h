#pragma once

#include <QColor>
#include <QPointF>
#include <QString>
#include <Qt>
#include <memory>

class QPainter;
class QTextLayout;

namespace hexoderm {

struct ReportTextStyle {
  double pixels = 12;
  bool is_bold = false;
  QColor color;
};

/// A text laid out in lines of a width, which breaks within a word where it must.
class ReportText {
 public:
  ReportText(const QString& text, const ReportTextStyle& style, double width, Qt::Alignment alignment = Qt::AlignLeft);
  ~ReportText();
  ReportText(ReportText&&) noexcept;
  ReportText& operator=(ReportText&&) noexcept;

  [[nodiscard]] double height() const { return height_; }
  void draw(QPainter& painter, const QPointF& top_left) const;

  /// Of the text in one line, and of its longest word.
  static double widthOf(const QString& text, const ReportTextStyle& style);
  static double longestWordOf(const QString& text, const ReportTextStyle& style);

 private:
  std::unique_ptr<QTextLayout> layout_;
  QColor color_;
  double height_ = 0;
};

}  // namespace hexoderm
