// Devices, on one that this processor plays (host_opencl/): the text of devices as a C compiler takes it gives the host's
// bits; what a device may be refused for, and what a plugin's text; and NVIDIA's compiler takes all texts, without a card.
#include <dlfcn.h>

#include <atomic>
#include <fstream>
#include <sstream>

#include "bench.h"
#include "device_checks.h"

namespace {

using namespace device_checks;

/// So that the library finds this one when it asks for libOpenCL.so.1.
void play_device(const char* manner) {
  static void* const library = dlopen(CAROM_HOST_OPENCL, RTLD_NOW | RTLD_LOCAL);
  assert_non_null(library);
  setenv("HOST_OPENCL", manner, 1);
}

void the_bits_are_the_hosts_for_any_number_of_threads(void**) {
  play_device("");
  for (const uint32_t threads : {1u, 2u, 3u}) {
    carom_engine* engine = engine_of(threads);
    carom_error why;
    carom_device* device = device_of(engine, why);
    assert_non_null(device);
    check_bits(engine, device, threads == 2 ? 100000 : 5000);
    close(engine, device);
  }
}

void devices_that_are_none_are_refused(void**) {
  struct Case {
    const char* manner;
    int32_t code;
    const char* what;
  };
  std::vector<Case> cases = {{"none", CAROM_E_NOT_FOUND, "OpenCL has 0 devices"},
                             {"single", CAROM_E_UNSUPPORTED, "no double precision"}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("fma")) cases.push_back({"contract", CAROM_E_UNSUPPORTED, "rounds otherwise"});
#endif
  carom_engine* engine = engine_of(1);
  for (const Case& c : cases) {
    play_device(c.manner);
    carom_error e;
    assert_null(device_of(engine, e));
    assert_int_equal(e.code, c.code);
    if (!std::strstr(e.message, c.what)) print_error("\"%s\" lacks \"%s\"", e.message, c.what), assert_true(false);
    assert_non_null(std::strstr(e.remedy, "ask on the host"));
  }
  play_device("");
  carom_device* device = nullptr;
  assert_int_equal(carom_device_create(engine, 1, &device, nullptr), CAROM_E_NOT_FOUND);
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

void an_engine_with_a_device_stays(void**) {
  play_device("quick");
  carom_engine* engine = engine_of(1);
  carom_error e;
  carom_device* device = device_of(engine, e);
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_E_IN_USE);
  assert_int_equal(carom_engine_set_jobs(engine, nullptr, nullptr), CAROM_E_IN_USE);
  close(engine, device);
}

/// Ways to ask, and a driver, that fail: the results stay as they were.
void what_a_device_cannot_do_is_said(void**) {
  play_device("quick");
  carom_engine* engine = engine_of(1);
  carom_error e;
  carom_device* device = device_of(engine, e);
  const Pairs pairs = pairs_of_all_kinds(engine, 50);
  const carom_pairs view = pairs.view();
  std::vector<carom_distance> out(pairs.size());
  std::memset(out.data(), 0x55, out.size() * sizeof out[0]);
  const auto before = out;
  carom_distance_desc johnson, routines;
  carom_distance_desc_init(&johnson, sizeof johnson), carom_distance_desc_init(&routines, sizeof routines);
  johnson.simplex = CAROM_SIMPLEX_JOHNSON, routines.pair_routines = 1;
  for (const carom_distance_desc* d : {&johnson, &routines}) {
    e = CAROM_ERROR_INIT;
    assert_int_equal(carom_device_pairs_distance(device, &view, d, out.data(), sizeof out[0], &e), CAROM_E_UNSUPPORTED);
    assert_int_equal(e.argument, 3);
  }
  play_device("fails");
  e = CAROM_ERROR_INIT;
  assert_int_equal(carom_device_pairs_distance(device, &view, nullptr, out.data(), sizeof out[0], &e),
                   CAROM_E_UNSUPPORTED);
  assert_non_null(std::strstr(e.message, "OpenCL says -36"));
  play_device("quick");
  assert_memory_equal(out.data(), before.data(), out.size() * sizeof out[0]);
  assert_same(on_device(device, pairs, nullptr), on_host(engine, pairs, nullptr));  // and it goes on
  close(engine, device);
}

CAROM_SUPPORT_TEXT(static int32_t support(void* user, carom_params p, uint64_t n, const double dir[3], double out[3]) {
  (void)user, (void)n;
  for (int i = 0; i < 3; ++i) out[i] = dir[i] < 0 ? -p[i] : p[i];
  return 0;
})

std::atomic<bool> lies{false};
/// A box until it lies, in a cone of directions only.
int32_t lying_support(void*, const double* p, uint64_t, const double dir[3], double out[3]) {
  support(nullptr, p, 3, dir, out);
  if (lies && dir[0] > 0 && dir[1] > 0.3 * dir[0] && dir[1] < 0.31 * dir[0]) out[2] = 0.0 / 0.0;
  return 0;
}
const char* const kLyingText =
    "static int32_t support(void *user, carom_params p, uint64_t n, const double dir[3], double out[3]) {"
    "  int i;"
    "  for (i = 0; i < 3; ++i) out[i] = dir[i] < 0 ? -p[i] : p[i];"
    "  if (dir[0] > 0 && dir[1] > 0.3 * dir[0] && dir[1] < 0.31 * dir[0]) out[2] = 0.0 / 0.0;"
    "  return 0; }";

void texts_that_are_none_are_refused_with_the_reason(void**) {
  play_device("quick");
  struct Case {
    const char *text, *what;
  };
  const std::string box = support_text;
  const auto with = [&](const char* from, const char* to) {
    std::string changed = box;
    changed.replace(changed.find(from), std::strlen(from), to);
    return changed;
  };
  const std::string calls = with("return 0;", "out[0] = hypot(out[0], 0.0); return 0;"),
                    broken = with("out[3]) {", "out[3]) { double x = y;"),
                    other = with("-p[i] : p[i]", "-p[i] : p[i] * 1.0000001"),
                    single = with("return 0;", "float x = 1; return 0;"), line = "#define X 1\n" + box,
                    quoted = with("return 0;", "\"x\"; return 0;"), renamed = with("support", "supports"),
                    refuses = with("return 0;", "return 1;"),
                    device_word = with("return 0;", "get_global_id(0); return 0;");
  const Case cases[] = {
      {nullptr, "no text of the support function comes with plugin test.box"},
      {"", "no text of the support function comes with plugin test.box"},
      {calls.c_str(), "calls a function that is neither its own nor sqrt() nor fabs(): hypot"},
      {device_word.c_str(), "nor fabs(): get_global_id"},
      {broken.c_str(), "error"},
      {"int32_t support(", "error"},
      {"static double support(void) { return 1.0; }", "error"},
      {other.c_str(), "other bits"},
      {refuses.c_str(), "other bits"},
      {single.c_str(), "has the word float"},
      {line.c_str(), "no text may have: #"},
      {quoted.c_str(), "no text may have: \""},
      {renamed.c_str(), "defines no function support()"},
  };
  for (const Case& c : cases) {
    carom_engine* engine = engine_of(1);
    carom_error e;
    carom_device* device = device_of(engine, e);
    carom_shape_plugin plugin = bench_plugin("test.box", bench_box_params, 3, nullptr, support);
    plugin.text = c.text;
    carom_plugin handle;
    carom_shape shape;
    const double half[3] = {0.5, 0.6, 0.7};
    assert_int_equal(carom_plugin_register(engine, &plugin, &handle, nullptr), CAROM_OK);
    assert_int_equal(carom_shape_create(engine, handle, half, 3, &shape, nullptr), CAROM_OK);
    auto shapes = shapes_of_all_kinds(engine, 1, 1);
    Pairs pairs;
    draw(pairs, shapes, 2, 100, 3, 3);
    pairs.shapes[1][57] = shape;
    std::vector<carom_distance> out(pairs.size());
    std::memset(out.data(), 0x55, out.size() * sizeof out[0]);
    const auto before = out;
    const carom_pairs view = pairs.view();
    for (int twice = 0; twice < 2; ++twice) {
      e = CAROM_ERROR_INIT;
      const int32_t code = carom_device_pairs_distance(device, &view, nullptr, out.data(), sizeof out[0], &e);
      if (code != CAROM_E_UNSUPPORTED || !std::strstr(e.message, c.what) ||
          !std::strstr(e.message, "shape_b of pair 57"))
        print_error("%s, not: %s", e.message, c.what), assert_true(false);
      assert_int_equal(e.has_witness, std::strcmp(c.what, "other bits") == 0);
      assert_memory_equal(out.data(), before.data(), out.size() * sizeof out[0]);
    }
    on_host(engine, pairs, nullptr);
    pairs.shapes[1][57] = shapes[0];  // without it the device goes on
    assert_same(on_device(device, pairs, nullptr), on_host(engine, pairs, nullptr));
    close(engine, device);
  }
}

void an_old_plugin_and_a_hull_of_round_shapes_are_asked_on_the_host_alone(void**) {
  play_device("quick");
  carom_engine* engine = engine_of(1);
  carom_error e;
  carom_device* device = device_of(engine, e);
  carom_shape_plugin plugin = bench_plugin("test.box", bench_box_params, 3, nullptr, support);
  plugin.struct_size = offsetof(carom_shape_plugin, text);  // as it was before texts
  plugin.text = "no text: it is not there";
  carom_plugin handle;
  carom_shape old, hull;
  const double half[3] = {0.5, 0.6, 0.7}, ends[6] = {0, 0, 0, 1, 0, 0};
  assert_int_equal(carom_plugin_register(engine, &plugin, &handle, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_create(engine, handle, half, 3, &old, nullptr), CAROM_OK);
  const carom_shape balls[2] = {named(engine, "sphere", {0.5}), named(engine, "sphere", {0.2})};
  assert_int_equal(carom_shape_create_hull_of(engine, balls, 2, ends, nullptr, nullptr, 0, &hull, nullptr), CAROM_OK);
  for (const carom_shape shape : {old, hull}) {
    Pairs pairs;
    draw(pairs, {shape}, 2, 10, 3, 3);
    carom_distance out[10];
    const carom_pairs view = pairs.view();
    e = CAROM_ERROR_INIT;
    assert_int_equal(carom_device_pairs_distance(device, &view, nullptr, out, sizeof out[0], &e), CAROM_E_UNSUPPORTED);
    assert_non_null(std::strstr(e.message, shape == old ? "plugin test.box" : "a hull of round shapes"));
    assert_same(on_host(engine, pairs, nullptr), one_by_one(engine, pairs, nullptr));
  }
  close(engine, device);
}

/// NaN in a cone that no check looks into: such pairs are the host's, and FAULT there as well.
void a_function_that_misbehaves_is_the_hosts_to_judge(void**) {
  play_device("quick");
  carom_engine* engine = engine_of(2);
  carom_error e;
  carom_device* device = device_of(engine, e);
  carom_shape_plugin plugin = bench_plugin("test.liar", bench_box_params, 3, nullptr, lying_support);
  plugin.text = kLyingText;
  carom_plugin handle;
  carom_shape liar;
  const double half[3] = {0.5, 0.6, 0.7};
  assert_int_equal(carom_plugin_register(engine, &plugin, &handle, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_create(engine, handle, half, 3, &liar, nullptr), CAROM_OK);
  auto shapes = shapes_of_all_kinds(engine, 1, 1);
  shapes.push_back(liar), shapes.push_back(liar), shapes.push_back(liar);
  Pairs pairs;
  draw(pairs, shapes, 2, 20000, 3, 2);
  lies = true;
  const auto found = on_device(device, pairs, nullptr), truth = on_host(engine, pairs, nullptr);
  lies = false;
  std::size_t faults = 0;
  for (const carom_distance& d : found) faults += d.status == CAROM_QUERY_FAULT;
  assert_true(faults > 5);
  assert_same(found, truth);
  close(engine, device);
}

/// The text with all shipped plugins, compiled for a card of today.
void nvidias_compiler_takes_all_texts_without_a_card(void**) {
  const char* const named_file = getenv("CAROM_NVRTC");
  void* const nvrtc = dlopen(named_file ? named_file : "libnvrtc.so.12", RTLD_NOW | RTLD_LOCAL);
  if (!nvrtc) {
    std::printf(
        "skipped: no NVRTC. Unpack the wheel nvidia-cuda-nvrtc-cu12, and name its lib/libnvrtc.so.12 in CAROM_NVRTC\n");
    skip();
  }
  play_device("quick");
  char path[] = "/tmp/carom_device_text_XXXXXX";
  assert_true(mkstemp(path) >= 0);
  setenv("HOST_OPENCL_TEXT", path, 1);
  carom_engine* engine = engine_of(1);
  carom_error e;
  carom_device* device = device_of(engine, e);
  // With a core that is not their form's, plugins speak for themselves.
  const char* const names[] = {"box",    "capsule",         "cone",    "cylinder", "ellipsoid", "hull",
                               "sphere", "tapered_capsule", "template"};
  std::vector<carom_shape_plugin> plugins;
  std::vector<std::string> ids;
  std::vector<carom_shape> shapes;
  ids.reserve(9), plugins.reserve(9);
  for (const char* name : names) {
    void* const file = dlopen((std::string(CAROM_PLUGIN_DIR "/") + name + ".so").c_str(), RTLD_NOW);
    assert_non_null(file);
    plugins.push_back(*static_cast<const carom_shape_plugin*>(dlsym(file, CAROM_SHAPE_PLUGIN_SYMBOL)));
    assert_non_null(plugins.back().text);
    ids.push_back(std::string("alone.") + name);
    plugins.back().id = ids.back().c_str(), plugins.back().geometry = nullptr;
    carom_plugin handle;
    const std::vector<double> cloud = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::string this_name = name;
    const uint64_t count = this_name == "hull" ? 12 : plugins.back().param_count;
    const double numbers[3] = {0.5, 0.6, 0.7};
    carom_shape shape = 0;
    if (this_name == "sphere" || this_name == "capsule") continue;  // their function is that of a core alone: below
    assert_int_equal(carom_plugin_register(engine, &plugins.back(), &handle, nullptr), CAROM_OK);
    assert_int_equal(
        carom_shape_create(engine, handle, this_name == "hull" ? cloud.data() : numbers, count, &shape, nullptr),
        CAROM_OK);
    shapes.push_back(shape);
  }
  Pairs pairs;
  draw(pairs, shapes, 2, 2000, 3, 2);
  assert_same(on_device(device, pairs, nullptr), on_host(engine, pairs, nullptr));
  close(engine, device);
  unsetenv("HOST_OPENCL_TEXT");
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  std::remove(path);
  assert_true(text.str().size() > 20000 && text.str().find("p6_support") != std::string::npos);
  using Program = void*;
  const auto create =
      reinterpret_cast<int (*)(Program*, const char*, const char*, int, const char* const*, const char* const*)>(
          dlsym(nvrtc, "nvrtcCreateProgram"));
  const auto compile = reinterpret_cast<int (*)(Program, int, const char* const*)>(dlsym(nvrtc, "nvrtcCompileProgram"));
  const auto log_size = reinterpret_cast<int (*)(Program, size_t*)>(dlsym(nvrtc, "nvrtcGetProgramLogSize"));
  const auto get_log = reinterpret_cast<int (*)(Program, char*)>(dlsym(nvrtc, "nvrtcGetProgramLog"));
  const auto code_size = reinterpret_cast<int (*)(Program, size_t*)>(dlsym(nvrtc, "nvrtcGetPTXSize"));
  Program program = nullptr;
  const char* const options[] = {"--fmad=false", "--device-as-default-execution-space",
                                 "--gpu-architecture=compute_90"};
  size_t size = 0;
  assert_int_equal(create(&program, text.str().c_str(), "pairs.cu", 0, nullptr, nullptr), 0);
  if (compile(program, 3, options) != 0) {
    log_size(program, &size);
    std::string log(size, 0);
    get_log(program, log.data());
    print_error("%s", log.c_str());
    assert_true(false);
  }
  assert_int_equal(code_size(program, &size), 0);
  std::printf("NVRTC: %zu bytes of text are %zu bytes of code\n", text.str().size(), size);
  assert_true(size > 10000);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_bits_are_the_hosts_for_any_number_of_threads),
      cmocka_unit_test(devices_that_are_none_are_refused),
      cmocka_unit_test(an_engine_with_a_device_stays),
      cmocka_unit_test(what_a_device_cannot_do_is_said),
      cmocka_unit_test(texts_that_are_none_are_refused_with_the_reason),
      cmocka_unit_test(an_old_plugin_and_a_hull_of_round_shapes_are_asked_on_the_host_alone),
      cmocka_unit_test(a_function_that_misbehaves_is_the_hosts_to_judge),
      cmocka_unit_test(nvidias_compiler_takes_all_texts_without_a_card),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
