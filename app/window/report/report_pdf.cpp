#include "app/window/report/report_pdf.h"

#include "app/window/report/report_page.h"
#include "app/window/report/report_plots.h"
#include "widgets/style/palette.h"

#include <QBuffer>
#include <QColor>
#include <QFontMetricsF>
#include <QPainter>
#include <QPdfWriter>
#include <QPointF>
#include <QRegularExpression>
#include <QString>
#include <QTextLayout>
#include <QTextOption>
#include <Qt>
#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>

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

namespace {

// All lengths are dots of the writer.
constexpr int kDotsPerInch = 1200;
constexpr double kPoint = kDotsPerInch / 72.0;
constexpr double kMm = kDotsPerInch / 25.4;
constexpr double kPaperWidth = 210 * kMm;
constexpr double kPaperHeight = 297 * kMm;
constexpr double kSide = 18 * kMm;
constexpr double kTop = 20 * kMm;
constexpr double kBottom = 20 * kMm;
constexpr double kWidth = kPaperWidth - 2 * kSide;
constexpr double kHeight = kPaperHeight - kTop - kBottom;
constexpr double kGutter = 5 * kMm;

const Colors& paper() { return Colors::of(Theme::Light); }

ReportTextStyle body(double points = 9) { return {points * kPoint, false, paper().text}; }
ReportTextStyle bold(double points) { return {points * kPoint, true, paper().text}; }
ReportTextStyle muted(double points = 8) { return {points * kPoint, false, paper().text_muted}; }

/// What is never parted by the end of a page.
struct Strip {
  double space_before = 0;  ///< dropped at the top of a page
  double height = 0;
  bool stays_with_next = false;
  std::shared_ptr<const Strip> repeated{};  ///< the head of its table, for the top of the next page
  std::function<void(QPainter& painter, double top)> draw;
  QStringList texts{};
};

/// A strip, and where it is.
struct PlacedStrip {
  const Strip* strip = nullptr;
  double top = 0;
};
using PdfPage = std::vector<PlacedStrip>;

/// Turns blocks into strips.
class StripMaker {
 public:
  explicit StripMaker(const ReportDocument& document) {
    addTitle(document);
    for (std::size_t k = 0; k < document.blocks.size(); ++k) {
      const ReportBlock* next = k + 1 < document.blocks.size() ? &document.blocks[k + 1] : nullptr;
      leads_ = next != nullptr &&
               (std::holds_alternative<ReportTable>(*next) || std::holds_alternative<ReportDrawings>(*next));
      std::visit([this](const auto& kind) { add(kind); }, document.blocks[k]);
    }
  }
  [[nodiscard]] const std::vector<std::shared_ptr<const Strip>>& strips() const { return strips_; }

 private:
  void push(double space_before, double height, bool stays_with_next, const QStringList& texts,
            std::function<void(QPainter& painter, double top)> draw) {
    strips_.push_back(
        std::make_shared<const Strip>(Strip{space_before, height, stays_with_next, {}, std::move(draw), texts}));
  }

  void pushText(const QString& text, const ReportTextStyle& style, double space_before, bool stays_with_next = false) {
    auto laid = std::make_shared<const ReportText>(text, style, kWidth);
    push(space_before, laid->height(), stays_with_next, {text}, [laid](QPainter& painter, double top) {
      laid->draw(painter, {kSide, top});
    });
  }

  void addTitle(const ReportDocument& document) {
    pushText(document.kind, muted(9), 0, true);
    pushText(document.name, bold(20), 0.5 * kMm, true);
    pushText(document.subtitle, muted(9), 1 * kMm, true);
    if (!document.title.empty()) addTitleBlock(document.title);
  }

