// Plugins' texts, made ready to stand beside each other. A text is read as words: what is no word of C, type or function
// that it may use is a name of its own.
#include "abi/device_text.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace carom::abi {
namespace {

// In order, for a binary search.
constexpr std::array<std::string_view, 29> kWords = {
    "INFINITY", "break",  "carom_params", "case",   "char",   "const",  "continue", "default",  "do",      "double",
    "else",     "enum",   "fabs",         "for",    "if",     "inline", "int",      "int32_t",  "int64_t", "return",
    "signed",   "sizeof", "sqrt",         "static", "struct", "switch", "typedef",  "uint32_t", "uint64_t"};
constexpr std::array<std::string_view, 3> kMoreWords = {"unsigned", "void", "while"};
/// Words of C whose meaning is another on a device, or that do not belong into a pure function.
constexpr std::array<std::string_view, 11> kRefused = {"asm",      "auto",  "extern", "float",    "goto",    "long",
                                                       "register", "short", "union",  "volatile", "restrict"};

template <std::size_t kCount>
bool has(const std::array<std::string_view, kCount>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}
bool is_known(std::string_view word) { return has(kWords, word) || has(kMoreWords, word); }
/// Words that a parenthesis follows without a call.
bool takes_parenthesis(std::string_view word) {
  return word == "if" || word == "for" || word == "while" || word == "switch" || word == "return" || word == "sizeof" ||
         word == "sqrt" || word == "fabs";
}

bool starts_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool goes_on(char c) { return starts_word(c) || is_digit(c); }

/// Reads a text word by word.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  /// What comes next: a word, a number, blanks and comments as one blank, or a character. Empty at the end.
  std::string_view next() {
    const std::size_t begin = at_;
    if (begin >= text_.size()) return {};
    if (skip_blanks()) return " ";
    const char c = text_[at_++];
    if (starts_word(c)) {
      while (at_ < text_.size() && goes_on(text_[at_])) ++at_;
    } else if (is_digit(c) || (c == '.' && is_digit(peek()))) {  // 1.5e-3, 0x1p-3, 7u
      while (at_ < text_.size() && (goes_on(text_[at_]) || text_[at_] == '.' || is_exponent_sign())) ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }
  /// The next character that is no blank; 0 at the end.
  char peek_solid() {
    const std::size_t before = at_;
    skip_blanks();
    const char c = peek();
    at_ = before;
    return c;
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : char(0); }
  bool is_exponent_sign() const {
    const char c = text_[at_], before = text_[at_ - 1];
    return (c == '+' || c == '-') && (before == 'e' || before == 'E' || before == 'p' || before == 'P');
  }
  bool skip_blanks() {
    const std::size_t begin = at_;
    for (;;) {
      if (const char c = peek(); c == ' ' || (c >= '\t' && c <= '\r')) {
        ++at_;
      } else if (c == '/' && peek(1) == '*') {
        at_ = std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
      } else if (c == '/' && peek(1) == '/') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        return at_ > begin;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

bool add_plugin_text(std::string_view text, std::uint32_t number, std::pmr::string& program, char* why,
                     std::size_t size) {
  const auto refuse = [&](const char* what, std::string_view word) {
    std::snprintf(why, size, "%s %.*s", what, static_cast<int>(std::min<std::size_t>(word.size(), 40)), word.data());
    return false;
  };
  char prefix[16];
  std::snprintf(prefix, sizeof prefix, "p%u_", number);
  Array<std::string_view> functions(program.get_allocator().resource());
  Words words(text);
  int depth = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    const char c = word[0];
    if (c == '#' || c == '"' || c == '\'' || c == '\\' || c == '`' || c == '@' || c == '$' || c < ' ' || c > '~')
      return refuse("has a character that no text may have:", c < ' ' || c > '~' ? "one beyond ASCII" : word);
    depth += (c == '{') - (c == '}');
    if (!starts_word(c)) {
      program.append(word);
      continue;
    }
    if (has(kRefused, word)) return refuse("has the word", word);
    if (is_known(word)) {
      program.append(word);
      continue;
    }
    if (words.peek_solid() == '(' && !takes_parenthesis(word)) {
      const bool known = std::find(functions.begin(), functions.end(), word) != functions.end();
      if (!known && depth > 0) return refuse("calls a function that is neither its own nor sqrt() nor fabs():", word);
      if (!known) functions.push_back(word);
    }
    program.append(prefix).append(word);
  }
  if (std::find(functions.begin(), functions.end(), "support") == functions.end())
    return refuse("defines no function", "support()");
  program.push_back('\n');
  return true;
}

void add_ask(std::uint32_t count, std::pmr::string& program) {
  program.append(
      "static int32_t carom_ask(uint32_t plugin, carom_params params, uint64_t count, const double* dir, double* out) {\n"
      "  switch (plugin) {\n");
  for (std::uint32_t i = 0; i < count; ++i) {
    char line[96];
    std::snprintf(line, sizeof line, "    case %u: return p%u_support(0, params, count, dir, out);\n", i, i);
    program.append(line);
  }
  program.append("    default: return -1;\n  }\n}\n");
}

}  // namespace carom::abi
