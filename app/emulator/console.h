#pragma once

#include "app/emulator/emulator.h"

#include <array>
#include <functional>
#include <string>
#include <thread>

namespace hexoderm::emulator {

/// The list of lines that can be typed while the emulator runs.
std::string consoleHelp();

/// Does one line, and returns what to say about it; empty for an empty line. Throws InvalidArgument for what can't be
/// understood or done.
std::string runLine(const std::string& line, Emulator& emulator);

/// Reads lines of standard input on a thread of its own. Not by Asio: it would make the descriptor non-blocking for
/// every program that shares the terminal.
class LineReader {
 public:
  /// `take` is called on the reader's thread. The end of the input is no reason to end.
  explicit LineReader(std::function<void(std::string)> take);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

 private:
  void run();

  std::function<void(std::string)> take_;
  std::array<int, 2> wake_{-1, -1};
  std::thread thread_;
};

}  // namespace hexoderm::emulator
