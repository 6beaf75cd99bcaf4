// Devices: pairs in blocks to a device and back, and what it left done by the host. A text is built when the first shape of
// its plugin comes, and compared with the plugin's function for each shape.
#include <carom/pairs.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdio>

#include "abi/device_shapes.h"
#include "abi/device_text.h"
#include "abi/distance.h"
#include "abi/opencl.h"
#include "abi/pairs.h"
#include "abi/world.h"
#include "collision/directions.h"
#include "core/float_guard.h"
#include "core/float_scope.h"

struct carom_device {
  explicit carom_device(carom_engine& owner) : engine(owner), plugins(&owner.memory), checked(&owner.memory) {}

  carom_engine& engine;
  carom::abi::Gate gate;
  carom::abi::ClDevice cl;
  // What calls find here and leave: a buffer grows, and a program has all plugins that were asked for so far.
  carom::abi::ClDevice::Buffer shapes, numbers, corners, links, which, poses, results;
  carom::abi::ClDevice::Program program;
  carom::Array<carom_plugin> plugins;  // by number in the program
  carom::Array<carom_shape> checked;   // whose plugin's text gives the function's bits
  std::uint64_t pairs = 0, host_pairs = 0;
};

namespace carom::abi {
namespace {

/// Pairs on a device at once: 16 MB there and here.
constexpr std::size_t kBlock = std::size_t(1) << 16;
constexpr const char* kAskHost = "ask on the host: carom_pairs_distance()";

/// The device of a call, argument 1, closed to everybody else until the end of the scope.
class UsingDevice {
 public:
  UsingDevice(Call& call, carom_device* device) {
    if (!present(call, 1, "device", device)) return;
    if (!device->gate.enter_alone())
      call.fail(CAROM_E_BUSY, 1, "another thread uses this device");
    else
      device_ = device;
  }
  ~UsingDevice() {
    if (device_) device_->gate.leave_alone();
  }
  UsingDevice(const UsingDevice&) = delete;
  UsingDevice& operator=(const UsingDevice&) = delete;
  explicit operator bool() const { return device_; }
  carom_device& operator*() const { return *device_; }
  carom_device* operator->() const { return device_; }

