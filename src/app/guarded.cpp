#include <cstdio>
#include <exception>
#include <new>

#include "app/commands.hpp"
#include "core/error.hpp"

namespace tdbd::app {

int guarded(const std::function<int()>& body) {
  try {
    return body();
  } catch (const InputError& e) {
    std::fprintf(stderr, "tdbd: %s\n", e.what());
    return 2;
  } catch (const std::bad_alloc&) {
    std::fputs("tdbd: out of memory\n", stderr);
    return 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "tdbd: %s\n", e.what());
    return 1;
  }
}

}  // namespace tdbd::app
