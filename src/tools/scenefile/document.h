// A glTF file: JSON whose errors name their place, and the bytes that it refers to.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "scenefile/budget.h"

namespace carom::tools::scenefile {

using nlohmann::json;

class Maybe;

/// A number as another type, if that holds it.   @throws std::range_error
template <class To, class From>
To checked(From x) {
  static_assert(std::is_integral_v<To> && std::is_arithmetic_v<From>);
  if constexpr (std::is_floating_point_v<From>) {
    // The bounds of To, as powers of two, are exact in a double.
    const From high = std::ldexp(From(1), std::numeric_limits<To>::digits),
               low = std::is_signed_v<To> ? -high : From(0);
    if (!(x >= low && x < high) || x != std::floor(x)) throw std::range_error("a number that does not fit");
  } else if (!std::in_range<To>(x)) {
    throw std::range_error("a number that does not fit");
  }
  return static_cast<To>(x);
}

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
  Maybe get(const char* key) const;                          ///< if there
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
  /// A whole number within bounds: 2, or 2.0.
  template <class T>
  T whole(T least = std::numeric_limits<T>::min(), T most = std::numeric_limits<T>::max()) const {
    const double x = number(static_cast<double>(least), static_cast<double>(most));
    if (x != std::floor(x)) fail("is no whole number", "write a number without a fraction");
    return checked<T>(x);
  }
  template <class T>
  T bits_as() const {
    const std::uint64_t all = bits();
    if (!std::in_range<T>(all))
      fail("has more bits than fit here", "write at most " + std::to_string(8 * sizeof(T)) + " bits");
    return static_cast<T>(all);
  }
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

/// A value that may be missing. Asked for what it has not, it says where that should stand: there is no way past the check.
class Maybe {
 public:
  Maybe(std::nullopt_t) {}
  Maybe(Value value) : value_(std::move(value)) {}
  Maybe(const Value& of, const char* key) : of_(of), key_(key) {}  ///< it lacks this

  explicit operator bool() const { return value_.has_value(); }
  const Value& operator*() const {
    if (value_) return *value_;
    if (of_) of_->fail(std::string("lacks '") + key_ + "'", std::string("give '") + key_ + "'");
    throw Error("a part of the document is missing", "compare it with what `carom export` writes");
  }
  const Value* operator->() const { return &**this; }

 private:
  std::optional<Value> value_, of_;
  std::string key_;
};

bool is_read(const std::string& extension);  ///< here

class Document {
 public:
  /// @param path  .gltf, with buffers in it or beside it, or .glb   @throws Error
  explicit Document(const std::string& path);

  Value root() const { return {json_, path_, ""}; }
  Value section(const char* name, std::size_t index) const;  ///< "/nodes/3"
  std::size_t count(const char* section) const;
  const std::string& path() const { return path_; }
  /// An extension object of a value, if it has it.
  static Maybe extension(const Value& of, const char* name);

  /// Triangles of /meshes/INDEX, in the mesh's own coordinates.   @throws Error
  Mesh mesh(std::size_t index);
  Budget& budget() { return budget_; }

 private:
  std::vector<double> read_accessor(const Value& accessor, std::size_t width);
  void check_version() const;
  void load_buffers();

  std::string path_, chunk_;
  json json_;
  std::vector<std::string> buffers_;
  Budget budget_;
};

}  // namespace carom::tools::scenefile
