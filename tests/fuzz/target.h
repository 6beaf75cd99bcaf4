// What can be fuzzed: something that bytes become, that is judged, and that goes to text and back.
#pragma once

#include <memory>

#include "judge.h"

namespace carom::fuzz {

class Target {
 public:
  virtual ~Target() = default;
  virtual void take(const std::uint8_t* bytes, std::size_t size) = 0;
  virtual Verdict verdict() const = 0;
  virtual std::string line() const = 0;
  virtual bool read(const std::string& text) = 0;
};

template <class Case>
class TargetOf : public Target {
 public:
  void take(const std::uint8_t* bytes, std::size_t size) override { decode(bytes, size, case_); }
  Verdict verdict() const override { return judge(case_); }
  std::string line() const override { return to_text(case_); }
  bool read(const std::string& text) override { return from_text(text, case_); }

 private:
  Case case_;
};

std::unique_ptr<Target> pair_target();
std::unique_ptr<Target> cast_target();

/// What libFuzzer calls: judge, and abort with a reproducer where the verdict is bad.
void judge_or_abort(Target& target, const std::uint8_t* bytes, std::size_t size);

}  // namespace carom::fuzz
