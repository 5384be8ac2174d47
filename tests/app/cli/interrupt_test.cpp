// Ctrl+C ends the programs whatever holds them up: each row of the table holds one up in a way of its own.

#include "hexoderm/io/calibration_json.h"

#include "tests/support/paths.h"
#include "tests/support/patience.h"
#include "tests/support/temporary_folder.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

using testing::HasSubstr;

struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) ::close(end);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void closeEnd(int which) { ::close(std::exchange(ends.at(static_cast<std::size_t>(which)), -1)); }
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

/// A program with a pipe for each of its standard streams, in a folder of its own.
class Started {
 public:
  enum class Read { Yes, Never };

  Started(std::vector<std::string> words, const std::string& folder, Read out = Read::Yes, Read err = Read::Yes) {
    if (out == Read::Never) out_.fill();
    if (err == Read::Never) err_.fill();
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(in_.ends[0], STDIN_FILENO);
      ::dup2(out_.ends[1], STDOUT_FILENO);
      ::dup2(err_.ends[1], STDERR_FILENO);
      // As in a terminal, not as behind the & of a script.
      ::signal(SIGINT, SIG_DFL);
      if (::chdir(folder.c_str()) != 0) ::_exit(126);
      ::execv(arguments[0], arguments.data());
      ::_exit(127);
    }
    in_.closeEnd(0);
    out_.closeEnd(1);
    err_.closeEnd(1);
  }
  ~Started() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;

  void write(const std::string& text) const {
    if (::write(in_.ends[1], text.data(), text.size()) < 0) throw std::runtime_error("nothing is read");
  }
  /// Reads until the text has come.
  std::string readLine() {
    std::string line;
    for (char c = 0; ::read(out_.ends[0], &c, 1) == 1 && c != '\n';) line += c;
    return line;
  }
  void waitForOutput(const std::string& text) { waitFor(text, out_.ends[0]); }
  void waitForError(const std::string& text) { waitFor(text, err_.ends[0]); }
  /// As a terminal does for Ctrl+C.
  void interrupt() const { ::kill(process_, SIGINT); }

  struct End {
    bool has_ended = false;
    int exit_code = -1;  ///< 128 and its number, if a signal ended it
  };
  End wait() {
    const auto until = std::chrono::steady_clock::now() + test::kPatience;
    int status = 0;
    while (::waitpid(process_, &status, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > until) return {};
      ::poll(nullptr, 0, 5);
    }
    process_ = -1;
    return {true, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
  }
  /// Sleeps in the kernel, or has ended: it does nothing by itself any more.
  void waitUntilIdle() const {
    const auto until = std::chrono::steady_clock::now() + test::kPatience;
    int idle = 0;
    while (idle < 10 && std::chrono::steady_clock::now() < until) {
      std::ifstream file("/proc/" + std::to_string(process_) + "/stat");
      std::string line;
      std::getline(file, line);
      const std::size_t state = line.rfind(')');
      idle = state != std::string::npos && line.at(state + 2) != 'R' ? idle + 1 : 0;
      ::poll(nullptr, 0, 5);
    }
  }

 private:
  static void waitFor(const std::string& text, int from) {
    std::string all;
    for (char c = 0; all.find(text) == std::string::npos; all += c) {
      if (::read(from, &c, 1) != 1) throw std::runtime_error("ended after: " + all);
    }
  }

  Pipe in_, out_, err_;
  pid_t process_ = -1;
};

/// Listens and accepts, and says nothing.
class SilentServer {
 public:
  SilentServer() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(at);
    auto* const address = static_cast<sockaddr*>(static_cast<void*>(&at));
    if (::bind(socket_, address, size) != 0 || ::listen(socket_, 8) != 0 ||
        ::getsockname(socket_, address, &size) != 0) {
      throw std::runtime_error("no socket");
    }
    port_ = ntohs(at.sin_port);
  }
  ~SilentServer() { ::close(socket_); }
  SilentServer(const SilentServer&) = delete;
  SilentServer& operator=(const SilentServer&) = delete;
  [[nodiscard]] std::string address() const { return "tcp://127.0.0.1:" + std::to_string(port_); }
  void waitForCaller() const {
    pollfd waiting{socket_, POLLIN, 0};
    ::poll(&waiting, 1, -1);
  }

 private:
  int socket_ = -1;
  unsigned port_ = 0;
};

