#include "scenefile/document.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "host/files.h"
#include "host/host.h"

namespace carom::tools::scenefile {
namespace {

const char* type_of(const json& value) { return value.type_name(); }

std::uint32_t get32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value |= std::uint32_t(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  return value;
}

/// @return false: not base64
bool decode_base64(const std::string& text, std::size_t from, std::string& out) {
  std::uint32_t group = 0, have = 0;
  for (std::size_t i = from; i < text.size() && text[i] != '='; ++i) {
    const char c = text[i];
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                      : c == '/'             ? 63
                                             : -1;
    if (digit < 0) return false;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    have += 6;
    if (have < 8) continue;
    have -= 8;
    out += static_cast<char>(group >> have & 255);
  }
  return true;
}

/// JSON text and binary chunk of a .glb [glTF2 §4.4].
void open_container(const std::string& path, const std::string& bytes, std::string& text, std::string& chunk) {
  const auto bad = [&](const std::string& what) {
    throw Error(path + ": " + what, "write the file anew; a .glb is a header, a JSON chunk and a binary chunk");
  };
  if (bytes.size() < 20 || bytes.compare(0, 4, "glTF") != 0) bad("not a binary glTF file");
  if (get32(bytes, 4) != 2) bad("container version " + std::to_string(get32(bytes, 4)) + ", not 2");
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t length = get32(bytes, at), from = at + 8;
    if (length > bytes.size() - from) bad("a chunk at byte " + std::to_string(at) + " goes beyond the file's end");
    if (bytes.compare(at + 4, 4, "JSON") == 0) text = bytes.substr(from, length);
    if (bytes.compare(at + 4, 3, "BIN") == 0) chunk = bytes.substr(from, length);
    at = from + (length + 3) / 4 * 4;
  }
  if (text.empty()) bad("no JSON chunk");
}

/// "[json.exception.out_of_range.406] number overflow" without the tag.
std::string after_tag(const std::string& what) {
  const std::size_t end = what.find("] ");
  return (end == std::string::npos ? what : what.substr(end + 2)).substr(0, 200);
}

/// Of a document nested no deeper than a scene needs: freeing what is nested deeper takes more stack than there is.
json parse_json(const std::string& text) {
  constexpr int kDeepest = 256;
  return json::parse(text, [](int depth, json::parse_event_t, json&) {
    if (depth > kDeepest)
      throw Error("the document is nested deeper than " + std::to_string(kDeepest) + " levels", "flatten it");
    return true;
  });
}

/// %20 and the like.   @return false: no two hex digits after a %
bool decode_percent(const std::string& text, std::string& out) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    unsigned char byte = 0;
    if (i + 2 >= text.size()) return false;
    const auto [end, failed] = std::from_chars(&text[i + 1], &text[i + 1] + 2, byte, 16);
    if (failed != std::errc() || end != &text[i + 1] + 2) return false;
    out += static_cast<char>(byte), i += 2;
  }
  return true;
}

/// Extensions that are read here, and those without which a scene only looks different.
bool is_understood(const std::string& name) {
  static constexpr const char* kLooks[] = {"KHR_materials_", "KHR_texture_",  "EXT_texture_", "KHR_lights_",
                                           "EXT_lights_",    "MSFT_texture_", "KHR_xmp"};
  return is_read(name) || std::ranges::any_of(kLooks, [&](const char* start) { return name.starts_with(start); });
}

}  // namespace

bool is_read(const std::string& name) {
  static constexpr const char* kRead[] = {"KHR_implicit_shapes", "KHR_physics_rigid_bodies", "CAROM_physics",
                                          "OMI_physics_body",    "OMI_physics_shape",        "OMI_physics_joint",
                                          "OMI_physics_gravity"};
  return std::ranges::any_of(kRead, [&](const char* known) { return name == known; });
}

void Value::fail(const std::string& problem, const std::string& remedy) const {
  throw Error(*file_ + ": " + (place_.empty() ? "the document" : place_) + " " + problem, remedy);
}

