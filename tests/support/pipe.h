#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace hexoderm::test {

/// What is written into end 1 is read from end 0.
struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    closeEnd(0);
    closeEnd(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void closeEnd(std::size_t which) {
    if (ends.at(which) >= 0) ::close(std::exchange(ends.at(which), -1));
  }
  void write(const std::string& text) const {
    if (::write(ends[1], text.data(), text.size()) < 0) throw std::runtime_error("nothing is read");
  }
  /// Until nobody could write another byte.
  void fill() const {
    ::fcntl(ends[1], F_SETFL, O_NONBLOCK);
    const std::array<char, 4096> bytes{};
    while (::write(ends[1], bytes.data(), bytes.size()) > 0) continue;
    while (::write(ends[1], bytes.data(), 1) > 0) continue;
    ::fcntl(ends[1], F_SETFL, 0);
  }

  std::array<int, 2> ends{-1, -1};
};

}  // namespace hexoderm::test
