#pragma once

#include "app/window/guide/keys_dialog.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/solve/result/patch_placements.h"
#include "widgets/controls/panel_parts.h"

#include <QAction>
#include <QColor>
#include <QEvent>
#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QSplitter>
#include <QStringList>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextCursor>
#include <QTextTable>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <algorithm>

// Outside of any namespace, as Qt asks for resources of static libraries.
inline void initGuideResources() { Q_INIT_RESOURCE(guide); }

namespace hexoderm {

/// Fills in what only the window knows.
class GuideBrowser : public QTextBrowser {
 public:
  QString keys;  ///< rows of a table

  QVariant loadResource(int type, const QUrl& name) override {
    const QVariant resource = QTextBrowser::loadResource(type, name);
    if (name.path().endsWith(QStringLiteral(".md")) && filling_.isNull()) {
      filling_ = QTextCursor(document());
      filling_.beginEditBlock();
    }
    if (!name.path().endsWith(QStringLiteral("/keys.md"))) return resource;
    QString page = QString::fromUtf8(resource.toByteArray());
    return page.replace(QStringLiteral("@keys@\n"), keys).toUtf8();
  }

  /// A page is laid out when it is complete; Qt would do so again for every word of a table.
  void layOut() {
    if (filling_.isNull()) return;
    filling_.endEditBlock();
    filling_ = QTextCursor();
  }

 private:
  QTextCursor filling_;  ///< while a page is read
};

/// The user guide in a window of its own: a list of its pages, the page, search within it, back and forward. The pages
/// are Markdown in the program's resources (resources/guide), one folder for each language; where the language of the
/// window has none, English ones.
class GuideWindow : public QWidget {
  Q_OBJECT

