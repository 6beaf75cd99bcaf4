// `carom view`: the page and a scene packed on the spot come from this machine's own address, nothing else does, and it
// ends when it is told to.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "carom_command.h"

using command_test::Outcome;
using command_test::run_carom;
namespace fs = std::filesystem;

namespace {

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// A folder that goes when its test ends.
struct Folder {
  Folder() : path(fs::temp_directory_path() / ("carom_view_" + std::to_string(getpid()))) {
    fs::create_directories(path / "site" / "scenes");
    std::ofstream(path / "site" / "index.html") << "<title>page</title>";
    std::ofstream(path / "site" / "scenes" / "index.json")
        << R"([{"name": "stacks", "world": "old"}, {"name": "other"}])";
    std::ofstream(path / "secret.txt") << "SECRET";
    fs::create_symlink(path / "secret.txt", path / "site" / "link.txt");
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string site() const { return (path / "site").string(); }
  fs::path path;
};

/// `carom view` as a child. Its first line is its address.
class Viewer {
 public:
  explicit Viewer(const std::string& arguments) {
    const std::string line =
        "exec " + std::string(CAROM_COMMAND) + " --plugins " + CAROM_PLUGIN_DIR + " view --port 0 " + arguments;
    int out[2];
    assert_int_equal(pipe(out), 0);
    child_ = fork();
    if (child_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that fails jumps over destructors
      dup2(out[1], STDOUT_FILENO);
      close(out[0]), close(out[1]);
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    close(out[1]);
    std::string said;
    for (char c; said.find('\n') == std::string::npos && read(out[0], &c, 1) == 1;) said += c;
    close(out[0]);
    const std::size_t at = said.find("http://127.0.0.1:");
    if (at == std::string::npos) std::printf("no address in \"%s\"\n", said.c_str());
    assert_true(at != std::string::npos);
    port_ = std::atoi(said.c_str() + at + 17);
  }
  ~Viewer() {
    if (child_ > 0) kill(child_, SIGKILL), waitpid(child_, nullptr, 0);
  }
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// @return status and headers, an empty line, the content
  std::string ask(const std::string& path, const std::string& host = "127.0.0.1", const std::string& more = "") const {
    const int s = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET, to.sin_port = htons(static_cast<std::uint16_t>(port_)),
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    assert_int_equal(connect(s, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
    const std::string request = "GET " + path + " HTTP/1.1\r\nHost: " + host + ":" + std::to_string(port_) + "\r\n" +
                                more + "Connection: close\r\n\r\n";
    assert_int_equal(write(s, request.data(), request.size()), request.size());
    std::string answer;
    char some[4096];
    for (ssize_t n; (n = read(s, some, sizeof some)) > 0;) answer.append(some, static_cast<std::size_t>(n));
    close(s);
    return answer;
  }
  std::string content(const std::string& path) const {
    const std::string answer = ask(path);
    assert_true(answer.starts_with("HTTP/1.1 200"));
    return answer.substr(answer.find("\r\n\r\n") + 4);
  }
  int port() const { return port_; }

  /// @return exit status
  int end(int signal) {
    kill(child_, signal);
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t child_ = 0;
  int port_ = 0;
};

}  // namespace

static void a_page_and_its_scene_are_served(void**) {
  const Folder folder;
  Viewer viewer("--site " + folder.site() + " stacks --steps 3 --set n=4 --dial substeps=2");
  assert_string_equal(viewer.content("/").c_str(), "<title>page</title>");
  const std::string html = viewer.ask("/index.html");
  assert_true(html.find("Content-Type: text/html") != std::string::npos);
  assert_true(html.find("X-Content-Type-Options: nosniff") != std::string::npos);
  const nlohmann::json index = nlohmann::json::parse(viewer.content("/scenes/index.json"));
  assert_int_equal(index.size(), 2);  // the folder's own row of that scene is replaced
  assert_string_equal(index[0]["name"].get<std::string>().c_str(), "stacks");
  assert_true(index[0]["first"].get<bool>());
  assert_int_equal(index[0]["hashes"].size(), 4);
  assert_string_equal(index[1]["name"].get<std::string>().c_str(), "other");
  const std::string world = viewer.content("/scenes/stacks.world");
  assert_true(world.starts_with("CAROMSNP"));
  // The same bytes as a snapshot file: what it starts with hashes as its row says.
  const fs::path saved = folder.path / "stacks.world";
  std::ofstream(saved, std::ios::binary) << world;
  const Outcome again = run_carom("pack " + (folder.path / "packed").string() + " " + saved.string() + " --steps 3");
  assert_int_equal(again.code, 0);
  const nlohmann::json row = nlohmann::json::parse(bytes_of(folder.path / "packed" / "index.json"))[0];
  assert_true(row["hashes"] == index[0]["hashes"]);
  assert_int_equal(viewer.end(SIGINT), 0);
}

/// The page, its scripts, workers and scenes, those that are missing, too: a page is isolated only if all of it is.
static void pages_may_share_memory_between_threads(void**) {
  const Folder folder;
  Viewer viewer("--site " + folder.site() + " stacks --steps 1");
  for (const char* path : {"/", "/index.html", "/scenes/index.json", "/scenes/stacks.world", "/none.js"}) {
    const std::string answer = viewer.ask(path), headers = answer.substr(0, answer.find("\r\n\r\n"));
    for (const char* header : {"Cross-Origin-Opener-Policy: same-origin", "Cross-Origin-Embedder-Policy: require-corp",
                               "Cross-Origin-Resource-Policy: same-origin"}) {
      if (headers.find(header) == std::string::npos) std::printf("%s has no %s\n", path, header);
      assert_true(headers.find(header) != std::string::npos);
    }
  }
}

static void nothing_else_is_served(void**) {
  const Folder folder;
  Viewer viewer("--site " + folder.site());
  for (const char* path :
       {"/../secret.txt", "/scenes/../../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/link.txt",
        "//etc/passwd", "/etc/passwd", "/scenes", "/none", "/%00", "/index.html%00.js"}) {
    const std::string answer = viewer.ask(path);
    const bool refused = answer.starts_with("HTTP/1.1 404") || answer.starts_with("HTTP/1.1 400");
    if (!refused) std::printf("%s: %s\n", path, answer.c_str());
    assert_true(refused);
    assert_true(answer.find("SECRET") == std::string::npos);
  }
  // A name of somebody else that leads to this machine.
  const std::string foreign = viewer.ask("/index.html", "evil.example");
  assert_true(foreign.starts_with("HTTP/1.1 403"));
  assert_true(foreign.find("<title>") == std::string::npos);
  assert_string_equal(viewer.content("/index.html").c_str(), "<title>page</title>");
  // The port is taken.
  const Outcome second = run_carom("view --site " + folder.site() + " --port " + std::to_string(viewer.port()));
  assert_int_equal(second.code, 2);
  assert_true(second.says("--port 0"));
  assert_int_equal(viewer.end(SIGTERM), 0);
}

static void scenes_are_made_on_demand(void**) {
  const Folder folder;
  Viewer viewer("--site " + folder.site());
  const std::string made = viewer.content("/scenes/make?scene=stacks&set=n%3D4&set=height%3D3");
  std::size_t n = 0;
  for (std::size_t byte = 0; byte < 4; ++byte) n |= std::size_t(static_cast<unsigned char>(made[byte])) << (8 * byte);
  const nlohmann::json row = nlohmann::json::parse(made.substr(4, n));
  assert_int_equal(row["bodies"].size(), 13);  // four stacks of three, and the ground
  assert_true(row["knobs"][0]["value"] == 4);
  assert_true(made.substr(4 + n).starts_with("CAROMSNP"));
  for (const char* wrong : {"", "?scene=sesaw", "?scene=stacks&set=n=-1", "?scene=stacks&set=m=1",
                            "?scene=stacks&set=n", "?scene=/etc/passwd", "?scene=none.gltf"})
    assert_true(viewer.ask(std::string("/scenes/make") + wrong).starts_with("HTTP/1.1 400"));
  // Asked by a page of another site, whatever it may read of the answer.
  const std::string host = "127.0.0.1";
  const std::string foreign = viewer.ask("/scenes/make?scene=stacks", host, "Sec-Fetch-Site: cross-site\r\n");
  assert_true(foreign.starts_with("HTTP/1.1 403"));
  assert_int_equal(viewer.end(SIGTERM), 0);
}

static void recordings_are_served_as_they_are(void**) {
  const Folder folder;
  const fs::path file = folder.path / "a session.rec";
  assert_int_equal(run_carom("run stacks --seconds 0.1 --quiet --record '" + file.string() + "'").code, 0);
  Viewer viewer("--site " + folder.site() + " '" + file.string() + "'");
  assert_string_equal(
      nlohmann::json::parse(viewer.content("/scenes/index.json"))[0]["world"].get<std::string>().c_str(),
      "a_session.rec");
  assert_true(viewer.content("/scenes/a_session.rec") == bytes_of(file));
  assert_int_equal(viewer.end(SIGTERM), 0);
}

static void what_is_missing_is_told(void**) {
  const Folder folder;
  const struct {
    std::string line;
    const char* expected;
  } cases[] = {
      {"view --site " + folder.path.string(), "npm run build"},
      {"view sesaw --site " + folder.site(), "did you mean 'seesaw'"},
      {"view none.gltf --site " + folder.site(), "cannot read none.gltf"},
      {"view stacks --set n=-1 --site " + folder.site(), "what to do"},
      {"view --port 70000", "what to do"},
  };
  for (const auto& c : cases) {
    const Outcome o = run_carom(c.line);
    if (o.code != 2 || !o.says(c.expected)) std::printf("carom %s: %d\n%s\n", c.line.c_str(), o.code, o.text.c_str());
    assert_int_equal(o.code, 2);
    assert_true(o.says(c.expected) && o.says("what to do"));
  }
  std::ofstream(folder.path / "site" / "scenes" / "index.json") << "{";
  assert_true(run_carom("view stacks --steps 0 --site " + folder.site()).says("npm run build"));
}

static void without_its_library_it_says_what_to_install(void**) {
  const Folder folder;
  const Outcome o = run_carom("view --site " + folder.site());
  assert_int_equal(o.code, 2);
  assert_true(o.says("libcpp-httplib-dev"));
}

int main() {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_page_and_its_scene_are_served),
      cmocka_unit_test(pages_may_share_memory_between_threads),
      cmocka_unit_test(nothing_else_is_served),
      cmocka_unit_test(scenes_are_made_on_demand),
      cmocka_unit_test(recordings_are_served_as_they_are),
      cmocka_unit_test(what_is_missing_is_told),
  };
  const struct CMUnitTest without[] = {cmocka_unit_test(without_its_library_it_says_what_to_install),
                                       cmocka_unit_test(what_is_missing_is_told)};
  return CAROM_SERVES ? cmocka_run_group_tests_name("tools/view", tests, nullptr, nullptr)
                      : cmocka_run_group_tests_name("tools/view", without, nullptr, nullptr);
}