 private:
  carom_device* device_ = nullptr;
};

/// A text that is built with those of some plugins.
/// @param texts  of the plugins, renamed
bool build(Call& call, ClDevice& device, const std::pmr::string& texts, std::uint32_t count, ClDevice::Program& program,
           char* log, std::size_t size) {
  std::pmr::string text(kPairsText, texts.get_allocator());
  text += texts;
  add_ask(count, text);
  return device.build(call, text.c_str(), program, log, size);
}

/// Does the device round as this processor does? Sums of products, quotients, roots, numbers below the smallest normal one.
bool try_arithmetic(Call& call, carom_device& device) {
  constexpr std::uint32_t kCount = 1024;
  Array<double> in(3 * kCount, &device.engine.memory), out(4 * kCount, &device.engine.memory);
  std::uint64_t state = 1;
  for (double& x : in) {  // of both signs, 2^-4 to 2^4
    state = state * 6364136223846793005u + 1442695040888963407u;
    x = std::bit_cast<double>((state & 0x800FFFFFFFFFFFFFu) | (1019 + (state >> 60)) << 52);
  }
  if (!device.cl.write(call, device.numbers, in.data(), in.size() * sizeof in[0]) ||
      !device.cl.reserve(call, device.results, out.size() * sizeof out[0]) ||
      !device.cl.run(call, device.program, "carom_try_arithmetic", kCount, device.numbers, kCount, device.results) ||
      !device.cl.read(call, device.results, out.data(), out.size() * sizeof out[0]))
    return false;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const double x = in[3 * i], y = in[3 * i + 1], z = in[3 * i + 2];
    const double own[4] = {x * y + z, x / y, std::sqrt(x * x), x * 0x1p-1040 * 0x1p-20};
    if (std::memcmp(own, &out[4 * i], sizeof own) == 0) continue;
    call.fail(CAROM_E_UNSUPPORTED, 2, "%.80s rounds otherwise than this processor", device.cl.name());
    return call.advise(kAskHost);
  }
  return true;
}

void open(Call& call, carom_engine* engine, std::uint32_t index, carom_device** out) {
  if (!present(call, 1, "engine", engine) || !present(call, 3, "device", out)) return;
  {
    const std::lock_guard lock(engine->mutex);  // from here on the engine's jobs stay
    engine->worlds.fetch_add(1, std::memory_order_relaxed);
  }
  carom_device* device = nullptr;
  const auto give_up = [&] {
    destroy_on(&engine->memory, device);
    engine->worlds.fetch_sub(1, std::memory_order_release);
  };
  try {
    device = make_on<carom_device>(&engine->memory, *engine);
    char log[128];
    std::pmr::string none(&engine->memory);
    if (device->cl.open(call, 2, index) && !build(call, device->cl, none, 0, device->program, log, sizeof log) &&
        call.ok()) {
      call.fail(CAROM_E_UNSUPPORTED, 2, "%.60s does not compile the library's text: %.120s", device->cl.name(), log);
      call.advise(kAskHost);
    }
    if (call.ok() && try_arithmetic(call, *device)) {
      *out = device;
      return;
    }
  } catch (...) {
    give_up();
    throw;
  }
  give_up();
}

/// The shapes of a call, and what of it the device is given.
class Preparation {
 public:
  Preparation(Call& call, carom_device& device, const PairColumns& pairs)
      : call_(call),
        device_(device),
        pairs_(pairs),
        number_(&device.engine.memory),
        wanted_(&device.engine.memory),
        shapes(&device.engine.memory) {}

  bool prepare() { return find_texts() && build_texts() && number_shapes() && check_texts() && upload(); }
  /// @return number of a shape on the device, DeviceShapes::kLeft where it has none
  std::uint32_t number(const Shape& shape) const { return number_[handle_slot(shape.handle)]; }

 private:
  /// A shape that has no form, and its plugin.
  struct Wanted {
    const Shape* shape;
    const PluginRecord* plugin;  // null: built in
    carom_plugin handle;
  };

  /// The first pair that has a shape, for messages.
  bool refuse(const Shape& shape, const char* reason, const char* detail, const char* remedy) {
    std::uint64_t i = 0;
    int side = 0;
    for (; i < pairs_.count(); ++i)
      if (side = &pairs_.shape(0, i) == &shape ? 0 : 1; side == 0 || &pairs_.shape(1, i) == &shape) break;
    call_.fail(CAROM_E_UNSUPPORTED, 2, "shape_%c of pair %llu: %s%.150s", "ab"[side],
               static_cast<unsigned long long>(i), reason, detail);
    return call_.advise(remedy);
  }

  bool find_texts() {
    {
      const std::lock_guard lock(device_.engine.mutex);
      for (std::size_t slot = 0; slot < pairs_.shapes().slots(); ++slot) {
        const Shape* const s = pairs_.shapes().at(slot);
        if (!s || !s->support || Core::own_form(*s) != Form::none) continue;
        const ShapeRecord& record = device_.engine.shapes[slot];
        wanted_.push_back({s, record.plugin, record.plugin_handle});
      }
    }
    for (const Wanted& w : wanted_) {
      if (!w.plugin) return refuse(*w.shape, "a hull of round shapes, which no device can ask", "", kAskHost);
      if (w.plugin->text.empty())
        return refuse(*w.shape, "no text of the support function comes with plugin ", w.plugin->id.c_str(),
                      "write the function within CAROM_SUPPORT_TEXT() (plugin.h) and set .text, or ask on the host");
    }
    return true;
  }