bool Value::has(const char* key) const { return value_->is_object() && value_->contains(key); }

Maybe Value::get(const char* key) const {
  if (!value_->is_object()) fail(std::string("is a ") + type_of(*value_), "write an object");
  const auto found = value_->find(key);
  if (found == value_->end()) return {*this, key};
  return Value(*found, *file_, place_ + "/" + key);
}

Value Value::operator[](const char* key) const { return *get(key); }

std::size_t Value::size() const {
  if (!value_->is_array()) fail(std::string("is a ") + type_of(*value_), "write an array");
  return value_->size();
}

Value Value::at(std::size_t index) const {
  if (index >= size()) fail("has no element " + std::to_string(index), "check the index that refers to it");
  return {(*value_)[index], *file_, place_ + "/" + std::to_string(index)};
}

std::vector<std::pair<std::string, Value>> Value::items() const {
  if (!value_->is_object()) fail(std::string("is a ") + type_of(*value_), "write an object");
  std::vector<std::pair<std::string, Value>> list;
  for (const auto& [key, value] : value_->items()) list.emplace_back(key, Value(value, *file_, place_ + "/" + key));
  return list;
}

double Value::number(double least, double most) const {
  if (!value_->is_number()) fail(std::string("is a ") + type_of(*value_), "write a number");
  const double x = value_->get<double>();
  if (x >= least && x <= most) return x;
  char text[160];
  std::snprintf(text, sizeof text, "is %.6g", x);
  char range[160];
  std::snprintf(range, sizeof range, "give a number from %.6g to %.6g", least, most);
  fail(text, range);
}

double Value::number_or(const char* key, double otherwise, double least, double most) const {
  const Maybe value = get(key);
  return value ? value->number(least, most) : otherwise;
}

bool Value::boolean() const {
  if (!value_->is_boolean()) fail(std::string("is a ") + type_of(*value_), "write true or false");
  return value_->get<bool>();
}

const std::string& Value::text() const {
  if (!value_->is_string()) fail(std::string("is a ") + type_of(*value_), "write a text in quotes");
  return value_->get_ref<const std::string&>();
}

std::size_t Value::index(std::size_t below, const char* what) const {
  if (!value_->is_number_unsigned() && !(value_->is_number_integer() && value_->get<std::int64_t>() >= 0))
    fail("is not an index", "write a whole number from 0");
  const auto i = value_->get<std::uint64_t>();
  if (i >= below)
    fail("is " + std::to_string(i) + ", but there are " + std::to_string(below) + " " + what, "check the index");
  return static_cast<std::size_t>(i);
}

std::uint64_t Value::bits() const {
  if (value_->is_number_unsigned()) return value_->get<std::uint64_t>();
  if (value_->is_number()) fail("is no set of bits", "write a whole number from 0, or one like \"0xff\"");
  const std::string& digits = text();
  const bool hex = digits.starts_with("0x") || digits.starts_with("0X");
  std::uint64_t value = 0;
  const char *const from = digits.data() + (hex ? 2 : 0), *const to = digits.data() + digits.size();
  const auto [end, failed] = std::from_chars(from, to, value, hex ? 16 : 10);
  if (failed != std::errc() || end != to || from == to)
    fail("is '" + digits.substr(0, 80) + "'", "write a whole number of at most 64 bits, or one like \"0xff\"");
  return value;
}

std::vector<double> Value::numbers(std::size_t count) const {
  const std::size_t n = size();
  if (count != SIZE_MAX && n != count)
    fail("has " + std::to_string(n) + " elements", "give " + std::to_string(count) + " numbers");
  std::vector<double> list;
  list.reserve(n);
  for (std::size_t i = 0; i < n; ++i) list.push_back(at(i).number());
  return list;
}

Eigen::Vector3d Value::vector() const {
  const std::vector<double> x = numbers(3);
  return {x[0], x[1], x[2]};
}

Eigen::Vector3d Value::vector_or(const char* key, const Eigen::Vector3d& otherwise) const {
  const Maybe value = get(key);
  return value ? value->vector() : otherwise;
}

