#include <dlfcn.h>

#include <new>
#include <string>

#include "failure.h"
#include "modules/pcl_module.h"

namespace cli {
namespace {

[[noreturn]] void fail(const std::string& why) {
  const auto says = [&](const char* words) { return why.find(words) != std::string::npos; };
  if (says("failed to map segment") || says("cannot allocate memory")) throw std::bad_alloc();
  throw Failure(kInputOutput,
                "the reader and writer of PCD and PLY files, which is installed with pcl_emtr, "
                "cannot be loaded: " +
                    why);
}

const PclModule& load() {
  // Lazily, since few of the functions of those libraries are ever called.
  void* library = dlopen("pcl_emtr_pcl.so", RTLD_LAZY | RTLD_LOCAL);
  const void* symbol = library ? dlsym(library, "emtr_pcl_module_1") : nullptr;
  if (!symbol) fail(dlerror());
  return *static_cast<const PclModule*>(symbol);
}

}  // namespace

const PclModule& pcl_module() {
  static const PclModule& module = load();
  return module;
}

}  // namespace cli
