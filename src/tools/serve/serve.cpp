#include "serve/serve.h"

#include <httplib.h>
#include <pthread.h>

#include <csignal>
#include <mutex>
#include <thread>

#include "host/files.h"
#include "host/host.h"

namespace carom::tools::serve {
namespace {

constexpr int kThreads = 4;

const char* type_of(const std::string& path) {
  static constexpr struct {
    const char *ending, *type;
  } kTypes[] = {{".html", "text/html; charset=utf-8"},
                {".js", "text/javascript; charset=utf-8"},
                {".css", "text/css; charset=utf-8"},
                {".json", "application/json"},
                {".wasm", "application/wasm"},
                {".txt", "text/plain; charset=utf-8"},
                {".md", "text/plain; charset=utf-8"},
                {".png", "image/png"},
                {".svg", "image/svg+xml"}};
  for (const auto& row : kTypes)
    if (path.ends_with(row.ending)) return row.type;
  return "application/octet-stream";
}

/// Whether a request was meant for this machine: "127.0.0.1:8011". A name that somebody else's server resolves to this
/// address is another host.
bool is_local(const httplib::Request& request) {
  std::string host = request.get_header_value("Host");
  host.resize(std::min(host.size(), host.rfind(':')));
  return host == "127.0.0.1" || host == "localhost";
}

/// What takes time and memory is done for the page alone, not for a page of another site that only sends the request.
void make(const Site& site, const httplib::Request& request, httplib::Response& response) {
  static std::mutex one_at_a_time;
  const std::string from = request.get_header_value("Sec-Fetch-Site");
  if (!from.empty() && from != "same-origin" && from != "none") {
    response.status = 403;
    return response.set_content("this is asked by the page of this address alone\n", "text/plain");
  }
  try {
    const std::lock_guard lock(one_at_a_time);
    response.set_content(site.make(Question(request.params.begin(), request.params.end())), "application/octet-stream");
  } catch (const Error& error) {
    response.status = 400;
    response.set_content(std::string(error.what()) + "; " + error.remedy + "\n", "text/plain; charset=utf-8");
  }
}

void respond(const Site& site, const httplib::Request& request, httplib::Response& response) {
  if (!is_local(request)) {
    response.status = 403;
    response.set_content("this page is for its own machine: ask for http://127.0.0.1\n", "text/plain");
    return;
  }
  const std::string path = request.path.ends_with('/') ? request.path + "index.html" : request.path;
  if (path == "/scenes/make" && site.make) return make(site, request, response);
  const auto made = site.in_place.find(path);
  if (made != site.in_place.end()) return response.set_content(made->second, type_of(path));
  try {
    response.set_content(read_below(site.folder, path.substr(1), ""), type_of(path));
  } catch (const Error&) {
    response.status = 404;
    response.set_content("there is no " + path + " on this page\n", "text/plain; charset=utf-8");
  }
}

/// SIGINT and SIGTERM are waited for: by no other thread while this lives.
class Ending {
 public:
  Ending() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  }
  ~Ending() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  Ending(const Ending&) = delete;
  Ending& operator=(const Ending&) = delete;
  void wait() const {
    int which = 0;
    sigwait(&signals_, &which);
  }

 private:
  sigset_t signals_{}, before_{};
};

}  // namespace

void run(const Site& site, std::uint16_t port, const std::function<void(std::uint16_t)>& ready) {
  httplib::Server server;
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  // The library's own choice lets two servers share a port.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.set_default_headers({{"Cache-Control", "no-cache"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Cross-Origin-Resource-Policy", "same-origin"},
                              // Isolated: the page's threads may share memory.
                              {"Cross-Origin-Opener-Policy", "same-origin"},
                              {"Cross-Origin-Embedder-Policy", "require-corp"}});
  server.set_payload_max_length(0);
  server.Get(".*",
             [&](const httplib::Request& request, httplib::Response& response) { respond(site, request, response); });
  const int bound = port ? (server.bind_to_port("127.0.0.1", port) ? port : -1) : server.bind_to_any_port("127.0.0.1");
  if (bound < 0)
    throw Error("port " + std::to_string(port) + " cannot be had: something else listens there, perhaps",
                "give another, or --port 0 for any that is free");
  const Ending ending;  // before the threads, which block the signals, too
  std::thread thread([&] { server.listen_after_bind(); });
  while (!server.is_running()) std::this_thread::yield();
  ready(static_cast<std::uint16_t>(bound));
  ending.wait();
  server.stop();
  thread.join();
}

}  // namespace carom::tools::serve
