#pragma once

#include "hexoderm/device/skin_source.h"

#include <chrono>
#include <memory>

namespace hexoderm {

/// A skin on standard input, or on any other file descriptor: lines of JSON, or frames as on TCP. It can't be asked for
/// anything, so every command fails. The end of the input is the end of the source (Ended); it is never opened again.
class StdinSource final : public SkinSource {
 public:
  /// `descriptor` is neither closed nor changed, and must stay open until stop().
  explicit StdinSource(int descriptor = 0, std::chrono::milliseconds silent_after = kSilentAfter);
  ~StdinSource() override;
  StdinSource(const StdinSource&) = delete;
  StdinSource& operator=(const StdinSource&) = delete;

  void start(SkinListener& listener) override;
  void stop() noexcept override;
  std::uint32_t send(const SkinCommand& command) override;
  [[nodiscard]] std::string address() const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hexoderm
