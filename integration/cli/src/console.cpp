#include "console.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace conceptplan::cli {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Letters of UTF-8 text: the bytes that do not continue one.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0u) != 0x80u;
  }));
}

}  // namespace

/// The state of one progress display.
class ProgressMeter {
 public:
  ProgressMeter(Console& console, std::string label)
      : console_(console), label_(std::move(label)), terminal_(::isatty(STDERR_FILENO) == 1) {}

  void show(std::size_t done, std::size_t total, double share, std::string_view note) {
    const std::lock_guard lock(console_.mutex_);
    if (console_.quiet_) return;
    if (!total_) shown_ = Clock::now();
    if (total_ != total) {  // work before, of an earlier run or a lesser total, tells no speed
      total_ = total;
      first_share_ = share;
      start_ = Clock::now();
      return;
    }
    const bool last = done >= total;
    const double pause_s = terminal_ ? 0.2 : 10.0;
    if (secondsSince(start_) < 1.0 || (!last && secondsSince(shown_) < pause_s) || finished_) {
      return;
    }
    shown_ = Clock::now();
    finished_ = last;
    std::string line = lineText(done, total, share);
    if (!note.empty()) line += "  " + std::string(note);
    if (!terminal_) {
      console_.writeError(line + "\n");
      return;
    }
    console_.writeError("\r" + line + "\x1b[K" + (last ? "\n" : ""));
    console_.bar_shown_ = !last;
  }

 private:
  std::string lineText(std::size_t done, std::size_t total, double share) const {
    static constexpr std::size_t kBarWidth = 24;
    std::string line = label_ + "  ";
    if (terminal_) {
      const auto filled = static_cast<std::size_t>(std::lround(share * kBarWidth));
      line += "[" + std::string(filled, '#') + std::string(kBarWidth - filled, '.') + "]  ";
    }
    line += std::to_string(done) + "/" + std::to_string(total);
    const double elapsed_s = secondsSince(start_);
    if (done >= total) return line + "  done in " + durationText(elapsed_s);
    if (share > first_share_)
      line += "  " + durationText(elapsed_s * (1 - share) / (share - first_share_)) + " left";
    return line;
  }

  Console& console_;
  std::string label_;
  bool terminal_;
  std::optional<std::size_t> total_;
  bool finished_ = false;
  double first_share_ = 0;
  Clock::time_point start_;
  Clock::time_point shown_;
};

void Console::print(std::string_view text) {
  if (json_) return;
  const std::lock_guard lock(mutex_);
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fputc('\n', stdout);
  std::fflush(stdout);
}

void Console::print(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const auto& row : table) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  for (const auto& row : table) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line += std::string(widths[i] - width(row[i]) + 2, ' ');
    }
    print(line);
  }
}

void Console::printJson(const Json& document) {
  if (!json_) return;
  const std::string text = document.dump(2, ' ', false, Json::error_handler_t::replace);
  const std::lock_guard lock(mutex_);
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fputc('\n', stdout);
  std::fflush(stdout);
}

void Console::message(std::string_view text) {
  if (!quiet_) error(text);
}

void Console::error(std::string_view text) {
  const std::lock_guard lock(mutex_);
  if (bar_shown_) writeError("\r\x1b[K");
  bar_shown_ = false;
  writeError(std::string(text) + "\n");
}

Progress Console::progress(std::string label) {
  return Progress(std::make_shared<ProgressMeter>(*this, std::move(label)));
}

void Progress::operator()(std::size_t done, std::size_t total, std::string_view note,
                          std::optional<double> share) const {
  const double evenly = total == 0 ? 1 : static_cast<double>(done) / static_cast<double>(total);
  meter_->show(done, total, share.value_or(evenly), note);
}

void Console::writeError(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

std::string durationText(double seconds) {
  const auto whole = static_cast<long>(std::lround(std::max(0.0, seconds)));
  const auto twoDigits = [](long value) { return (value < 10 ? "0" : "") + std::to_string(value); };
  if (whole >= 3600) {
    return std::to_string(whole / 3600) + " h " + twoDigits(whole / 60 % 60) + " min";
  }
  if (whole >= 60) return std::to_string(whole / 60) + " min " + twoDigits(whole % 60) + " s";
  return std::to_string(whole) + " s";
}

std::string decimal(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

}  // namespace conceptplan::cli