Eigen::Quaterniond Value::rotation() const {
  const std::vector<double> x = numbers(4);
  const Eigen::Quaterniond q(x[3], x[0], x[1], x[2]);
  const double off = std::fabs(q.norm() - 1);
  if (!(off <= 1e-3))
    fail("is no unit quaternion (length " + std::to_string(q.norm()) + ")", "give x, y, z, w of length 1");
  return off <= 1e-7 ? q : q.normalized();  // files hold floats
}

Eigen::Quaterniond Value::rotation_or(const char* key) const {
  const Maybe value = get(key);
  return value ? value->rotation() : Eigen::Quaterniond::Identity();
}

Document::Document(const std::string& path) : path_(path) {
  const std::string bytes = read_file(path, "check the name; a scene file ends in .gltf or .glb");
  budget_.earn(bytes.size());
  std::string text;
  if (bytes.compare(0, 4, "glTF") == 0)
    open_container(path, bytes, text, chunk_);
  else
    text = bytes;
  try {
    json_ = parse_json(text);
  } catch (const json::parse_error& e) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(e.byte, text.size()));
    throw Error(path + ": no JSON at line " + std::to_string(1 + std::count(text.begin(), end, '\n')),
                "a scene file is glTF 2.0, text or binary; `carom export` writes one");
  } catch (const json::exception& e) {  // a number that no double holds
    throw Error(path + ": " + after_tag(e.what()), "write numbers between -1e300 and 1e300");
  }
  check_version();
  load_buffers();
}

void Document::check_version() const {
  const Value version = root()["asset"]["version"];
  if (version.text().compare(0, 2, "2.") != 0) version.fail("is '" + version.text() + "'", "glTF 2.0 is read");
  const auto required = root().get("extensionsRequired");
  for (std::size_t i = 0; required && i < required->size(); ++i) {
    const std::string& name = required->at(i).text();
    if (!is_understood(name))
      required->at(i).fail("is '" + name.substr(0, 80) + "', which is not understood here",
                           "glTF says that a reader must refuse it: write the file without that extension");
  }
}

void Document::load_buffers() {
  for (std::size_t i = 0; i < count("buffers"); ++i) {
    const Value entry = section("buffers", i);
    std::string bytes;
    const auto uri = entry.get("uri");
    if (!uri) {
      if (i > 0) entry.fail("has no uri", "only the first buffer of a .glb may leave it out");
      bytes = chunk_;
    } else if (const std::string& text = uri->text(); text.starts_with("data:")) {
      const std::size_t comma = text.find(";base64,");
      if (comma == std::string::npos || !decode_base64(text, comma + 8, bytes))
        uri->fail("is no base64 data", "embed the buffer as data:application/octet-stream;base64,...");
    } else {
      std::string relative;
      if (!decode_percent(text, relative) || text.find("://") != std::string::npos)
        uri->fail("is '" + text.substr(0, 80) + "'",
                  "a buffer lies in the scene file, or below its folder: write a relative path");
      try {
        bytes = read_below(std::filesystem::path(path_).parent_path().string(), relative,
                           "put the buffer beside the scene file, as a file and no link, or embed it");
      } catch (const Error& e) {
        uri->fail(std::string("is not read: ") + e.what(), e.remedy);
      }
      budget_.earn(bytes.size());
    }
    const double length = entry["byteLength"].number(0, 1e15);
    if (static_cast<double>(bytes.size()) < length)
      entry.fail("has " + std::to_string(bytes.size()) + " bytes of its byteLength", "write the file anew");
    buffers_.push_back(std::move(bytes));
  }
}

std::size_t Document::count(const char* name) const {
  const auto list = root().get(name);
  return list ? list->size() : 0;
}

Value Document::section(const char* name, std::size_t index) const { return root()[name].at(index); }

Maybe Document::extension(const Value& of, const char* name) {
  const auto all = of.get("extensions");
  return all ? all->get(name) : all;
}

