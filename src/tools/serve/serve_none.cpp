// Where the build found no HTTP library.
#include "host/host.h"
#include "serve/serve.h"

namespace carom::tools::serve {

void run(const Site&, std::uint16_t, const std::function<void(std::uint16_t)>&) {
  throw Error("this carom was built without an HTTP library, so it serves no page",
              "install cpp-httplib (Debian: libcpp-httplib-dev) and build again; or serve the folder src/site/dist by "
              "any web server: cd src/site && npm run view");
}

}  // namespace carom::tools::serve
