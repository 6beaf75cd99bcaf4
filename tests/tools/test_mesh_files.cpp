// Mesh files: the same solid in every format, and bytes that are no mesh.
#include <cstring>
#include <fstream>
#include <random>

#include "carom_test.h"
#include "host/host.h"
#include "mesh/parts.h"
#include "mesh/read_mesh.h"

using namespace carom::tools;

namespace {

constexpr double kCorner[4][3] = {{0, 0, 0}, {1.5, 0, 0}, {0, 2, 0}, {0, 0, -0.25}};
constexpr std::uint32_t kFace[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};

template <class T>
void put(std::string& bytes, T value, bool big = false) {
  char own[sizeof value];
  std::memcpy(own, &value, sizeof value);
  if (big) std::reverse(own, own + sizeof value);
  bytes.append(own, sizeof value);
}

std::string stl_text() {
  std::string text = "solid a tetrahedron\n";
  for (const auto& face : kFace) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const std::uint32_t i : face)
      text += "  vertex " + std::to_string(kCorner[i][0]) + " " + std::to_string(kCorner[i][1]) + "\t" +
              (i == 3 ? "-2.5e-1" : "+0.0") + "\r\n";
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

std::string stl_binary() {
  std::string bytes = "solid, says this header too";
  bytes.resize(80);
  put(bytes, std::uint32_t{4});
  for (const auto& face : kFace) {
    for (int i = 0; i < 3; ++i) put(bytes, 0.f);
    for (const std::uint32_t corner : face)
      for (const double x : kCorner[corner]) put(bytes, static_cast<float>(x));
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string ply(const std::string& format) {
  std::string bytes = "ply\nformat " + format +
                      " 1.0\ncomment with what nobody needs\nelement vertex 4\nproperty double x\nproperty float32 y\n"
                      "property uchar red\nproperty float z\nelement edge 1\nproperty list uchar short of\n"
                      "element face 4\nproperty int8 kind\nproperty list uint8 int vertex_indices\nend_header\n";
  if (format == "ascii") {
    for (const auto& p : kCorner)
      bytes += std::to_string(p[0]) + " " + std::to_string(p[1]) + " 255 " + std::to_string(p[2]) + "\n";
    bytes += "2 0 1\n";
    for (const auto& f : kFace)
      bytes += "7 3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
    return bytes;
  }
  const bool big = format == "binary_big_endian";
  for (const auto& p : kCorner)
    put(bytes, p[0], big), put(bytes, static_cast<float>(p[1]), big), put(bytes, std::uint8_t{255}),
        put(bytes, static_cast<float>(p[2]), big);
  put(bytes, std::uint8_t{2}), put(bytes, std::int16_t{0}, big), put(bytes, std::int16_t{1}, big);
  for (const auto& f : kFace) {
    put(bytes, std::int8_t{-1}), put(bytes, std::uint8_t{3});
    for (const std::uint32_t i : f) put(bytes, i, big);
  }
  return bytes;
}

struct Named {
  std::string path, bytes;
};
std::vector<Named> every_format() {
  return {{"mesh_files_text.stl", stl_text()},
          {"mesh_files_binary.STL", stl_binary()},
          {"mesh_files_text.ply", ply("ascii")},
          {"mesh_files_little.ply", ply("binary_little_endian")},
          {"mesh_files_big.Ply", ply("binary_big_endian")}};
}

Mesh parse(const Named& file) {
  return mesh_ending(file.path) == ".stl" ? parse_stl(file.bytes, file.path) : parse_ply(file.bytes, file.path);
}

/// "" if it was read; else what was said, with a remedy and the name of the file.
std::string refusal(const Named& file) {
  try {
    parse(file);
    return "";
  } catch (const Error& error) {
    assert_false(error.remedy.empty());
    const std::string said = error.what();
    assert_true(said.find(file.path) != std::string::npos);
    return said;
  }
}

}  // namespace

static void every_format_gives_the_same_solid(void**) {
  for (const Named& file : every_format()) {
    std::ofstream(file.path, std::ios::binary) << file.bytes;
    const Mesh mesh = read_mesh(file.path);
    assert_int_equal(mesh.points.size(), 4);
    assert_int_equal(mesh.faces.size(), 4);
    double volume = 0;
    for (const auto& f : mesh.faces) volume += mesh.points[f[0]].dot(mesh.points[f[1]].cross(mesh.points[f[2]])) / 6;
    assert_true(std::fabs(std::fabs(volume) - 1.5 * 2 * 0.25 / 6) < 1e-15);
    assert_int_equal(read_parts(file.path).size(), 1);
    std::remove(file.path.c_str());
  }
}

static void what_is_cut_off_is_refused_at_every_byte(void**) {
  for (const Named& file : every_format()) {
    const bool ends_in_space = file.bytes.back() == '\n';
    for (std::size_t n = 0; n + 1 < file.bytes.size(); ++n) {
      // A text is whole once its last number is: what follows it may go.
      const bool whole = ends_in_space && file.bytes.find_first_of("0123456789", n) == std::string::npos &&
                         file.bytes.find("endfacet", n) == std::string::npos;
      if (whole) continue;
      const std::string said = refusal({file.path, file.bytes.substr(0, n)});
      // Only a facet's end tells that an STL text goes on, and a number may lose its last digit.
      const bool between_facets = file.bytes.substr(0, n).rfind("endfacet") != std::string::npos;
      if (said.empty() && !between_facets && file.path != "mesh_files_text.ply")
        print_error("%s is read when cut off after %zu bytes\n", file.path.c_str(), n), assert_true(false);
    }
  }
}

static void damaged_bytes_are_read_or_refused_and_nothing_else(void**) {
  std::mt19937 random(5);
  int refused = 0, read = 0;
  for (const Named& file : every_format())
    for (int trial = 0; trial < 1000; ++trial) {
      Named damaged = file;
      for (std::uint32_t k = 1 + random() % 3; k > 0; --k) {
        char& byte = damaged.bytes[random() % damaged.bytes.size()];
        byte = random() % 2 ? static_cast<char>(random()) : "0 9-e\n."[random() % 7];
      }
      refusal(damaged).empty() ? ++read : ++refused;
    }
  assert_true(refused > 1000 && read > 100);
}

static void errors_say_where(void**) {
  const auto says = [](const Named& file, const char* what) { return refusal(file).find(what) != std::string::npos; };
  std::string text = stl_text();
  text.replace(text.find("2.000000"), 8, "nan     ");
  assert_true(says({"a.stl", text}, "a.stl:6: a vertex needs three finite numbers"));
  assert_true(says({"a.stl", "solid\nfacet\nendfacet\n"}, "a.stl:3: a facet of 0 vertices"));
  assert_true(says({"a.stl", "solid\nendsolid\n"}, "has no vertices"));
  assert_true(says({"a.stl", std::string(500, 'x')}, "is cut off, or no STL file"));
  std::string faces = ply("ascii");
  faces.replace(faces.rfind("7 3 1"), 5, "7 3 9");
  assert_true(says({"a.ply", faces}, "a.ply:23: a face names a vertex that does not exist"));
  assert_true(says({"a.ply", "plu\n"}, "a.ply:1: is no PLY file"));
  assert_true(says({"a.ply", "ply\nelement vertex -1\nend_header\n"}, "a.ply:2: an element needs"));
  assert_true(
      says({"a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"}, "three finite"));
  bool refused = false;
  try {
    read_mesh("a.fbx");
  } catch (const Error& error) {
    refused = error.remedy.find(".ply") != std::string::npos;
  }
  assert_true(refused);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_format_gives_the_same_solid),
      cmocka_unit_test(what_is_cut_off_is_refused_at_every_byte),
      cmocka_unit_test(damaged_bytes_are_read_or_refused_and_nothing_else),
      cmocka_unit_test(errors_say_where),
  };
  return cmocka_run_group_tests_name("tools/mesh_files", tests, nullptr, nullptr);
}
