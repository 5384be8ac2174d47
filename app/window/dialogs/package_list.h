#pragma once

#include "app/window/session/result_files.h"

#include <QListWidget>

namespace hexoderm {

/// The files that a package can hold, to be ticked: reports, Hexoderm's own file, and every export format. Remembers
/// what was ticked, from one dialog to the next.
class PackageList : public QListWidget {
  Q_OBJECT

 public:
  explicit PackageList(QWidget* parent = nullptr);

  /// The ticked ones; path and options are left empty.
  [[nodiscard]] PackageRequest request() const;
  /// For the next dialog.
  void keepChoice() const;

 private:
  struct Row {
    QString name;  ///< in the settings
    QString text;
    QString what;
  };
  void add(const Row& row);
  [[nodiscard]] QStringList ticked() const;
};

/// What each file of a package holds, in which frame, and what it can't hold, as rich text.
QString packageInWords(const std::vector<PackageEntry>& entries);

}  // namespace hexoderm
