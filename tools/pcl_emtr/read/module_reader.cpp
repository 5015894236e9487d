#include "read/module_reader.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <exception>
#include <mutex>
#include <new>
#include <vector>

#include "failure.h"
#include "modules/module.h"
#include "read/blob.h"

namespace cli {
namespace {

struct Module {
  const char* file;
  const char* option;   // of CMake
  const char* package;  // of Debian, where it has one
};

constexpr Module kLas = {"pcl_emtr_las.so", "EMTR_WITH_LASZIP", "liblaszip-dev"};
constexpr Module kE57 = {"pcl_emtr_e57.so", "EMTR_WITH_E57", "libE57Format"};

struct Sink : emtr_module_sink {
  explicit Sink(CloudFile& cloud_file) : emtr_module_sink{}, cloud(cloud_file) {
    begin = [](emtr_module_sink* sink, const char* const* names, std::size_t fields,
               std::uint64_t points) {
      return guarded(sink, [&](CloudFile& file) {
        std::vector<std::string> all = {"x", "y", "z"};
        all.insert(all.end(), names, names + fields);
        file.blob = doubles_blob(all);
        reserve_points(file.blob, points);
      });
    };
    add = [](emtr_module_sink* sink, const double* values) {
      return guarded(sink, [&](CloudFile& file) { add_point(file.blob, values); });
    };
    note = [](emtr_module_sink* sink, const char* text) {
      guarded(sink, [&](CloudFile& file) { file.add_note(text); });
    };
  }

  /// No exception may pass through the module, whose language is not known.
  template <class Action>
  static int guarded(emtr_module_sink* sink, const Action& action) {
    auto& self = *static_cast<Sink*>(sink);
    try {
      action(self.cloud);
      return 0;
    } catch (const std::exception&) {
      self.full = true;
      return 1;
    }
  }

  CloudFile& cloud;
  bool full = false;
};

void read(CloudFile& cloud, const Module& module) {
  void* library = dlopen(module.file, RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    const std::string why = dlerror();
    const bool missing = why.find("No such file") != why.npos && why.find(module.file) == 0;
    throw FileFailure(cloud.path,
                      missing ? std::string("this pcl_emtr was built without a reader for ") +
                                    cloud.format->extension + " files; build it with -D" +
                                    module.option + "=ON, which needs " + module.package
                              : "its reader cannot be loaded: " + why);
  }
  auto* read_file = reinterpret_cast<emtr_module_read*>(dlsym(library, "emtr_module_read_1"));
  if (!read_file)
    throw FileFailure(cloud.path,
                      std::string(module.file) + " is of another version than pcl_emtr");
  Sink sink(cloud);
  std::array<char, 1000> error{};
  const int failed = [&] {
    // Neither library promises that threads may read files at a time: that of E57 sets up and ends
    // its XML parser, which the whole process shares, for each file.
    static std::mutex reading;
    const std::lock_guard<std::mutex> lock(reading);
    return read_file(cloud.place.c_str(), &sink, error.data(), error.size());
  }();
  if (sink.full) throw std::bad_alloc();
  if (failed) throw FileFailure(cloud.path, error.data());
  if (cloud.blob.fields.empty()) throw FileFailure(cloud.path, "holds no points");
  finish_blob(cloud.blob, cloud.path, "points");
}

}  // namespace

void read_las(CloudFile& cloud) { read(cloud, kLas); }

void read_e57(CloudFile& cloud) { read(cloud, kE57); }

}  // namespace cli