  std::uint32_t plugin_number(carom_plugin handle) const {
    std::uint32_t n = 0;
    while (n < device_.plugins.size() && device_.plugins[n] != handle) ++n;
    return n;
  }

  /// One program of all plugins that were asked for so far and the new ones.
  bool build_texts() {
    Array<const Wanted*> fresh(&device_.engine.memory);
    for (const Wanted& w : wanted_) {
      bool known = plugin_number(w.handle) < device_.plugins.size();
      for (const Wanted* f : fresh) known = known || f->handle == w.handle;
      if (!known) fresh.push_back(&w);
    }
    if (fresh.empty()) return true;
    // Plugins that are gone leave the program; so all numbers are new.
    Array<const Wanted*> all(&device_.engine.memory);
    for (const Wanted& w : wanted_) {
      bool in = false;
      for (const Wanted* a : all) in = in || a->handle == w.handle;
      if (!in) all.push_back(&w);
    }
    std::pmr::string texts(&device_.engine.memory);
    char log[160];
    for (std::uint32_t n = 0; n < all.size(); ++n)
      if (!add_plugin_text(all[n]->plugin->text, n, texts, log, sizeof log)) return blame(*all[n], log);
    ClDevice::Program program;
    if (!build(call_, device_.cl, texts, static_cast<std::uint32_t>(all.size()), program, log, sizeof log)) {
      if (!call_.ok()) return false;
      for (const Wanted* w : all) {  // which of them?
        std::pmr::string alone(&device_.engine.memory);
        ClDevice::Program ignored;
        if (add_plugin_text(w->plugin->text, 0, alone, log, sizeof log) &&
            !build(call_, device_.cl, alone, 1, ignored, log, sizeof log))
          return call_.ok() && blame(*w, log);
      }
      return refuse(*all[0]->shape, "the device does not compile plugins' texts together: ", log, kAskHost);
    }
    device_.plugins.clear(), device_.checked.clear();
    device_.plugins.reserve(all.size());
    for (const Wanted* w : all) device_.plugins.push_back(w->handle);
    device_.program.swap(program);
    return true;
  }

  bool blame(const Wanted& w, const char* why) {
    char text[256];
    std::snprintf(text, sizeof text, "%.60s: %s", w.plugin->id.c_str(), why);
    return refuse(*w.shape, "a device cannot take the text of plugin ", text,
                  "mend the text (plugin.h, CAROM_SUPPORT_TEXT), or ask on the host: carom_pairs_distance()");
  }

  bool number_shapes() {
    number_.assign(pairs_.shapes().slots(), DeviceShapes::kLeft);
    std::size_t next = 0;  // of wanted_, which is in order of slots
    for (std::size_t slot = 0; slot < number_.size(); ++slot) {
      const Shape* const s = pairs_.shapes().at(slot);
      if (!s || !s->support) continue;
      const bool asked = next < wanted_.size() && wanted_[next].shape == s;
      number_[slot] = static_cast<std::uint32_t>(shapes.records.size());
      shapes.add(*s, asked ? plugin_number(wanted_[next].handle) : 0);
      next += asked;
    }
    return true;
  }