  /// In columns of one width; long texts, the notes, over the whole.
  void addTitleBlock(const std::vector<std::pair<QString, QString>>& title) {
    constexpr std::size_t kColumns = 3;
    constexpr double kColumn = (kWidth - (kColumns - 1) * kGutter) / kColumns;
    std::vector<std::pair<QString, QString>> wide;
    std::vector<std::pair<QString, QString>> row;
    const auto pushField = [this](const std::vector<std::pair<QString, QString>>& fields, double column,
                                  bool is_first) {
      pushPairs(fields, muted(7.5), body(10), column, (is_first ? 5 : 2.5) * kMm, true);
    };
    bool first = true;
    const auto flush = [&] {
      if (!row.empty()) pushField(row, kColumn, first);
      first = first && row.empty();
      row.clear();
    };
    for (const auto& field : title) {
      const bool is_long =
          field.second.contains(QLatin1Char('\n')) || ReportText::widthOf(field.second, body(10)) > 1.8 * kColumn;
      if (is_long) {
        wide.push_back(field);
        continue;
      }
      row.push_back(field);
      if (row.size() == kColumns) flush();
    }
    flush();
    for (const auto& field : wide) {
      pushField({field}, kWidth, first);
      first = false;
    }
  }

  /// Side by side in columns of one width, each with an upper and a lower text.
  void pushPairs(const std::vector<std::pair<QString, QString>>& pairs, const ReportTextStyle& upper,
                 const ReportTextStyle& lower, double column, double space_before, bool stays_with_next) {
    auto laid = std::make_shared<std::vector<std::pair<ReportText, ReportText>>>();
    double height = 0;
    QStringList texts;
    for (const auto& [above, below] : pairs) {
      texts << above << below;
      laid->emplace_back(ReportText(above, upper, column), ReportText(below, lower, column));
      height = std::max(height, laid->back().first.height() + laid->back().second.height());
    }
    push(space_before, height, stays_with_next, texts, [laid, column](QPainter& painter, double top) {
      double left = kSide;
      for (const auto& [above, below] : *laid) {
        above.draw(painter, {left, top});
        below.draw(painter, {left, top + above.height()});
        left += column + kGutter;
      }
    });
  }

  void add(const ReportHeading& heading) {
    if (!heading.large) {
      pushText(heading.text, bold(10.5), 5 * kMm, true);
      return;
    }
    auto laid = std::make_shared<const ReportText>(heading.text, bold(13), kWidth);
    push(9 * kMm, laid->height() + 1.5 * kMm, true, {heading.text}, [laid](QPainter& painter, double top) {
      laid->draw(painter, {kSide, top});
      const double line = top + laid->height() + 0.8 * kMm;
      painter.setPen(QPen(paper().text_muted, 0.6 * kPoint));
      painter.drawLine(QPointF(kSide, line), QPointF(kSide + kWidth, line));
    });
  }

  void add(const ReportParagraph& paragraph) {
    ReportTextStyle style = paragraph.is_note ? muted(8) : body(9);
    if (paragraph.tone == Tone::Neutral) {
      pushText(paragraph.text, style, 1.5 * kMm, leads_);
      return;
    }
    // A bar of the tone's colour, as the verdict has it; the words say the same.
    auto laid = std::make_shared<const ReportText>(paragraph.text, style, kWidth - 4 * kMm);
    push(1.8 * kMm, laid->height(), leads_, {paragraph.text},
         [laid, color = reportColor(paragraph.tone)](QPainter& painter, double top) {
           painter.fillRect(QRectF(kSide, top, 0.9 * kMm, laid->height()), color);
           laid->draw(painter, {kSide + 4 * kMm, top});
         });
  }

