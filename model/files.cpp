// Reads and writes whole files.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "model/json.h"
#include "model/output_error.h"
#include "model/source_text.h"

namespace touchstone {
namespace {

constexpr const char* cannot_write = "cannot write";

bool is_a_fault_of_the_disk(int error) {
  return error == ENOSPC || error == EDQUOT || error == EFBIG || error == EIO || error == EPIPE;
}

[[noreturn]] void refuse(const std::string& path, const std::string& doing) {
  const int error = errno;
  const std::string what = doing + ": " + std::strerror(error);
  if (doing == cannot_write && is_a_fault_of_the_disk(error)) throw OutputError(path, what);
  throw InputError(path, what);
}

class File {
 public:
  /// Messages name `path`, even while the text is being written to another file in its place.
  File(const std::string& file, int flags, const std::string& path, const std::string& doing)
      : path_(path), doing_(doing), descriptor_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) refuse(path_, doing_);
  }
  /// Takes over an open descriptor.
  File(int descriptor, const std::string& path, const std::string& doing)
      : path_(path), doing_(doing), descriptor_(descriptor) {
    if (descriptor_ < 0) refuse(path_, doing_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  /// Returns 0 at the end of the file.
  std::size_t read(char* to, std::size_t size) {
    ssize_t got = -1;
    do got = ::read(descriptor_, to, size);
    while (got < 0 && errno == EINTR);
    if (got < 0) refuse(path_, doing_);
    return static_cast<std::size_t>(got);
  }

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t put = ::write(descriptor_, text.data(), text.size());
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) refuse(path_, doing_);
      text.remove_prefix(static_cast<std::size_t>(put));
    }
  }

  void sync_and_close() {
    if (::fsync(descriptor_) != 0) refuse(path_, doing_);
    if (::close(std::exchange(descriptor_, -1)) != 0) refuse(path_, doing_);
  }

 private:
  std::string path_;
  std::string doing_;
  int descriptor_;
};

/// A unique name beside `path`, since other processes and threads may be writing the same file.
std::string name_beside(const std::string& path) {
  static std::atomic<unsigned> count = 0;
  return path + ".part-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
}

bool is_device_or_pipe(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

[[noreturn]] void refuse_size(const std::string& path, const std::string& has) {
  throw InputError(path, "has " + has + "; at most " + std::to_string(largest_text_bytes / 1'000'000) + " MB are read");
}

/// Checks the file before it is opened: opening a pipe waits for a writer, and opening a device may have side effects.
void require_plain(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) refuse(path, "cannot read");
  if (!S_ISREG(status.st_mode)) {
    throw InputError(
        path, std::string("is ") + kind_of(status.st_mode) + "; expected a plain file, or - to read standard input");
  }
  const auto bytes = static_cast<std::size_t>(status.st_size);
  if (bytes > largest_text_bytes) refuse_size(path, std::to_string(bytes / 1'000'000) + " MB");
}

/// Reads up to the end of the file. Refuses an endless input once it has become too large.
std::string read_all(File& file, const std::string& path) {
  std::string text;
  constexpr std::size_t chunk = 1 << 16;
  for (std::size_t got = 1; got > 0;) {
    const std::size_t before = text.size();
    text.resize(before + chunk);
    got = file.read(text.data() + before, chunk);
    text.resize(before + got);
    if (text.size() > largest_text_bytes) refuse_size(path, "more");
  }
  return text;
}

}  // namespace

std::string read_text(const std::string& path) {
  const std::string doing = "cannot read";
  if (path == "-") {
    File standard_input(::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0), "<stdin>", doing);
    return read_all(standard_input, "<stdin>");
  }
  require_plain(path);
  // O_NONBLOCK: the file may have been replaced by a pipe since the check; then open() must not wait.
  File file(path, O_RDONLY | O_NONBLOCK, path, doing);
  return read_all(file, path);
}

Scene read_scene(const std::string& path) {
  const SourceText source = read_source(path);
  return scene_from(source.text, source.name);
}

void write_text(const std::string& path, std::string_view text) {
  if (is_device_or_pipe(path)) {
    File(path, O_WRONLY, path, cannot_write).write(text);
    return;
  }
  const std::string part = name_beside(path);
  try {
    File file(part, O_WRONLY | O_CREAT | O_EXCL, path, cannot_write);
    file.write(text);
    file.sync_and_close();
    if (std::rename(part.c_str(), path.c_str()) != 0) refuse(path, cannot_write);
  } catch (const std::runtime_error&) {
    ::unlink(part.c_str());
    throw;
  }
}

}  // namespace touchstone