  /// Whether the texts give what the functions give, to the bit; once for each shape.
  bool check_texts() {
    constexpr std::uint32_t kCount = kDirections;
    const auto directions = asking_directions();
    double out[4 * kCount];
    for (const Wanted& w : wanted_) {
      if (std::find(device_.checked.begin(), device_.checked.end(), w.shape->handle) != device_.checked.end()) continue;
      const std::uint64_t count = w.shape->params.size(), none = 0;
      if (!device_.cl.write(call_, device_.numbers, w.shape->params.data(), count * sizeof(double)) ||
          !device_.cl.write(call_, device_.poses, directions.data(), sizeof directions) ||
          !device_.cl.reserve(call_, device_.results, sizeof out) ||
          !device_.cl.run(call_, device_.program, "carom_ask_directions", kCount, plugin_number(w.handle),
                          device_.numbers, none, count, device_.poses, kCount, device_.results) ||
          !device_.cl.read(call_, device_.results, out, sizeof out))
        return false;
      const FloatGuard guard;
      for (std::uint32_t i = 0; i < kCount; ++i) {
        double own[3] = {0, 0, 0};
        const std::int32_t status =
            w.shape->support(w.shape->user, w.shape->params.data(), count, directions[i].data(), own);
        guard.put_back();
        const bool same = out[4 * i + 3] == status && (status != 0 || std::memcmp(own, out + 4 * i, sizeof own) == 0);
        if (same) continue;
        call_.witness(directions[i].data(), out + 4 * i);
        return blame(w, "it gives other bits than the function; the witness has a direction, and what the text gave");
      }
      device_.checked.push_back(w.shape->handle);
    }
    return true;
  }

  template <class T>
  bool send(ClDevice::Buffer& buffer, const Array<T>& data) {
    return device_.cl.write(call_, buffer, data.data(), data.size() * sizeof(T));
  }
  bool upload() {
    return send(device_.shapes, shapes.records) && send(device_.numbers, shapes.numbers) &&
           send(device_.corners, shapes.corners) && send(device_.links, shapes.links);
  }

  Call& call_;
  carom_device& device_;
  const PairColumns& pairs_;
  Array<std::uint32_t> number_;  // by slot
  Array<Wanted> wanted_;
  DeviceShapes shapes;
};

/// Arrays of one block of pairs.
struct Block {
  explicit Block(Memory* memory, std::size_t n) : which(2 * n, memory), poses(14 * n, memory), results(n, memory) {}
  Array<std::uint32_t> which;
  Array<double> poses;
  Array<carom_distance> results;
};

constexpr std::size_t kPairsAtOnce = 64;  // some 10 us of copying

/// The host's part of pairs [first, first + n): what the device left, and all of it into the host's array.
/// @return how many were left
std::uint64_t finish_block(carom_engine& engine, const PairColumns& pairs, const QuerySettings& settings, Block& block,
                           std::uint64_t first, std::size_t n, carom_distance* dst, std::uint64_t stride) {
  std::atomic<std::uint64_t> left{0};
  std::atomic<bool> later{false};
  const auto part = [&](std::uint32_t begin, std::uint32_t end, bool on_host_thread) {
    const FloatGuard guard;
    std::uint64_t own = 0;
    for (std::uint32_t k = begin; k < end; ++k) {
      carom_distance& found = block.results[k];
      const std::uint64_t i = first + k;
      const bool is_left = found.status > CAROM_QUERY_FAULT;
      if (!is_left && on_host_thread) continue;
      if (is_left) {
        const Shape &a = pairs.shape(0, i), &b = pairs.shape(1, i);
        if ((a.host_thread || b.host_thread) != on_host_thread) {
          later.store(true, std::memory_order_relaxed);
          continue;
        }
        found = measure_distance(a, pairs.frame(0, i), b, pairs.frame(1, i), settings);
        guard.put_back();
        ++own;
      }
      found.struct_size = static_cast<std::uint32_t>(std::min<std::uint64_t>(stride, sizeof found));
      write_element(found, dst, i, stride);
    }
    left.fetch_add(own, std::memory_order_relaxed);
  };
  in_parts(engine.jobs.get(), n, kPairsAtOnce,
           [&](std::uint32_t begin, std::uint32_t end) { part(begin, end, false); });
  if (later.load(std::memory_order_relaxed)) part(0, static_cast<std::uint32_t>(n), true);
  return left.load(std::memory_order_relaxed);
}

void measure_on_device(Call& call, carom_device& device, const PairColumns& pairs, const carom_distance_desc& desc,
                       carom_distance* dst, std::uint64_t stride) {
  if (desc.pair_routines || desc.simplex == CAROM_SIMPLEX_JOHNSON) {
    call.fail(CAROM_E_UNSUPPORTED, 3, "desc->%s: a device has %s", desc.pair_routines ? "pair_routines" : "simplex",
              desc.pair_routines ? "no routines for pairs of forms" : "no Johnson's sub-algorithm");
    call.advise(kAskHost);
    return;
  }
  if (pairs.count() == 0) return;
  Preparation preparation(call, device, pairs);
  if (!preparation.prepare()) return;
  const QuerySettings settings = query_settings(desc);
  const double shell = settings.method == Method::hybrid && settings.margin > 0 ? 2 * settings.margin : 0;
  const std::uint32_t last_only = settings.simplex == Simplex::voronoi_last, cap = desc.gjk_iterations;
  const std::size_t most = std::min<std::uint64_t>(kBlock, pairs.count());
  Block block(&device.engine.memory, most);
  std::uint64_t left = 0;
  for (std::uint64_t first = 0; first < pairs.count(); first += most) {
    const std::size_t n = std::min<std::uint64_t>(most, pairs.count() - first);
    in_parallel(device.engine.jobs.get(), n, kPairsAtOnce, [&](std::uint32_t k) {
      for (int side = 0; side < 2; ++side) {
        block.which[2 * k + static_cast<unsigned>(side)] = preparation.number(pairs.shape(side, first + k));
        pairs.pose(side, first + k, &block.poses[14 * k + 7 * static_cast<unsigned>(side)]);
      }
    });
    const auto count = static_cast<std::uint32_t>(n);
    if (!device.cl.write(call, device.which, block.which.data(), 2 * n * sizeof block.which[0]) ||
        !device.cl.write(call, device.poses, block.poses.data(), 14 * n * sizeof block.poses[0]) ||
        !device.cl.reserve(call, device.results, n * sizeof block.results[0]) ||
        !device.cl.run(call, device.program, "carom_measure_pairs", n, device.shapes, device.numbers, device.corners,
                       device.links, device.which, device.poses, settings.tolerance, shell, last_only, cap, count,
                       device.results) ||
        !device.cl.read(call, device.results, block.results.data(), n * sizeof block.results[0]))
      return;
    left += finish_block(device.engine, pairs, settings, block, first, n, dst, stride);
  }
  device.pairs += pairs.count(), device.host_pairs += left;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_device_create(carom_engine* engine, uint32_t index, carom_device** device, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const FloatScope scope;
    open(call, engine, index, device);
  });
}

