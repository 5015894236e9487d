#pragma once

namespace cli {

/// Turns the first SIGINT or SIGTERM into a request to stop while it lives, so that the run can
/// still write its best pose. A second signal ends the process as usual.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool requested() { return number() != 0; }
  static int number();  ///< the signal that asked to stop, 0 for none
};

/// Ignores SIGINT and SIGTERM from here on, so that the output files are put in place together.
void ignore_interrupts();

}  // namespace cli
