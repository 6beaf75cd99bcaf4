// PLY: a header that says which elements of which properties follow, as words or as bytes of either order.
#include <limits>
#include <vector>

#include "host/host.h"
#include "mesh/bytes.h"
#include "mesh/read_mesh.h"

namespace carom::tools {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
  std::string name;
  Type type = Type::f32, count_type = Type::u8;
  bool is_list = false;
};
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};
enum class Format { none, text, little, big };

std::size_t size_of(Type type) {
  static constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

std::optional<Type> type_called(std::string_view name) {
  static constexpr std::string_view kNames[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                                   {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                                   {"float", "float32"}, {"double", "float64"}};
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (name == kNames[i][0] || name == kNames[i][1]) return static_cast<Type>(i);
  return std::nullopt;
}

[[noreturn]] void refuse(const std::string& path, const std::string& where, const std::string& why) {
  throw Error(
      path + where + ": " + why,
      "give a PLY file with an element vertex of properties x, y, z and an element face with a list vertex_indices");
}

/// Values one after the other, however the file holds them.
class Values {
 public:
  Values(std::string_view body, Format format, std::size_t line, std::size_t byte, const std::string& path)
      : body_(body), words_(body), format_(format), line_(line), byte_(byte), path_(path) {}

  std::size_t left() const {
    return format_ == Format::text ? std::numeric_limits<std::size_t>::max() : body_.size() - at_;
  }
  std::string where() const {
    return format_ == Format::text ? ":" + std::to_string(line_ + words_.line() - 1)
                                   : ", byte " + std::to_string(byte_ + at_);
  }
  double next(Type type) {
    if (format_ == Format::text) {
      const std::string_view word = words_.next();
      const auto value = number_of(word);
      if (value) return *value;
      refuse(path_, where(), word.empty() ? "the file is cut off" : "'" + std::string(word) + "' is no finite number");
    }
    if (left() < size_of(type)) refuse(path_, where(), "the file is cut off");
    const char* const from = body_.data() + at_;
    at_ += size_of(type);
    const bool big = format_ == Format::big;
    switch (type) {
      case Type::i8:
        return value_at<std::int8_t>(from, big);
      case Type::u8:
        return value_at<std::uint8_t>(from, big);
      case Type::i16:
        return value_at<std::int16_t>(from, big);
      case Type::u16:
        return value_at<std::uint16_t>(from, big);
      case Type::i32:
        return value_at<std::int32_t>(from, big);
      case Type::u32:
        return value_at<std::uint32_t>(from, big);
      case Type::f32:
        return double(value_at<float>(from, big));
      default:
        return value_at<double>(from, big);
    }
  }

 private:
  std::string_view body_;
  Words words_;
  Format format_;
  std::size_t line_, byte_, at_ = 0;
  const std::string& path_;
};

struct Header {
  Format format = Format::none;
  std::vector<Element> elements;
  std::size_t lines = 0, bytes = 0;
};

Header read_header(std::string_view bytes, const std::string& path) {
  Header header;
  for (;;) {
    const std::size_t end = bytes.find('\n', header.bytes);
    const std::string where = ":" + std::to_string(++header.lines);
    if (end == std::string_view::npos) refuse(path, where, "the header does not end");
    Words words(bytes.substr(header.bytes, end - header.bytes));
    header.bytes = end + 1;
    const std::string_view key = words.next();
    if (header.lines == 1) {
      if (key != "ply") refuse(path, where, "is no PLY file");
    } else if (key == "end_header") {
      break;
    } else if (key == "format") {
      const std::string_view name = words.next();
      header.format = name == "ascii"                  ? Format::text
                      : name == "binary_little_endian" ? Format::little
                      : name == "binary_big_endian"    ? Format::big
                                                       : Format::none;
    } else if (key == "element") {
      Element& element = header.elements.emplace_back();
      element.name = words.next();
      const auto count = number_of(words.next());
      if (!count || !(*count >= 0 && *count <= double(std::numeric_limits<std::uint32_t>::max())) ||
          *count != std::floor(*count))
        refuse(path, where, "an element needs a name and a number from 0 to 2^32 - 1");
      element.count = static_cast<std::uint64_t>(*count);
    } else if (key == "property") {
      if (header.elements.empty()) refuse(path, where, "a property before any element");
      Property& property = header.elements.back().properties.emplace_back();
      std::string_view type = words.next();
      property.is_list = type == "list";
      if (property.is_list) {
        const auto count_type = type_called(words.next());
        if (!count_type) refuse(path, where, "a list's length is of no type that PLY knows");
        property.count_type = *count_type;
        type = words.next();
      }
      const auto known = type_called(type);
      if (!known) refuse(path, where, "'" + std::string(type) + "' is no type that PLY knows");
      property.type = *known;
      property.name = words.next();
    }
  }
  if (header.format == Format::none) refuse(path, "", "has no format line that names ascii or a binary order");
  return header;
}

std::uint64_t length_of_list(Values& values, const Property& property, const std::string& path) {
  const double length = values.next(property.count_type);
  if (!(length >= 0 && length <= 1e6) || length != std::floor(length))
    refuse(path, values.where(), "a list of no sensible length");
  return static_cast<std::uint64_t>(length);
}

void read_face(Values& values, const Property& property, Mesh& mesh, const std::string& path) {
  std::vector<std::uint32_t> corners(length_of_list(values, property, path));
  for (std::uint32_t& corner : corners) {
    const double index = values.next(property.type);
    if (!(index >= 0 && index < static_cast<double>(mesh.points.size())) || index != std::floor(index))
      refuse(path, values.where(), "a face names a vertex that does not exist");
    corner = static_cast<std::uint32_t>(index);
  }
  if (corners.size() < 3) refuse(path, values.where(), "a face needs three vertices");
  for (std::size_t i = 2; i < corners.size(); ++i) mesh.faces.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace

Mesh parse_ply(std::string_view bytes, const std::string& path) {
  const Header header = read_header(bytes, path);
  Values values(bytes.substr(header.bytes), header.format, header.lines + 1, header.bytes, path);
  Mesh mesh;
  bool has_vertices = false;
  for (const Element& element : header.elements) {
    const bool vertex = element.name == "vertex", face = element.name == "face";
    if (element.properties.empty()) continue;
    if (face && !has_vertices) refuse(path, "", "has faces before its vertices");
    has_vertices |= vertex;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Eigen::Vector3d p = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
      for (const Property& property : element.properties) {
        const bool is_face =
            face && property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
        if (is_face) {
          read_face(values, property, mesh, path);
          continue;
        }
        for (std::uint64_t k = property.is_list ? length_of_list(values, property, path) : 1; k > 0; --k) {
          const double value = values.next(property.type);
          if (vertex && !property.is_list && property.name.size() == 1 && property.name[0] >= 'x' &&
              property.name[0] <= 'z')
            p[property.name[0] - 'x'] = value;
        }
      }
      if (!vertex) continue;
      if (!p.allFinite()) refuse(path, values.where(), "a vertex needs three finite numbers");
      mesh.points.push_back(p);
    }
  }
  if (mesh.points.empty()) refuse(path, "", "has no vertices");
  return mesh;
}

}  // namespace carom::tools