int connectTo(std::uint16_t port) {
  const int host = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(host, static_cast<const sockaddr*>(static_cast<const void*>(&to)), sizeof(to)) != 0) {
    throw std::runtime_error("no connection");
  }
  return host;
}

constexpr int kByForce = 130;

struct Case {
  std::string name;
  /// The program's end: its own (0, 1 or 4), or by force.
  std::vector<int> exit_codes;
  std::function<Started::End(const std::string& folder)> run;
};

Started::End interruptWhenIdle(std::vector<std::string> words, const std::string& folder,
                               Started::Read out = Started::Read::Yes) {
  Started program(std::move(words), folder, out);
  program.waitUntilIdle();
  program.interrupt();
  return program.wait();
}

std::string fifoIn(const std::string& folder, const std::string& name) {
  if (::mkfifo((folder + "/" + name).c_str(), 0600) != 0) throw std::runtime_error("no pipe with a name");
  return name;
}

/// Runs to its end; the files it makes are there.
void prepare(const std::string& command, const std::string& folder) {
  if (std::system(("cd '" + folder + "' && '" HEXODERM_CLI "' " + command + " >/dev/null 2>&1").c_str()) != 0) {
    throw std::runtime_error(command);
  }
}

std::string rowOfCells(int count) {
  std::string lines = "{\"hello\": {\"device\": \"row\", \"cell_model\": \"hex-bma150\"}}\n";
  lines += R"({"topology": {"id": 1, "cells": [)";
  for (int k = 1; k <= count; ++k) {
    lines += (k > 1 ? "," : "") + std::string(R"({"id": )") + std::to_string(k) + R"(, "ports": [)";
    if (k < count) lines += R"({"port": 1, "cell": )" + std::to_string(k + 1) + R"(, "cell_port": 3})";
    if (k > 1)
      lines += (k < count ? "," : "") + std::string(R"({"port": 3, "cell": )") + std::to_string(k - 1) +
               R"(, "cell_port": 1})";
    lines += "]}";
  }
  return lines + "]}}\n";
}

std::vector<std::string> cli(std::vector<std::string> words) {
  words.insert(words.begin(), HEXODERM_CLI);
  return words;
}
std::vector<std::string> emulator(std::vector<std::string> words) {
  words.insert(words.begin(), HEXODERM_EMULATOR);
  return words;
}

