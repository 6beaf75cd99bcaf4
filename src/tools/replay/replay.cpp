#include "replay/replay.h"

#include <cerrno>
#include <cstdio>

#include "host/files.h"
#include "replay/script.h"

namespace carom::tools::replay {
namespace {

enum Kind : std::uint32_t { kBegin = 1, kShape, kName, kCall, kHash, kState, kEnd };
constexpr std::size_t kHeader = 16, kMostCalls = 8;

struct Row {
  const char* name;
  int32_t (*make)(Script&);
};
const Row kRows[] = {
#include "replay/calls.inc"
};

[[noreturn]] void damaged(const std::string& what) {
  throw Error("the recording is damaged: " + what,
              "record the session anew, or take the file again from where it was written");
}

/// One record: what it is of, and its content.
struct Record {
  std::uint32_t kind = 0;
  const std::byte* content = nullptr;
  std::uint64_t size = 0;
};

class Records {
 public:
  explicit Records(const Bytes& bytes) : bytes_(bytes) {
    if (bytes.size() < kHeader || std::memcmp(bytes.data(), "CAROMREC", 8) != 0)
      throw Error("this is no recording: it does not begin as one does",
                  "give a file that `carom run SCENE --record FILE` wrote");
    std::uint32_t format;
    std::memcpy(&format, &bytes[8], sizeof format);
    if (format != 1)
      throw Error("the recording has format " + std::to_string(format) + ", this program reads 1", "use a newer carom");
  }
  /// @return false: no whole record is left
  bool next(Record& r) {
    if (bytes_.size() - at_ < kHeader) return false;
    std::memcpy(&r.kind, &bytes_[at_], sizeof r.kind);
    std::memcpy(&r.size, &bytes_[at_ + 8], sizeof r.size);
    if (r.size > bytes_.size() - at_ - kHeader) return false;
    r.content = bytes_.data() + at_ + kHeader;
    at_ += std::min<std::uint64_t>(kHeader + r.size + (-r.size % 8), bytes_.size() - at_);
    return true;
  }

 private:
  const Bytes& bytes_;
  std::size_t at_ = kHeader;
};

/// A world that goes with it.
struct Stand {
  explicit Stand(carom_engine* engine) {
    Call call;
    call.done(carom_world_create(engine, nullptr, &world, call), "creating a world");
  }
  ~Stand() { carom_world_destroy(world, nullptr); }
  Stand(const Stand&) = delete;
  Stand& operator=(const Stand&) = delete;
  std::uint64_t hash() const {
    std::uint64_t value = 0;
    Call call;
    call.done(carom_world_hash(world, &value, call), "hashing the world");
    return value;
  }
  std::uint64_t steps() const {
    carom_step_report report{};
    report.struct_size = sizeof report;
    Call call;
    call.done(carom_world_get_report(world, &report, call), "reading the step report");
    return report.steps;
  }
  carom_world* world = nullptr;
};

class Player {
 public:
  Player(carom_engine* engine, const std::function<void(carom_world*, std::uint64_t)>& watch)
      : engine_(engine), watch_(watch), stand_(engine) {}

  Outcome play(const Bytes& bytes) {
    Records records(bytes);
    Record r;
    if (!records.next(r) || r.kind != kBegin) damaged("it does not begin with a world");
    restore(stand_.world, r, "building the world of the recording");
    while (!out_.ended && !(out_.parting && told_) && records.next(r)) one(r);
    return std::move(out_);
  }

 private:
  static void restore(carom_world* world, const Record& r, const char* doing) {
    Call call;
    call.done(carom_world_restore(world, r.content, r.size, call), doing);
  }

  void one(const Record& r) {
    if (out_.parting && r.kind != kState) {  // the state of the step that parted follows at once, or is not there
      told_ = true;
      return;
    }
    switch (r.kind) {
      case kShape:
        return learn_shape(r);
      case kName:
        return learn_name(r);
      case kCall:
        return call(r);
      case kHash:
        return compare_hash(r);
      case kState:
        if (out_.parting) explain(r), told_ = true;
        return;
      case kEnd:
        out_.ended = true;
        return;
      default:
        return;  // of a newer library, and nothing that changes a world
    }
  }

  template <class T>
  static T number(const Record& r, std::size_t at) {
    T value;
    if (r.size < at + sizeof value) damaged("a record is too short");
    std::memcpy(&value, r.content + at, sizeof value);
    return value;
  }

  /// A world in which one body wears it. Made once, a shape stays with the engine.
  void learn_shape(const Record& r) {
    const auto recorded = number<std::uint64_t>(r, 0);
    std::uint64_t collider = number<std::uint64_t>(r, 8), body = 0;
    const Stand stand(engine_);
    restore(stand.world, {r.kind, r.content + 16, r.size - 16}, "making a shape of the recording");
    carom_collider_desc desc;
    Call call;
    call.done(carom_collider_desc_init(&desc, sizeof desc), "making a shape of the recording");
    call.done(carom_world_translate_handles(stand.world, &collider, 1, &collider, call),
              "making a shape of the recording");
    call.done(carom_collider_get(stand.world, collider, &desc, &body, call), "making a shape of the recording");
    shapes_[recorded] = desc.shape;
  }

