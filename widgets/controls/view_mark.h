#pragma once

#include "widgets/controls/banner.h"

#include <QWidget>
#include <optional>

namespace hexoderm {

/// Marks a view whose picture is not what it usually is: of this moment, without readings, preliminary, or from
/// before. A frame around the view, words at its upper edge, and a veil over a picture that is no result of now. Lies
/// over the view, lets the mouse through, and is hidden where there is nothing to mark.
class ViewMark : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    Tone tone = Tone::Neutral;
    QString words;
    bool has_frame = true;
    bool is_muted = false;  ///< a veil lies over the picture

    bool operator==(const Content& other) const {
      return tone == other.tone && words == other.words && has_frame == other.has_frame && is_muted == other.is_muted;
    }
  };

  /// Lies over `view`, which owns it, as large as that is.
  explicit ViewMark(QWidget* view);

  /// None: nothing is marked.
  void setContent(const std::optional<Content>& content);
  [[nodiscard]] const std::optional<Content>& content() const { return content_; }
  /// What of the top is kept free for buttons, and whether the words stand on the right instead of in the middle.
  void setPlace(int top_margin, bool at_right);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<Content> content_;
  int top_margin_ = 0;
  bool at_right_ = false;
};

}  // namespace hexoderm
