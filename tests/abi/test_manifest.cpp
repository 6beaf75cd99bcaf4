// The layout gate: what the compiler made of the headers (carom_abi_manifest) is what bindings/api.json tells bindings,
// and what manifest.txt says older clients were built with. The gate itself is tried on broken layouts.
#include <carom/carom.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "carom_test.h"

namespace {

struct Row {
  unsigned long offset, size;
  std::string kind;
  bool operator==(const Row& other) const = default;
};
using Layout = std::map<std::string, Row>;

std::string read(const std::string& path) {
  std::ifstream in(path);
  assert_true(in.good());
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Lines "name offset size kind" but the first; a line of another form fails the test, and so does a name that comes
/// twice.
Layout parse(const std::string& text) {
  static const std::regex form(
      "(carom_[a-z0-9_]+(\\.[a-z0-9_]+)?) ([0-9]+) ([0-9]+) "
      "(struct|(u32|i32|u64|f64|char|ptr|fn)(\\[[0-9]+\\])?)");
  Layout layout;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::smatch part;
    if (!std::regex_match(line, part, form)) print_error("not a line of a manifest: %s\n", line.c_str());
    assert_false(part.empty());
    assert_int_equal(part[2].matched, part[5] != "struct");
    const bool is_new = layout.emplace(part[1], Row{std::stoul(part[3]), std::stoul(part[4]), part[5]}).second;
    assert_true(is_new);
  }
  return layout;
}

const nlohmann::json& api() {
  static const nlohmann::json data = nlohmann::json::parse(read(CAROM_SOURCE_DIR "/bindings/api.json"));
  return data;
}

/// Structs that never grow: of an array whose stride nobody need say, or filled by an *_init() that is not told the
/// size.
std::set<std::string> fixed_structs() {
  std::set<std::string> names = {"carom_param", "carom_draw_line", "carom_world_hit", "carom_ray_hit"};
  for (const auto& function : api()["functions"]) {
    const std::string name = function["name"];
    const auto& arguments = function["arguments"];
    if (name.ends_with("_init") && arguments.back()["name"] != "struct_size")
      names.insert(name.substr(0, name.size() - 5));
  }
  return names;
}

/// What clients that were built with `before` would suffer from a library that has `now`.
std::vector<std::string> breaks(const Layout& before, const Layout& now, const std::set<std::string>& fixed) {
  std::vector<std::string> out;
  for (const auto& [name, row] : before) {
    const auto at = now.find(name);
    if (at == now.end())
      out.push_back(name + " is gone");
    else if (row.kind == "struct" && at->second.kind == "struct" && at->second.size > row.size && !fixed.count(name))
      continue;  // a report that grew behind what older clients know
    else if (at->second != row)
      out.push_back(name + " was " + row.kind + " at " + std::to_string(row.offset) + ", " + std::to_string(row.size) +
                    " bytes; now " + at->second.kind + " at " + std::to_string(at->second.offset) + ", " +
                    std::to_string(at->second.size));
  }
  return out;
}

void the_first_line_is_the_version(void**) {
  std::uint32_t major, minor, patch;
  assert_int_equal(carom_version(&major, &minor, &patch), CAROM_OK);
  const std::string expected =
      "carom " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch) + "\n";
  const std::string text = carom_abi_manifest();
  assert_string_equal(text.substr(0, expected.size()).c_str(), expected.c_str());
  assert_int_equal(text.back(), '\n');
  assert_ptr_equal(carom_abi_manifest(), carom_abi_manifest());
}

// Two readers of the headers that know nothing of each other: bindings/gen and the compiler of this library.
void api_json_has_the_layout_of_the_compiler(void**) {
  const Layout compiled = parse(carom_abi_manifest());
  std::size_t rows = 0;
  for (const auto& s : api()["structs"]) {
    const std::string name = s["name"];
    const auto whole = compiled.find(name);
    assert_true(whole != compiled.end());
    assert_int_equal(whole->second.size, s["size"].get<unsigned long>());
    ++rows;
    for (const auto& f : s["fields"]) {
      const auto at = compiled.find(name + "." + f["name"].get<std::string>());
      const bool same = at != compiled.end() &&
                        at->second == Row{f["offset"].get<unsigned long>(), f["size"].get<unsigned long>(), f["kind"]};
      if (!same)
        print_error("api.json: %s.%s is not as compiled\n", name.c_str(), f["name"].get<std::string>().c_str());
      assert_true(same);
      ++rows;
    }
  }
  assert_int_equal(rows, compiled.size());
  assert_true(rows > 400);
}

// Every struct of a header is there: sizes of some, taken here, by hand.
void sizes_are_sizeof(void**) {
  const Layout layout = parse(carom_abi_manifest());
  assert_int_equal(layout.at("carom_error").size, sizeof(carom_error));
  assert_int_equal(layout.at("carom_body_desc").size, sizeof(carom_body_desc));
  assert_int_equal(layout.at("carom_world_hits").size, sizeof(carom_world_hits));
  assert_int_equal(layout.at("carom_shape_plugin.support").offset, offsetof(carom_shape_plugin, support));
  assert_string_equal(layout.at("carom_shape_plugin.support").kind.c_str(), "fn");
  assert_string_equal(layout.at("carom_geometry.mass_arg").kind.c_str(), "u32[4]");
  assert_string_equal(layout.at("carom_body_desc.inertia").kind.c_str(), "f64[9]");
}

