// Drives a fuzz target without libFuzzer, so with any compiler: runs it on each file that is named,
// or that lies in a folder that is named, and on these with bytes changed at random, the
// same every time. replay.cpp takes the place of libFuzzer's main(): see tools/fuzz --smoke.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kLongest = 2000;  // bytes of a changed input

const Bytes* current = nullptr;   // for the handler, which can be given nothing
const char* finding = "finding";  // the file that it writes

/// Keeps the input at which the target ended, and lets the signal have its way.
void keep_input(int signal) {
  if (std::FILE* file = std::fopen(finding, "wb")) {
    std::fwrite(current->data(), 1, current->size(), file);
    std::fclose(file);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

Bytes read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  Bytes bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad() || !file.is_open()) {
    std::fprintf(stderr, "%s: cannot be read\n", path.c_str());
    std::exit(2);
  }
  return bytes;
}

/// Overwrites, removes, inserts or doubles a few bytes; in text a number often stays a number.
void change(Bytes& bytes, std::mt19937& draw) {
  const auto below = [&](std::size_t n) { return draw() % std::max<std::size_t>(n, 1); };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(bytes.size());
    const std::size_t count = std::min(bytes.size() - at, 1 + below(8));
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = from + static_cast<std::ptrdiff_t>(count);
    switch (below(5)) {
      case 0:
        std::generate(from, end, [&] { return static_cast<std::uint8_t>(draw()); });
        break;
      case 1:
        std::generate(from, end, [&] { return static_cast<std::uint8_t>('0' + below(10)); });
        break;
      case 2:
        bytes.erase(from, end);
        break;
      case 3: {
        const Bytes twice(from, end);
        bytes.insert(from, twice.begin(), twice.end());
        break;
      }
      default:
        if (!bytes.empty()) bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1U << below(8)));
    }
  }
  if (bytes.size() > kLongest) bytes.resize(kLongest);
}

void run(const Bytes& bytes) {
  current = &bytes;
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

std::vector<fs::path> files(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) found.push_back(entry);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr,
                 "usage: %s CHANGED FINDING FILE-OR-FOLDER...\n"
                 "CHANGED: inputs made of each by changes; FINDING: file for an input that fails\n",
                 argv[0]);
    return 2;
  }
  const long changed = std::strtol(argv[1], nullptr, 10);
  finding = argv[2];
  for (const int signal : {SIGABRT, SIGILL, SIGTRAP, SIGSEGV, SIGBUS, SIGFPE})
    std::signal(signal, keep_input);
  long runs = 0;
  std::mt19937 draw(1);
  for (int i = 3; i < argc; ++i)
    for (const fs::path& path : files(argv[i])) {
      const Bytes seed = read(path);
      run(seed);
      for (long made = 0; made < changed; ++made) {
        Bytes bytes = seed;
        change(bytes, draw);
        run(bytes);
      }
      runs += 1 + changed;
    }
  std::printf("%ld executions\n", runs);
  return 0;
}