  void add(const ReportVerdict& verdict) {
    constexpr double kInset = 5 * kMm;
    const double width = kWidth - 2 * kInset;
    auto laid = std::make_shared<std::vector<ReportText>>();
    laid->emplace_back(verdict.reason, bold(12), width);
    if (!verdict.meaning.isEmpty()) laid->emplace_back(verdict.meaning, body(9), width);
    if (!verdict.next.isEmpty()) laid->emplace_back(verdict.next, body(9), width);
    constexpr double kBetween = 2 * kMm;
    double height = 2 * 4 * kMm - kBetween;
    for (const ReportText& text : *laid) height += text.height() + kBetween;
    push(6 * kMm, height, true, {verdict.reason, verdict.meaning, verdict.next},
         [laid, height, color = reportColor(verdict.tone)](QPainter& painter, double top) {
           painter.fillRect(QRectF(kSide, top, kWidth, height), reportTint(color));
           painter.fillRect(QRectF(kSide, top, 1.4 * kMm, height), color);
           double y = top + 4 * kMm;
           for (const ReportText& text : *laid) {
             text.draw(painter, {kSide + kInset, y});
             y += text.height() + kBetween;
           }
         });
  }

  void add(const ReportMetrics& figures) {
    const auto count = static_cast<double>(figures.figures.size());
    pushPairs(figures.figures, bold(14), muted(7.5), (kWidth - (count - 1) * kGutter) / count, 5 * kMm, false);
  }

  void add(const ReportPairs& pairs) {
    constexpr double kNames = (kWidth + kGutter) / 3;  // one column of three
    std::size_t left = pairs.rows.size();              // they are few, and stay together
    for (const auto& [name, value] : pairs.rows) {
      auto laid = std::make_shared<const std::pair<ReportText, ReportText>>(
          ReportText(name, muted(8), kNames - 2 * kMm), ReportText(value, body(8), kWidth - kNames));
      push(0.8 * kMm, std::max(laid->first.height(), laid->second.height()), --left > 0, {name, value},
           [laid](QPainter& painter, double top) {
             laid->first.draw(painter, {kSide, top});
             laid->second.draw(painter, {kSide + kNames, top});
           });
    }
  }

  void add(const ReportDrawings& row) {
    const double width = (kWidth - static_cast<double>(row.columns - 1) * kGutter) / static_cast<double>(row.columns);
    for (std::size_t first = 0; first < row.drawings.size(); first += row.columns) {
      const std::size_t last = std::min(first + row.columns, row.drawings.size());
      auto drawings = std::make_shared<std::vector<std::pair<ReportDrawing, ReportText>>>();
      double picture = 0;
      double caption = 0;
      QStringList texts;
      for (std::size_t k = first; k < last; ++k) {
        texts << row.drawings[k].caption;
        drawings->emplace_back(row.drawings[k], ReportText(row.drawings[k].caption, muted(8), width));
        picture = std::max(picture, width * row.drawings[k].aspect);
        caption = std::max(caption, drawings->back().second.height());
      }
      push(3 * kMm, picture + 1 * kMm + caption, false, texts,
           [drawings, width, picture](QPainter& painter, double top) {
             double left = kSide;
             for (const auto& [drawing, words] : *drawings) {
               painter.save();
               drawing.draw(painter, QRectF(left, top, width, width * drawing.aspect), kPoint);
               painter.restore();
               words.draw(painter, {left, top + picture + 1 * kMm});
               left += width + kGutter;
             }
           });
    }
  }

  void add(const ReportTable& table) {
    if (table.columns.empty()) return;
    const std::vector<double> widths = columnWidths(table);
    QStringList titles;
    for (const ReportTable::Column& column : table.columns) titles << column.title;
    const auto head = std::make_shared<const Strip>(tableRow(table, widths, {titles, false}, true));
    strips_.push_back(head);
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
      Strip row = tableRow(table, widths, table.rows[k], false);
      row.repeated = head;
      // Neither the first nor the last row stands alone.
      const bool is_last = k + 1 == table.rows.size();
      row.stays_with_next = is_last ? !table.note.isEmpty() : k == 0 || k + 2 == table.rows.size();
      strips_.push_back(std::make_shared<const Strip>(std::move(row)));
    }
    if (!table.note.isEmpty()) pushText(table.note, muted(8), 1.5 * kMm);
  }

  static constexpr double kColumnGap = 3 * kMm;
  static constexpr double kMaxExtra = 14 * kMm;