int32_t carom_device_destroy(carom_device* device, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "device", device)) return;
    if (!device->gate.enter_alone()) {
      call.fail(CAROM_E_BUSY, 1, "another thread uses this device");
      return;
    }
    carom_engine& engine = device->engine;
    destroy_on(&engine.memory, device);
    engine.worlds.fetch_sub(1, std::memory_order_release);  // last: the engine may be destroyed from now on
  });
}

int32_t carom_device_get_info(carom_device* device, carom_device_info* info, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const UsingDevice used(call, device);
    if (!used || !fillable(call, 2, "info", info)) return;
    carom_device_info full{};
    std::snprintf(full.name, sizeof full.name, "%s", used->cl.name());
    std::snprintf(full.version, sizeof full.version, "%s", used->cl.version());
    full.pairs = used->pairs, full.host_pairs = used->host_pairs;
    write_struct(full, info);
  });
}

int32_t carom_device_pairs_distance(carom_device* device, const carom_pairs* pairs, const carom_distance_desc* desc,
                                    carom_distance* dst, uint64_t stride, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const UsingDevice used(call, device);
    if (!used) return;
    carom_distance_desc known_desc;
    PairColumns columns(used->engine);
    const FloatScope scope;
    if (columns.read_all(call, pairs, desc, known_desc, dst, stride))
      measure_on_device(call, *used, columns, known_desc, dst, stride);
  });
}

}  // extern "C"
