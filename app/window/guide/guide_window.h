#pragma once

#include <QColor>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QStringList>
#include <QTimer>
#include <QWidget>

class QMenuBar;

namespace hexoderm {

class GuideBrowser;
class SessionController;

/// The user guide in a window of its own: a list of its pages, the page, search within it, back and forward. The pages
/// are Markdown in the program's resources (resources/guide), one folder for each language; where the language of the
/// window has none, English ones.
class GuideWindow : public QWidget {
  Q_OBJECT

 public:
  /// Begins with `first_page`, or with the first one if there is no such page.
  explicit GuideWindow(QWidget* parent = nullptr, const QString& first_page = {});

  /// The pages' names in the order of the list: "demo", "connect", ...
  static QStringList pages();
  /// The heading of a page, in the language of the guide; empty if there is no such page.
  static QString titleOf(const QString& page);

  /// Sets the list of the page of keys.
  void setKeys(const QMenuBar& menus);

  /// Nothing happens if there is no such page.
  void showPage(const QString& page);
  [[nodiscard]] QString currentPage() const { return page_; }

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void dressPage();
  /// The page is read again if its links have the colour of another theme; one that nobody sees, when it is shown.
  void dressAnew();
  void followPage(const QUrl& url);
  void find(bool backwards);

  QString page_;
  QColor link_color_;
  QTimer dress_anew_;
  QListWidget* contents_ = new QListWidget;
  GuideBrowser* browser_;
  QLineEdit* search_ = new QLineEdit;
  QLabel* not_found_ = new QLabel;
};

/// The page about what is to be done now.
QString guidePageFor(const SessionController& controller);

}  // namespace hexoderm