  static std::vector<double> columnWidths(const ReportTable& table) {
    const std::size_t count = table.columns.size();
    const double room = kWidth - static_cast<double>(count - 1) * kColumnGap;
    std::vector<double> wanted(count);
    std::vector<double> needed(count);
    for (std::size_t k = 0; k < count; ++k) {
      needed[k] = ReportText::longestWordOf(table.columns[k].title, muted(7.5));
      wanted[k] = ReportText::widthOf(table.columns[k].title, ReportTextStyle{7.5 * kPoint, true, {}});
      for (const ReportTable::Row& row : table.rows) {
        const QString& value = row.values[static_cast<int>(k)];
        const double whole = ReportText::widthOf(value, bold(8));
        wanted[k] = std::max(wanted[k], whole);
        needed[k] = std::max(needed[k], table.columns[k].is_figure ? whole : ReportText::longestWordOf(value, bold(8)));
      }
      needed[k] = std::min(needed[k], wanted[k]);
    }
    const double all = std::accumulate(wanted.begin(), wanted.end(), 0.0);
    const double least = std::accumulate(needed.begin(), needed.end(), 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      if (all <= room) {
        // Figures that stand far from each other are hard to read in a row.
        wanted[k] += std::min(kMaxExtra, (room - all) / static_cast<double>(count));
      } else if (least < room) {
        wanted[k] = needed[k] + (wanted[k] - needed[k]) * (room - least) / (all - least);
      } else {
        wanted[k] = needed[k] * room / least;
      }
    }
    return wanted;
  }

  static Strip tableRow(const ReportTable& table, const std::vector<double>& widths, const ReportTable::Row& row,
                        bool is_head) {
    constexpr double kAbove = 0.9 * kMm;
    auto laid = std::make_shared<std::vector<ReportText>>();
    double height = 0;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      ReportTextStyle style = row.remarkable ? bold(8) : body(8);
      if (is_head) style = {7.5 * kPoint, true, paper().text_muted};
      laid->emplace_back(row.values[static_cast<int>(k)], style, widths[k],
                         table.columns[k].is_figure ? Qt::AlignRight : Qt::AlignLeft);
      height = std::max(height, laid->back().height());
    }
    height += 2 * kAbove;
    return {is_head ? 2 * kMm : 0,
            height,
            is_head,
            {},
            [laid, widths, height, is_head](QPainter& painter, double top) {
              double left = kSide;
              for (std::size_t k = 0; k < laid->size(); ++k) {
                const double down = is_head ? height - kAbove - laid->at(k).height() : kAbove;
                laid->at(k).draw(painter, {left, top + down});
                left += widths[k] + kColumnGap;
              }
              painter.setPen(is_head ? QPen(paper().text_muted, 0.7 * kPoint) : QPen(paper().border, 0.4 * kPoint));
              painter.drawLine(QPointF(kSide, top + height), QPointF(left - kColumnGap, top + height));
            },
            row.values};
  }

  std::vector<std::shared_ptr<const Strip>> strips_;
  bool leads_ = false;  ///< a table or drawings follow
};

/// Shares the strips out among pages.
std::vector<PdfPage> paged(const std::vector<std::shared_ptr<const Strip>>& strips) {
  std::vector<PdfPage> pages(1);
  double used = 0;
  for (std::size_t first = 0; first < strips.size();) {
    std::size_t last = first;
    while (last + 1 < strips.size() && strips[last]->stays_with_next) ++last;
    double group = 0;
    for (std::size_t k = first; k <= last; ++k) group += strips[k]->height + (k > first ? strips[k]->space_before : 0);
    const double before = pages.back().empty() ? 0 : strips[first]->space_before;
    if (used + before + group > kHeight && !pages.back().empty()) {
      pages.emplace_back();
      used = 0;
      if (const std::shared_ptr<const Strip>& head = strips[first]->repeated) {
        pages.back().push_back({head.get(), kTop});
        used = head->height;
      }
    }
    for (std::size_t k = first; k <= last; ++k) {
      // A group that no page holds goes on where it must.
      if (k > first && used + strips[k]->space_before + strips[k]->height > kHeight) {
        pages.emplace_back();
        used = 0;
      }
      if (!pages.back().empty()) used += strips[k]->space_before;
      pages.back().push_back({strips[k].get(), kTop + used});
      used += strips[k]->height;
    }
    first = last + 1;
  }
  return pages;
}