std::vector<double> Document::read_accessor(const Value& accessor, std::size_t width) {
  const std::size_t n = accessor["count"].index(std::size_t(1) << 30, "elements that fit");
  budget_.charge(n, 2 * width * sizeof(double), path_ + ": " + accessor.place() + "/count");  // and once more in a mesh
  const std::size_t type = accessor["componentType"].index(6000, "component types");
  const std::size_t size = type == 5126 || type == 5125 ? 4 : type == 5123 || type == 5122 ? 2 : 1;
  if (type < 5120 || type > 5126 || type == 5124) accessor["componentType"].fail("is unknown", "5120 to 5126 but 5124");
  if (accessor.has("sparse")) accessor.fail("is sparse", "write the accessor in full");
  const auto which = accessor.get("bufferView");
  if (!which) return std::vector<double>(n * width, 0);
  const Value view = section("bufferViews", which->index(count("bufferViews"), "buffer views"));
  const std::string& bytes = buffers_[view["buffer"].index(buffers_.size(), "buffers")];
  const auto whole = [](const Value& of, const char* key, std::size_t otherwise) {
    const auto value = of.get(key);
    return value ? value->index(std::size_t(1) << 40, "bytes that fit") : otherwise;
  };
  const std::size_t stride = whole(view, "byteStride", size * width);
  if (stride < size * width || stride > 252)
    view["byteStride"].fail("is " + std::to_string(stride) + ", less than an element or more than 252",
                            "write the file anew");
  const std::size_t begin = whole(view, "byteOffset", 0) + whole(accessor, "byteOffset", 0);
  if (n > 0 && (begin > bytes.size() || (n - 1) * stride + size * width > bytes.size() - begin))
    accessor.fail("goes beyond its buffer", "write the file anew");
  std::vector<double> values;
  values.reserve(n * width);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < width; ++k) {
      const char* const at = bytes.data() + begin + i * stride + k * size;
      const auto as = [&](auto x) {
        std::memcpy(&x, at, sizeof x);
        values.push_back(static_cast<double>(x));
      };
      switch (type) {
        case 5120:
          as(std::int8_t());
          break;
        case 5121:
          as(std::uint8_t());
          break;
        case 5122:
          as(std::int16_t());
          break;
        case 5123:
          as(std::uint16_t());
          break;
        case 5125:
          as(std::uint32_t());
          break;
        default:
          as(float());
      }
    }
  return values;
}

Mesh Document::mesh(std::size_t index) {
  Mesh mesh;
  const Value primitives = section("meshes", index)["primitives"];
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    const Value primitive = primitives.at(p);
    const double mode = primitive.number_or("mode", 4);
    if (mode < 4) continue;  // points and lines have no surface
    if (mode != 4) primitive["mode"].fail("makes strips or fans", "write triangles (mode 4)");
    const auto accessor = [&](const Value& which) {
      return section("accessors", which.index(count("accessors"), "accessors"));
    };
    const Value positions = primitive["attributes"]["POSITION"];
    const std::vector<double> x = read_accessor(accessor(positions), 3);
    for (const double v : x)
      if (!std::isfinite(v)) positions.fail("holds numbers that are not finite", "mend the mesh");
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const std::size_t vertices = x.size() / 3;
    for (std::size_t i = 0; i < vertices; ++i) mesh.points.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    std::vector<double> corner;
    if (const auto indices = primitive.get("indices")) {
      corner = read_accessor(accessor(*indices), 1);
      for (const double c : corner)
        if (!(c >= 0 && c < static_cast<double>(vertices)))
          indices->fail("names a vertex that is not there", "mend the mesh");
    } else {
      for (std::size_t i = 0; i < vertices; ++i) corner.push_back(static_cast<double>(i));
    }
    for (std::size_t t = 0; t + 2 < corner.size(); t += 3)
      mesh.faces.push_back({first + static_cast<std::uint32_t>(corner[t]),
                            first + static_cast<std::uint32_t>(corner[t + 1]),
                            first + static_cast<std::uint32_t>(corner[t + 2])});
  }
  return mesh;
}

}  // namespace carom::tools::scenefile