 public:
  /// Begins with `first_page`, or with the first one if there is no such page.
  explicit GuideWindow(QWidget* parent = nullptr, const QString& first_page = {}) : QWidget(parent, Qt::Window) {
    setObjectName(QStringLiteral("guideWindow"));
    setWindowTitle(tr("User guide · Hexoderm"));
    contents_->setFrameShape(QFrame::NoFrame);
    for (const QString& page : pages()) {
      auto* item = new QListWidgetItem(titleOf(page), contents_);
      item->setData(Qt::UserRole, page);
      item->setToolTip(item->text());
    }
    contents_->setMinimumWidth(contents_->sizeHintForColumn(0) + 2 * contents_->fontMetrics().height());
    browser_->setOpenExternalLinks(true);
    browser_->setFrameShape(QFrame::NoFrame);
    browser_->document()->setDocumentMargin(1.6 * browser_->fontMetrics().height());
    search_->setPlaceholderText(tr("Search in this page"));
    search_->setAccessibleName(search_->placeholderText());
    search_->setClearButtonEnabled(true);
    not_found_->hide();

    auto* back = makeButton(QStringLiteral("‹"), tr("Back to the page before"), "guideBack");
    auto* forward = makeButton(QStringLiteral("›"), tr("Forward again"), "guideForward");
    auto* earlier = makeButton(QStringLiteral("▲"), tr("Find the one before"), "guideFindBefore");
    auto* later = makeButton(QStringLiteral("▼"), tr("Find the next one"), "guideFindNext");
    back->setEnabled(false);
    forward->setEnabled(false);
    connect(back, &QToolButton::clicked, browser_, &QTextBrowser::backward);
    connect(forward, &QToolButton::clicked, browser_, &QTextBrowser::forward);
    connect(browser_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    connect(browser_, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
    connect(browser_, &QTextBrowser::sourceChanged, this, &GuideWindow::followPage);
    connect(contents_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
      if (item != nullptr) showPage(item->data(Qt::UserRole).toString());
    });
    connect(search_, &QLineEdit::returnPressed, this, [this] { find(false); });
    connect(search_, &QLineEdit::textChanged, not_found_, &QWidget::hide);
    connect(earlier, &QToolButton::clicked, this, [this] { find(true); });
    connect(later, &QToolButton::clicked, this, [this] { find(false); });

    const auto addKey = [this](const QKeySequence& key, auto&& does) {
      auto* action = new QAction(this);
      action->setShortcut(key);
      connect(action, &QAction::triggered, this, does);
      addAction(action);
    };
    addKey(QKeySequence::Find, [this] {
      search_->setFocus();
      search_->selectAll();
    });
    addKey(QKeySequence::FindNext, [this] { find(false); });
    addKey(QKeySequence::FindPrevious, [this] { find(true); });
    addKey(QKeySequence::Back, [this] { browser_->backward(); });
    addKey(QKeySequence::Forward, [this] { browser_->forward(); });
    addKey(QKeySequence(Qt::Key_Escape), [this] { close(); });

    auto* bar = spaced(new QHBoxLayout, {8, 8, 8, 8});
    addWidgets(bar, {back, forward});
    bar->addStretch(1);
    addWidgets(bar, {not_found_, search_, earlier, later});
    search_->setMinimumWidth(14 * search_->fontMetrics().averageCharWidth() + 120);
    auto* splitter = new QSplitter;
    addWidgets(splitter, {contents_, browser_});
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    auto* layout = spaced(new QVBoxLayout(this), {0, 0, 0, 0}, 0);
    layout->addLayout(bar);
    layout->addWidget(splitter, 1);
    resize(980, 720);
    browser_->setFocus();
    showPage(pages().contains(first_page) ? first_page : pages().front());
    setUpOnce(dress_anew_, 0, this, [this] {
      const int at = browser_->verticalScrollBar()->value();
      browser_->reload();
      browser_->verticalScrollBar()->setValue(at);
    });
  }

  /// The pages' names in the order of the list: "demo", "connect", ...
  static QStringList pages() {
    return {QStringLiteral("demo"),   QStringLiteral("connect"), QStringLiteral("check"),  QStringLiteral("capture"),
            QStringLiteral("graph"),  QStringLiteral("review"),  QStringLiteral("verify"), QStringLiteral("place"),
            QStringLiteral("export"), QStringLiteral("faults"),  QStringLiteral("keys")};
  }
  /// The heading of a page, in the language of the guide; empty if there is no such page.
  static QString titleOf(const QString& page) {
    QFile file(QStringLiteral("%1/%2.md").arg(folder(), page));
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QString first = QString::fromUtf8(file.readLine()).trimmed();
    return first.startsWith(QStringLiteral("# ")) ? first.mid(2) : QString();
  }

  /// Sets the list of the page of keys.
  void setKeys(const QMenuBar& menus) {
    browser_->keys.clear();
    for (const KeyGroup& group : keysOf(menus)) {
      for (const KeyLine& line : group.lines)
        browser_->keys += QStringLiteral("| %1 | %2 |\n").arg(line.keys, line.what);
    }
  }

  /// Nothing happens if there is no such page.
  void showPage(const QString& page) {
    if (!pages().contains(page) || currentPage() == page) return;
    browser_->setSource(urlOf(page));
  }
  [[nodiscard]] QString currentPage() const { return page_; }

 protected:
  void changeEvent(QEvent* event) override {
    QWidget::changeEvent(event);
    // Colours of links are the palette's at the time of reading; one change of theme changes it several times.
    if (event->type() == QEvent::PaletteChange) dressAnew();
  }
  void showEvent(QShowEvent* event) override {
    QWidget::showEvent(event);
    dressAnew();
  }

 private:
  void dressPage() {
    // Markdown says what a paragraph is and not how it looks: room between the lines and around headings.
    const int line = browser_->fontMetrics().height();
    for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next()) {
      QTextCursor cursor(block);
      QTextBlockFormat format;
      format.setLineHeight(125, QTextBlockFormat::ProportionalHeight);
      if (block.blockFormat().headingLevel() > 0) {
        format.setTopMargin(block.blockFormat().headingLevel() == 1 ? 0 : 1.2 * line);
        format.setBottomMargin(0.5 * line);
      } else if (cursor.currentTable() == nullptr) {
        format.setBottomMargin(block.textList() != nullptr ? 0.25 * line : 0.7 * line);
      }
      cursor.mergeBlockFormat(format);
    }
    // Only when the page is complete does the document know its tables.
    browser_->layOut();
    QTextCursor dressing(browser_->document());
    dressing.beginEditBlock();
    for (QTextFrame* frame : browser_->document()->rootFrame()->childFrames()) {
      auto* table = qobject_cast<QTextTable*>(frame);
      if (table == nullptr) continue;
      QTextTableFormat format = table->format();
      format.setBorder(0);
      format.setCellPadding(0.3 * line);
      format.setCellSpacing(0);
      format.setTopMargin(0.4 * line);
      format.setBottomMargin(0.7 * line);
      table->setFormat(format);
    }
    dressing.endEditBlock();
    browser_->verticalScrollBar()->setValue(0);
  }
  /// The page is read again if its links have the colour of another theme; one that nobody sees, when it is shown.
  void dressAnew() {
    if (isVisible() && palette().color(QPalette::Link) != link_color_) dress_anew_.start();
  }
  void followPage(const QUrl& url) {
    page_ = url.fileName().section(QLatin1Char('.'), 0, 0);
    link_color_ = palette().color(QPalette::Link);
    dressPage();
    const int row = pages().indexOf(page_);
    if (row >= 0) contents_->setCurrentRow(row);
  }
  void find(bool backwards) {
    if (search_->text().isEmpty()) return;
    const QTextDocument::FindFlags flags = backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
    bool found = browser_->find(search_->text(), flags);
    if (!found) {
      // Once around.
      browser_->moveCursor(backwards ? QTextCursor::End : QTextCursor::Start);
      found = browser_->find(search_->text(), flags);
    }
    not_found_->setVisible(!found);
  }

