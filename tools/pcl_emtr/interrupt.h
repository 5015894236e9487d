#pragma once

namespace cli {

/// While it lives, the first SIGINT or SIGTERM only asks the run to stop, so that the best pose
/// so far can be given; the second ends the process as ever.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool requested() { return number() != 0; }
  static int number();  ///< of the signal that asked, 0 for none
};

/// From here on the process finishes what it began: its files are being put in place.
void ignore_interrupts();

}  // namespace cli