// What bindings ask: a text as their own is, with a change.
void a_client_of_another_layout_is_refused(void**) {
  const std::string own = carom_abi_manifest(), version = own.substr(0, own.find('\n'));
  carom_error e = CAROM_ERROR_INIT;
  const auto answer = [&](const std::string& layout) { return carom_abi_check(layout.c_str(), &e); };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = own;
    assert_int_not_equal(changed.find(from), std::string::npos);
    return changed.replace(changed.find(from), from.size(), to);
  };
  const auto refused = [&](const std::string& layout, const char* why) {
    assert_int_equal(answer(layout), CAROM_E_UNSUPPORTED);
    if (!std::strstr(e.message, why)) print_error("%s lacks %s\n", e.message, why);
    assert_true(std::strstr(e.message, why) && std::strstr(e.message, "libcarom"));
    assert_non_null(std::strstr(e.remedy, "of one version"));
  };
  assert_int_equal(answer(own), CAROM_OK);
  assert_int_equal(answer(version), CAROM_OK);
  const Row error = parse(own.c_str()).at("carom_error");
  const std::string whole = "\ncarom_error 0 ", size = std::to_string(error.size);
  assert_int_equal(answer(with(whole + size, whole + "8")), CAROM_OK);  // it has grown since
  refused(with(whole + size, whole + size + "0"), "has carom_error as 0 ");
  refused(with(whole + size, whole + "x"), "has carom_error as 0 ");
  refused(with("carom_error.code 4 4 i32", "carom_error.code 4 4 u32"), "has carom_error.code as 4 4 i32 ");
  refused(with("carom_error.code 4 4 i32", "carom_error.code 0 4 i32"), "its caller as 0 4 i32");
  refused(with("carom_error.code 4 4 i32", "carom_error.code"), "has carom_error.code as 4 4 i32 ");
  refused(with("carom_error.code", "carom_error.cod"), "has no carom_error.cod");
  const int major = CAROM_VERSION_MAJOR, minor = CAROM_VERSION_MINOR;
  for (const auto& [a, b] : {std::pair(major, minor + 1), {major + 1, 0}, {major + 1, minor}, {99, 0}})
    refused("carom " + std::to_string(a) + "." + std::to_string(b) + ".0" + own.substr(version.size()),
            "is of version ");
  refused(version + "9", "is of version ");
  for (const char* other :
       {"", "carom", "carom ", "carom 0.9", "carom 0.9.", "carom 0.9.0.1", "carom 0.9.x", "carom -1.9.0", "ELF"})
    assert_int_equal(answer(other), CAROM_E_OUT_OF_RANGE);
}

void no_client_is_broken(void**) {
  const Layout baseline = parse(read(CAROM_SOURCE_DIR "/tests/abi/manifest.txt"));
  const Layout now = parse(carom_abi_manifest());
  const auto broken = breaks(baseline, now, fixed_structs());
  for (const auto& what : broken) print_error("clients of an older library break: %s\n", what.c_str());
  assert_int_equal(broken.size(), 0);
  // The baseline grows with the headers, so that what is new today is kept tomorrow.
  std::size_t unlisted = 0;
  for (const auto& [name, row] : now) {
    const auto at = baseline.find(name);
    if (at != baseline.end() && at->second == row) continue;
    if (!unlisted++)
      print_error("tests/abi/manifest.txt wants these lines (in place of shorter structs' of that name):\n");
    print_error("%s %lu %lu %s\n", name.c_str(), row.offset, row.size, row.kind.c_str());
  }
  assert_int_equal(unlisted, 0);
}

// Would the gate notice? Each change that breaks a client is a complaint, and what does not break one is none.
void a_broken_layout_does_not_pass(void**) {
  const Layout sound = parse(carom_abi_manifest());
  const std::set<std::string> fixed = fixed_structs();
  const auto complaints = [&](auto&& change) {
    Layout changed = sound;
    change(changed);
    return breaks(sound, changed, fixed).size();
  };
  assert_int_equal(complaints([](Layout&) {}), 0);
  assert_int_equal(complaints([](Layout& l) {
                     l["carom_contact.separation"] = {l["carom_contact.separation"].offset, 4, "f32"};
                   }),
                   1);
  assert_int_equal(complaints([](Layout& l) { std::swap(l["carom_contact.point"], l["carom_contact.normal"]); }), 2);
  assert_int_equal(complaints([](Layout& l) { l.erase("carom_plan_line.reason"); }), 1);
  assert_int_equal(complaints([](Layout& l) { l["carom_hit.kind"].kind = "u32"; }), 0);  // a new one
  assert_int_equal(complaints([](Layout& l) { l["carom_step_report"].size += 8; }), 0);  // a report grew
  assert_int_equal(complaints([](Layout& l) { l["carom_step_report"].size -= 8; }), 1);
  assert_int_equal(complaints([](Layout& l) { l["carom_body_desc"].size += 8; }), 0);  // a descriptor grew
  assert_int_equal(complaints([](Layout& l) { l["carom_param"].size += 8; }), 1);
  assert_int_equal(complaints([](Layout& l) { l["carom_body_desc.user"].kind = "i64"; }), 1);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_first_line_is_the_version),
      cmocka_unit_test(api_json_has_the_layout_of_the_compiler),
      cmocka_unit_test(sizes_are_sizeof),
      cmocka_unit_test(a_client_of_another_layout_is_refused),
      cmocka_unit_test(no_client_is_broken),
      cmocka_unit_test(a_broken_layout_does_not_pass),
  };
  return cmocka_run_group_tests_name("abi/manifest", tests, nullptr, nullptr);
}
