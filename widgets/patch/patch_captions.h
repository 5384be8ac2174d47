#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>

namespace hexoderm {

/// The texts over the 3D scene: a line for each thing drawn over the cells, the word beside
/// the gravity arrow, and a hint if there is nothing to see. Lets the mouse through.
class PatchCaptions : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString hint;          ///< instead of everything else, where not empty
    bool gravity = false;  ///< the arrow is there
    QStringList notes;
    QString message;  ///< the message of a tool; emphasised above the notes
    QString legend;   ///< in words, for screen readers
  };

  explicit PatchCaptions(QWidget* parent = nullptr);

  void setContent(const Content& content);
  /// Kept free for the buttons.
  void setTopMargin(int pixels);
  /// Down to here the notes reach, which stay while the picture does; 0 if there are none. In pixels.
  [[nodiscard]] int notesBottom() const;
  /// Paints the same texts into a screenshot of the given size.
  void paint(QPainter& painter, const QSize& area) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintNotes(QPainter& painter, const QSize& area) const;

  Content content_;
  int top_margin_ = 0;
};

}  // namespace hexoderm
