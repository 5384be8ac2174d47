#pragma once

#include <gmock/gmock.h>
#include <QApplication>

#include <memory>

namespace hexoderm {

/// One application for all tests of a program, made after GoogleTest has read the command line (listing tests must not
/// need a display).
class QtEnvironment : public testing::Environment {
 public:
  void SetUp() override {
    QApplication::setStyle(QStringLiteral("Fusion"));
    application_ = std::make_unique<QApplication>(argc_, argv_);
  }
  void TearDown() override { application_.reset(); }

 private:
  int argc_ = 1;
  char name_[16] = "hexoderm_test";
  char* argv_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

}  // namespace hexoderm
