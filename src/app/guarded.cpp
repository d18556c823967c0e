#include <cstdio>
#include <exception>
#include <filesystem>

#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/reason.hpp"

namespace tdbd::app {

int guarded(const std::function<int()>& body) {
  try {
    return body();
  } catch (const InputError& e) {
    std::fprintf(stderr, "tdbd: %s\n", e.what());
    return 2;
  } catch (const std::filesystem::filesystem_error& e) {
    std::fprintf(stderr, "tdbd: %s: %s\n", e.path1().c_str(), e.code().message().c_str());
    return is_shortage(e.code()) ? 1 : 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "tdbd: %s\n", reason_of(e));
    return 1;
  }
}

}  // namespace tdbd::app