/// What stands about the text of a page.
struct PageFrame {
  QString name;  ///< not on the first page, which has it as its headline
  QString stamp;
  QString foot;
  QString number;
};

PageFrame frameOf(const ReportDocument& document, std::size_t page, std::size_t pages) {
  return {page == 0 ? QString() : document.name, document.stamp, document.foot,
          ReportPage::pageNumber(static_cast<int>(page) + 1, static_cast<int>(pages))};
}

void drawFrame(QPainter& painter, const PageFrame& frame) {
  const QFont small = reportFont(8 * kPoint);
  const QFontMetricsF metrics(small);
  painter.setFont(small);
  painter.setPen(paper().text_muted);
  const double foot = kPaperHeight - 12 * kMm;
  const double number = metrics.horizontalAdvance(frame.number);
  painter.drawText(QPointF(kSide + kWidth - number, foot), frame.number);
  painter.drawText(QPointF(kSide, foot), metrics.elidedText(frame.foot, Qt::ElideMiddle, kWidth - number - kGutter));
  painter.setPen(QPen(paper().border, 0.4 * kPoint));
  painter.drawLine(QPointF(kSide, foot - 4 * kMm), QPointF(kSide + kWidth, foot - 4 * kMm));

  double right = kSide + kWidth;
  if (!frame.stamp.isEmpty()) {
    const QFont stamp = reportFont(8.5 * kPoint, true);
    const QFontMetricsF stamp_metrics(stamp);
    const QSizeF size(stamp_metrics.horizontalAdvance(frame.stamp) + 5 * kMm, 6 * kMm);
    const QRectF box(QPointF(right - size.width(), 8 * kMm), size);
    painter.setPen(QPen(paper().bad, 1.1 * kPoint));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box, 1 * kMm, 1 * kMm);
    painter.setFont(stamp);
    painter.setPen(paper().bad);
    painter.drawText(box, Qt::AlignCenter, frame.stamp);
    right = box.left() - kGutter;
  }
  painter.setFont(small);
  painter.setPen(paper().text_muted);
  painter.drawText(QPointF(kSide, 12.2 * kMm), metrics.elidedText(frame.name, Qt::ElideMiddle, right - kSide));
}

}  // namespace

std::vector<QStringList> pdfTexts(const ReportDocument& document) {
  const StripMaker maker(document);
  const std::vector<PdfPage> pages = paged(maker.strips());
  std::vector<QStringList> texts;
  for (const PdfPage& page : pages) {
    QStringList& of_page = texts.emplace_back();
    for (const PlacedStrip& placed : page) of_page << placed.strip->texts;
    const PageFrame frame = frameOf(document, texts.size() - 1, pages.size());
    of_page << frame.name << frame.stamp << frame.foot << frame.number;
  }
  return texts;
}

QByteArray pdfOf(const ReportDocument& document) {
  QByteArray pdf;
  QBuffer buffer(&pdf);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(0, 0, 0, 0), QPageLayout::Millimeter);
  writer.setResolution(kDotsPerInch);
  writer.setTitle(document.kind + QStringLiteral(": ") + document.name);
  writer.setCreator(QStringLiteral("Hexoderm " HEXODERM_VERSION));
  const StripMaker maker(document);
  const std::vector<PdfPage> pages = paged(maker.strips());
  QPainter painter(&writer);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t k = 0; k < pages.size(); ++k) {
    if (k > 0) writer.newPage();
    for (const PlacedStrip& placed : pages[k]) placed.strip->draw(painter, placed.top);
    drawFrame(painter, frameOf(document, k, pages.size()));
  }
  painter.end();
  return pdf;
}

}  // namespace hexoderm
