// A glTF file: JSON whose errors name their place, and the bytes that it refers to.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace carom::tools::scenefile {

using nlohmann::json;

/// A value of the document, and where it stands. Every getter throws Error with that place if the value is not what is
/// asked for.
class Value {
 public:
  Value(const json& value, const std::string& file, std::string place)
      : value_(&value), file_(&file), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const;
  const std::string& place() const { return place_; }

  bool has(const char* key) const;                           ///< it is an object with this key
  Value operator[](const char* key) const;                   ///< required
  std::optional<Value> get(const char* key) const;           ///< if there
  Value at(std::size_t index) const;                         ///< of an array
  std::size_t size() const;                                  ///< of an array
  std::vector<std::pair<std::string, Value>> items() const;  ///< of an object

  double number(double least = -1e300, double most = 1e300) const;
  double number_or(const char* key, double otherwise, double least = -1e300, double most = 1e300) const;
  bool boolean() const;
  bool is_text() const { return value_->is_string(); }
  bool is_null() const { return value_->is_null(); }
  const std::string& text() const;
  std::size_t index(std::size_t below, const char* what) const;  ///< a whole number that counts in something
  std::uint64_t bits() const;                                    ///< a number, or "0x..."
  std::vector<double> numbers(std::size_t count = SIZE_MAX) const;
  Eigen::Vector3d vector() const;
  Eigen::Vector3d vector_or(const char* key, const Eigen::Vector3d& otherwise) const;
  Eigen::Quaterniond rotation() const;                    ///< unit to 1e-3, as given if it is to 1e-6
  Eigen::Quaterniond rotation_or(const char* key) const;  ///< else identity

 private:
  const json* value_;
  const std::string* file_;
  std::string place_;
};

class Document {
 public:
  /// @param path  .gltf, with buffers in it or beside it, or .glb   @throws Error
  explicit Document(const std::string& path);

  Value root() const { return {json_, path_, ""}; }
  Value section(const char* name, std::size_t index) const;  ///< "/nodes/3"
  std::size_t count(const char* section) const;
  const std::string& path() const { return path_; }
  /// An extension object of a value, if it has it.
  static std::optional<Value> extension(const Value& of, const char* name);

  /// Triangles of /meshes/INDEX, in the mesh's own coordinates.   @throws Error
  Mesh mesh(std::size_t index) const;

 private:
  std::vector<double> read_accessor(const Value& accessor, std::size_t width) const;
  void load_buffers();

  std::string path_, chunk_;
  json json_;
  std::vector<std::string> buffers_;
};

}  // namespace carom::tools::scenefile
