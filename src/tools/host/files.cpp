#include "host/files.h"

#include <fstream>
#include <sstream>

#include "host/host.h"

namespace carom::tools {

std::string read_file(const std::string& path, const std::string& remedy) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw Error("cannot read " + path, remedy);
  return text.str();
}

void write_file(const std::string& path, const std::string& content) {
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file) throw Error("cannot write " + path, "check that its folder exists and is writable, and that the disk has room");
}

}  // namespace carom::tools
