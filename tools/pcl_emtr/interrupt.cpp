#include "interrupt.h"

#include <signal.h>

#include <array>
#include <cstddef>

namespace cli {
namespace {

constexpr std::array<int, 2> kSignals = {SIGINT, SIGTERM};
std::array<struct sigaction, kSignals.size()> previous;
volatile sig_atomic_t request = 0;

void note(int number) { request = number; }

}  // namespace

Interrupt::Interrupt(Use use) {
  struct sigaction action = {};
  action.sa_handler = note;
  sigemptyset(&action.sa_mask);
  if (use == kStopsRun) action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &previous[i]);
    // A shell starts background jobs with SIGINT ignored; it stays ignored.
    if (previous[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
  }
}

Interrupt::~Interrupt() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &previous[i], nullptr);
}

int Interrupt::number() { return request; }

}  // namespace cli