  void learn_name(const Record& r) {
    const auto index = number<std::uint32_t>(r, 0);
    const std::string name(reinterpret_cast<const char*>(r.content) + 4, r.size - 4);
    if (index != rows_.size()) damaged("functions are named in another order");
    const Row* const row =
        std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& known) { return name == known.name; });
    if (row == std::end(kRows))
      throw Error("the recording calls " + name + ", which this program does not know", "use a newer carom");
    rows_.push_back(row);
  }

  void call(const Record& r) {
    const auto index = number<std::uint32_t>(r, 0);
    if (index >= rows_.size()) damaged("a call is of no function");
    Script script(stand_.world, shapes_, r.content + 4, r.size - 4);
    const int32_t result = rows_[index]->make(script);
    ++out_.calls;
    calls_.push_back(std::string(rows_[index]->name) + "(" + script.text() + ")");
    if (calls_.size() > kMostCalls) calls_.erase(calls_.begin());
    if (result == CAROM_OK) return;
    part();
    out_.parting->refused = script.heard().message;
    told_ = true;
  }

  void part() {
    out_.parting.emplace();
    out_.parting->step = stand_.steps();
    out_.parting->calls = calls_;
  }

  void compare_hash(const Record& r) {
    ++out_.steps;
    const std::uint64_t steps = stand_.steps();
    if (watch_) watch_(stand_.world, steps);
    const bool same = number<std::uint64_t>(r, 0) == steps && number<std::uint64_t>(r, 8) == stand_.hash();
    if (!same) return part();
    calls_.clear();
  }

  /// What was recorded of this step, beside what came out.
  void explain(const Record& r) {
    Parting& p = *out_.parting;
    carom_difference difference{};
    difference.struct_size = sizeof difference;
    Call call;
    call.done(carom_world_compare(stand_.world, r.content, r.size, &difference, call), "comparing with the recording");
    p.sections = difference.sections, p.first = difference.first, p.second = difference.second;
    if (difference.first >> 60 != 4) return;  // no body
    carom_world* recorded = nullptr;
    call.done(carom_world_fork(stand_.world, &recorded, call), "comparing with the recording");
    std::uint64_t there = 0;
    double now[13] = {}, then[13] = {};
    const bool read = carom_world_restore(recorded, r.content, r.size, call) == CAROM_OK &&
                      carom_world_translate_handles(recorded, &difference.first, 1, &there, call) == CAROM_OK &&
                      state_of(stand_.world, difference.first, now) && state_of(recorded, there, then);
    carom_world_destroy(recorded, nullptr);
    if (!read) return;
    static constexpr struct {
      const char* name;
      int at, n;
    } kParts[] = {{"position", 0, 3}, {"orientation", 3, 4}, {"linear velocity", 7, 3}, {"angular velocity", 10, 3}};
    for (const auto& part : kParts)
      if (std::memcmp(now + part.at, then + part.at, sizeof(double) * static_cast<std::size_t>(part.n)) != 0)
        p.details.push_back(std::string(part.name) + ": recorded " + shown(then + part.at, part.n) + ", replayed " +
                            shown(now + part.at, part.n));
  }
  static bool state_of(carom_world* world, carom_body body, double (&out)[13]) {
    return carom_world_read(world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, &body, 1, out, 0, nullptr) == CAROM_OK &&
           carom_world_read(world, CAROM_FIELD_VELOCITY, CAROM_SCALAR_F64, &body, 1, out + 7, 0, nullptr) == CAROM_OK;
  }
  static std::string shown(const double* v, int n) {
    std::string text = "(";
    for (int i = 0; i < n; ++i) {
      char one[40];
      std::snprintf(one, sizeof one, "%s%.17g", i ? ", " : "", v[i]);
      text += one;
    }
    return text + ")";
  }

  carom_engine* engine_;
  const std::function<void(carom_world*, std::uint64_t)>& watch_;
  Stand stand_;
  Outcome out_;
  bool told_ = false;
  std::vector<const Row*> rows_;
  std::map<std::uint64_t, carom_shape> shapes_;
  std::vector<std::string> calls_;
};

int32_t to_file(void* file, const void* bytes, std::uint64_t size) {
  return std::fwrite(bytes, 1, size, static_cast<std::FILE*>(file)) == size ? 0 : 1;
}

}  // namespace

Outcome play(carom_engine* engine, const Bytes& recording,
             const std::function<void(carom_world*, std::uint64_t)>& watch) {
  return Player(engine, watch).play(recording);
}

Bytes read_file(const std::string& path) {
  const std::string chars = tools::read_file(path, "check the path");
  const auto* const bytes = reinterpret_cast<const std::byte*>(chars.data());
  return Bytes(bytes, bytes + chars.size());
}

FileRecorder::FileRecorder(const World& world, const std::string& path, bool states)
    : world_(world.get()), path_(path), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_) throw Error("cannot write " + path, "check that its folder exists and is writable");
  Call call;
  const int32_t result =
      carom_world_record_begin(world_, states ? CAROM_RECORD_STATES : CAROM_RECORD_HASHES, to_file, file_, call);
  if (result != CAROM_OK) std::fclose(file_), file_ = nullptr;
  call.done(result, "recording to " + path);
}

FileRecorder::~FileRecorder() {
  if (!file_) return;
  carom_world_record_end(world_, nullptr);
  std::fclose(file_);
}

void FileRecorder::end() {
  Call call;
  const int32_t result = carom_world_record_end(world_, call);
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  call.done(result, "recording to " + path_);
  if (!closed) throw Error("cannot write " + path_, "check that the disk has space");
}

}  // namespace carom::tools::replay