  /// The guide's language is that of the window's texts: the translators say which one it is.
  static QString folder() {
    initGuideResources();
    //: The folder of the user guide in this language: a two-letter code.
    const QString language = QCoreApplication::translate("hexoderm::GuideWindow", "en", "language of the user guide");
    const QString path = QStringLiteral(":/hexoderm/guide/%1").arg(language);
    return QFile::exists(path + QStringLiteral("/demo.md")) ? path : QStringLiteral(":/hexoderm/guide/en");
  }

  static QUrl urlOf(const QString& page) { return QUrl(QStringLiteral("qrc%1/%2.md").arg(folder(), page)); }

  static QToolButton* makeButton(const QString& text, const QString& tip, const char* name) {
    auto* button = named(new QToolButton, name, tip);
    button->setText(text);
    button->setToolTip(tip);
    return button;
  }

  QString page_;
  QColor link_color_;
  QTimer dress_anew_;
  QListWidget* contents_ = named(new QListWidget, "guideContents", tr("Pages of the guide"));
  GuideBrowser* browser_ = named(new GuideBrowser, "guidePage", tr("Page of the guide"));
  QLineEdit* search_ = named(new QLineEdit, "guideSearch");
  QLabel* not_found_ = named(new QLabel(tr("not found")), "guideNotFound");
};

/// The page about what is to be done now.
inline QString guidePageFor(const SessionController& controller) {
  if (controller.liveSession().source().isRunning() && !controller.liveSession().isLive())
    return QStringLiteral("connect");
  if (controller.isEmpty()) return QStringLiteral("demo");
  const Reconstruction* result = controller.reconstruction().get();
  if (!result) return QStringLiteral("check");
  if (controller.liveSession().wantsMorePoses()) return QStringLiteral("capture");
  const bool has_faults = std::ranges::any_of(
      result->findings, [](Severity severity) { return severity != Severity::Info; }, &Finding::severity);
  if (has_faults) return QStringLiteral("faults");
  const bool waits_for_places = controller.session() && controller.session()->robot() && placedPatches(*result).empty();
  return waits_for_places ? QStringLiteral("place") : QStringLiteral("export");
}

}  // namespace hexoderm
