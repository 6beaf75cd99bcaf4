#include "host/drawings.h"

#include <cstdio>

#include "host/files.h"
#include "host/host.h"
#include "host/system.h"

namespace carom::tools {
namespace {

/// A file that is gone when this is.
class PassingFile {
 public:
  PassingFile(std::string path, const std::string& content) : path_(std::move(path)) { write_file(path_, content); }
  ~PassingFile() { std::remove(path_.c_str()); }
  PassingFile(const PassingFile&) = delete;
  PassingFile& operator=(const PassingFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

void draw_png(const std::string& path, const std::string& svg) {
  const PassingFile source(path + ".svg.part", svg);
  const int status = run_program({"rsvg-convert", "--zoom", "2", "--output", path, source.path()});
  if (status == kNoProgram)
    throw Error("cannot write " + path + ": the command rsvg-convert, which draws PNG, is not there",
                "install it (Debian: apt-get install librsvg2-bin), or name a file that ends in .svg");
  if (status != 0)
    throw Error("cannot write " + path + ": rsvg-convert gave up",
                "check that its folder is writable and the disk has space, or name a file that ends in .svg");
}

}  // namespace

void check_drawing_path(const std::string& path) {
  if (!path.ends_with(".svg") && !path.ends_with(".png"))
    throw Error("'" + path + "' does not say which kind of drawing to write", "end the name in .svg or .png");
  check_output(path);
}

void write_drawing(const std::string& path, const std::string& svg) {
  check_drawing_path(path);
  if (path.ends_with(".png"))
    draw_png(path, svg);
  else
    write_file(path, svg);
}

}  // namespace carom::tools
