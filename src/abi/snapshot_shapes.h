// The shapes of a snapshot: what an engine calls them, and how they are found or made again.
#pragma once

#include "abi/engine.h"
#include "dynamics/snapshot/snapshot.h"

namespace carom::dynamics {
class World;
}

namespace carom::abi {

/// By id and version of their plugins, for whoever knows neither this engine nor this process.
class EngineNames final : public ShapeNames {
 public:
  explicit EngineNames(carom_engine& engine) : engine_(engine) {}
  bool name(const Shape& shape, std::string_view& plugin, std::uint32_t& version) const override;

 private:
  carom_engine& engine_;
};

/// By their number alone, for a fork within an engine.
class NumberNames final : public ShapeNames {
 public:
  bool name(const Shape&, std::string_view&, std::uint32_t&) const override { return false; }
};

/// Found in the engine, where there is one of the same numbers, or made. Held while this lives; what was made stays only
/// if a world wears it.
class EngineShapes final : public ShapeMaker {
 public:
  explicit EngineShapes(carom_engine& engine) : engine_(engine), held_(&engine.memory) {}
  ~EngineShapes() override;
  EngineShapes(const EngineShapes&) = delete;
  EngineShapes& operator=(const EngineShapes&) = delete;
  const Shape* make(std::size_t number, const ShapeImage& image, SnapshotFault& fault) override;

 private:
  struct Held {
    std::uint32_t slot;
    bool made;
  };
  const Shape* find(const ShapeImage& image);
  bool make_new(const ShapeImage& image, SnapshotFault& fault, std::uint64_t& handle);

  carom_engine& engine_;
  Array<Held> held_;
};

/// Those of another world of the engine, which keeps them alive.
class NumberedShapes final : public ShapeMaker {
 public:
  explicit NumberedShapes(Array<const Shape*> shapes) : shapes_(std::move(shapes)) {}
  const Shape* make(std::size_t number, const ShapeImage& image, SnapshotFault& fault) override;

 private:
  Array<const Shape*> shapes_;
};

/// The result code that says it.
std::int32_t code_of(const SnapshotFault& fault);

/// The colliders of a new world keep their shapes from now on.
void wear_shapes(carom_engine& engine, const World& world);

}  // namespace carom::abi
