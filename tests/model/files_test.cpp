#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "model/output_error.h"
#include "model/source_text.h"
#include "tests/catch.h"

namespace touchstone {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

class Folder {
 public:
  Folder() { fs::create_directories(path_); }
  ~Folder() { fs::remove_all(path_); }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  auto count() const { return std::distance(fs::directory_iterator(path_), fs::directory_iterator()); }

 private:
  fs::path path_ = fs::temp_directory_path() / ("touchstone_files_test_" + std::to_string(::getpid()));
};

/// During its lifetime, writing a file beyond `bytes` fails (EFBIG): a simulated full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_CASE("text comes back as it was written") {
  const Folder folder;
  std::string text = "a\0b\r\n"s;
  text.append(200'000, 'x');
  write_text(folder / "new", text);
  CHECK(read_text(folder / "new") == text);
  write_text(folder / "new", "");
  CHECK(read_text(folder / "new").empty());
  CHECK(folder.count() == 1);
}

TEST_CASE("a failed write leaves the old file and nothing else") {
  const Folder folder;
  write_text(folder / "kept", "old");
  {
    const SmallDisk small(10'000);
    CHECK_THROWS_WITH(write_text(folder / "kept", std::string(20'000, 'x')),
                      (folder / "kept") + ": cannot write: File too large");
    CHECK_THROWS_AS(write_text(folder / "kept", std::string(20'000, 'x')), OutputError);
  }
  CHECK(read_text(folder / "kept") == "old");
  CHECK(folder.count() == 1);
}

TEST_CASE("files that cannot be are refused by name") {
  const Folder folder;
  CHECK_THROWS_WITH(read_text(folder / "none"), (folder / "none") + ": cannot read: No such file or directory");
  CHECK_THROWS_WITH(read_text(folder / "."),
                    (folder / ".") + ": is a folder; expected a plain file, or - to read standard input");
  CHECK_THROWS_WITH(write_text(folder / "none/x", "x"),
                    (folder / "none/x") + ": cannot write: No such file or directory");
  CHECK_THROWS_WITH(read_scene(folder / "none"), (folder / "none") + ": cannot read: No such file or directory");
  CHECK_THROWS_AS(write_text(folder / ".", "x"), InputError);
  CHECK(folder.count() == 0);
}

TEST_CASE("what may never end, or never begin, is not read") {
  const Folder folder;
  const std::string pipe = folder / "pipe", large = folder / "large";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_WITH(read_text(pipe), pipe + ": is a pipe; expected a plain file, or - to read standard input");
  CHECK_THROWS_WITH(read_text("/dev/zero"),
                    "/dev/zero: is a device; expected a plain file, or - to read standard input");
  write_text(large, "");
  fs::resize_file(large, 300'000'000);  // sparse: takes no room
  CHECK_THROWS_WITH(read_text(large), large + ": has 300 MB; at most 100 MB are read");
}

TEST_CASE("a byte order mark is no part of the text") {
  const Folder folder;
  const std::string file = folder / "marked";
  write_text(file, "\xEF\xBB\xBFtext");
  CHECK(read_source(file).text == "text");
  for (const std::string mark : {"\xFF\xFE", "\xFE\xFF"}) {
    write_text(file, mark + "t");
    CHECK_THROWS_WITH(read_source(file), file + ": text in UTF-16; expected UTF-8: save it as that");
  }
}

TEST_CASE("a device is written in place") {
  write_text("/dev/null", "x");
  CHECK(fs::is_character_file("/dev/null"));
  CHECK_THROWS_WITH(write_text("/dev/full", "x"), "/dev/full: cannot write: No space left on device");
  CHECK_THROWS_AS(write_text("/dev/full", "x"), OutputError);
}

}  // namespace
}  // namespace touchstone