std::vector<Case> cases() {
  using Read = Started::Read;
  return {
      {"CaptureFromADeviceThatSaysNothing",
       {4},
       [](const std::string& folder) {
         const SilentServer device;
         Started program(cli({"capture", "--source", device.address(), "-o", "a.hexo"}), folder);
         device.waitForCaller();
         program.interrupt();
         return program.wait();
       }},
      {"CaptureFromANameThatIsLookedUp",
       {4},
       [](const std::string& folder) {
         return interruptWhenIdle(cli({"capture", "--source", "tcp://nobody.invalid:7700", "-o", "a.hexo"}), folder);
       }},
      {"CaptureFromStandardInputWithoutAWord",
       {4},
       [](const std::string& folder) {
         return interruptWhenIdle(cli({"capture", "--source", "stdin", "-o", "a.hexo"}), folder);
       }},
      {"CaptureFromASerialPortWithoutAWord",
       {4},
       [](const std::string& folder) {
         const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
         if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) throw std::runtime_error("no pty");
         const std::string source = std::string("serial:") + ::ptsname(terminal);
         const Started::End end = interruptWhenIdle(cli({"capture", "--source", source, "-o", "a.hexo"}), folder);
         ::close(terminal);
         return end;
       }},
      {"CaptureFromARecordingThatNobodyWrites",
       {kByForce},
       [](const std::string& folder) {
         const std::string fifo = fifoIn(folder, "in.skinrec");
         return interruptWhenIdle(cli({"capture", "--source", "replay:" + fifo, "-o", "a.hexo"}), folder);
       }},
      {"CaptureIntoARecordingThatNobodyReads",
       {kByForce},
       [](const std::string& folder) {
         const std::string fifo = fifoIn(folder, "out.skinrec");
         return interruptWhenIdle(cli({"capture", "--source", "sim:x17", "--record", fifo, "-o", "a.hexo"}), folder);
       }},
      {"CaptureWhileTheStreamRunsAtFullSpeed",
       {0, 1},
       [](const std::string& folder) {
         Started program(cli({"capture", "--source", "sim:x17?speed=max", "--keep-raw", "-o", "a.hexo"}), folder);
         program.waitForError("Pose 1 captured");
         program.interrupt();
         return program.wait();
       }},
      {"CaptureWhoseResultNobodyReads",
       {kByForce},
       [](const std::string& folder) {
         Started program(cli({"capture", "--source", "sim:x17?speed=max", "--auto", "--poses", "2", "-o", "a.hexo"}),
                         folder, Read::Never);
         program.waitForError("Pose 2 captured");
         program.interrupt();
         return program.wait();
       }},
      {"CaptureWhoseRemarksNobodyReads",
       {kByForce},
       [](const std::string& folder) {
         Started program(cli({"capture", "--source", "sim:x17", "-o", "a.hexo"}), folder, Read::Yes, Read::Never);
         program.waitUntilIdle();
         program.interrupt();
         return program.wait();
       }},
      {"CaptureThatIsSolvingAHugeSkin",
       {0, 1, kByForce},
       [](const std::string& folder) {
         Started program(cli({"capture", "--source", "stdin", "-o", "a.hexo"}), folder);
         program.write(rowOfCells(8'000));
         program.waitForError("8000 cells");
         program.interrupt();
         return program.wait();
       }},
      {"SolveOfAFileThatNobodyWrites",
       {kByForce},
       [](const std::string& folder) {
         const std::string fifo = fifoIn(folder, "in.session.json");
         return interruptWhenIdle(cli({"solve", fifo}), folder);
       }},
      {"SolveWhoseResultNobodyReads",
       {kByForce},
       [](const std::string& folder) {
         prepare("simulate -o a.session.json", folder);
         return interruptWhenIdle(cli({"solve", "a.session.json", "--json"}), folder, Read::Never);
       }},
      {"SolveInTheMiddleOfIt",
       {kByForce},
       [](const std::string& folder) {
         prepare("simulate --patch sheet:30x30 --poses 4 -o a.session.json", folder);
         Started program(cli({"solve", "a.session.json"}), folder);
         program.interrupt();
         return program.wait();
       }},
      {"SolveOfManySessionsInTheMiddleOfIt",
       {kByForce},
       [](const std::string& folder) {
         prepare("simulate -o a.session.json", folder);
         prepare("simulate --patch sheet:30x30 --poses 4 -o b.session.json", folder);
         std::vector<std::string> words = cli({"solve", "-o", "out"});
         words.emplace_back("a.session.json");
         for (int k = 0; k < 50; ++k) words.emplace_back("b.session.json");
         Started program(std::move(words), folder);
         program.waitForOutput("out/a.calibration.json");
         program.interrupt();
         return program.wait();
       }},
      {"SolveOfManySessionsOfWhichNobodyWritesOne",
       {kByForce},
       [](const std::string& folder) {
         const std::string fifo = fifoIn(folder, "in.session.json");
         prepare("simulate -o a.session.json", folder);
         Started program(cli({"solve", "a.session.json", fifo, "-o", "out"}), folder);
         program.waitForOutput("out/a.calibration.json");
         program.interrupt();
         return program.wait();
       }},
      {"ConvertOfAFileThatNobodyWrites",
       {kByForce},
       [](const std::string& folder) {
         const std::string fifo = fifoIn(folder, "in.session.json");
         return interruptWhenIdle(cli({"convert", fifo, "-o", "a.hexo"}), folder);
       }},
      {"ExportOfAFileThatNobodyWrites",
       {kByForce},
       [](const std::string& folder) {
         const std::string fifo = fifoIn(folder, "in.calibration.json");
         return interruptWhenIdle(cli({"export", fifo, "--to", "urdf", "-o", "a.urdf"}), folder);
       }},
      {"ReproduceInTheMiddleOfIt",
       {kByForce},
       [](const std::string& folder) {
         Started program(cli({"reproduce"}), folder);
         program.interrupt();
         return program.wait();
       }},
      {"EmulatorWithAHostThatDoesNotRead",
       {0},
       [](const std::string& folder) {
         Started program(emulator({"--tcp", "0", "--patch", "sheet:15x20", "--speed", "50"}), folder);
         const std::string line = program.readLine();
         const int host = connectTo(static_cast<std::uint16_t>(std::stoul(line.substr(line.rfind(':') + 1))));
         program.waitForOutput("messages\n");
         char byte = 0;
         EXPECT_EQ(::recv(host, &byte, 1, 0), 1) << "it is served";
         program.interrupt();
         const Started::End end = program.wait();
         ::close(host);
         return end;
       }},
      {"EmulatorWhoseAnswersNobodyReads",
       {kByForce},
       [](const std::string& folder) {
         Started program(emulator({"--tcp", "0"}), folder);
         program.waitForOutput("messages\n");
         for (int k = 0; k < 100; ++k) program.write("help\n");  // a kilobyte each, more than a pipe holds
         program.waitUntilIdle();
         program.interrupt();
         return program.wait();
       }},
  };
}

class Interrupt : public testing::TestWithParam<Case> {};

TEST_P(Interrupt, EndsTheProgram) {
  const test::TemporaryFolder folder;
  const Started::End end = GetParam().run(folder.path().string());
  ASSERT_TRUE(end.has_ended);
  EXPECT_THAT(GetParam().exit_codes, testing::Contains(end.exit_code));
}

INSTANTIATE_TEST_SUITE_P(WhateverHoldsItUp, Interrupt, testing::ValuesIn(cases()),
                         [](const auto& row) { return row.param.name; });

TEST(InterruptTwice, EndsAtOnceAndSaysWhatIsKept) {
  const test::TemporaryFolder folder;
  Started program(cli({"capture", "--source", "sim:x17?speed=max", "--auto", "--poses", "2", "-o", "a.hexo"}),
                  folder.path().string(), Started::Read::Never);
  program.waitForError("Pose 2 captured");
  program.interrupt();
  program.interrupt();
  program.waitForError("is in the file");
  EXPECT_EQ(program.wait().exit_code, kByForce);
}

TEST(InterruptOfManySessions, LeavesWhatIsWrittenWhole) {
  const test::TemporaryFolder folder;
  const std::string in = folder.path().string();
  prepare("simulate --patch sheet:10x10 --poses 3 -o a.session.json", in);
  std::vector<std::string> words = cli({"solve", "-o", "out", "--jobs", "2"});
  words.insert(words.end(), 1000, "a.session.json");
  Started program(std::move(words), in);
  program.waitForOutput("out/a-3.calibration.json");
  program.interrupt();
  program.waitForError("nterrupted");  // in order, with how many were solved, or on a busy computer by force
  EXPECT_EQ(program.wait().exit_code, kByForce);
  std::size_t written = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out")) {
    EXPECT_NO_THROW(readCalibrationJson(entry.path())) << entry.path();
    ++written;
  }
  EXPECT_GE(written, 3U);
  EXPECT_LT(written, 1000U);
}

}  // namespace
}  // namespace hexoderm
