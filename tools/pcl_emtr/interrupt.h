#pragma once

namespace cli {

/// Turns SIGINT and SIGTERM into a request to stop while it lives.
class Interrupt {
 public:
  enum Use {
    kStopsRun,  ///< so that the run can still write its best pose; a second signal ends the process
    kEndsCalls,  ///< so that waiting for a pipe ends with EINTR, and no file is left half written
  };
  explicit Interrupt(Use use = kStopsRun);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static bool requested() { return number() != 0; }
  static int number();  ///< the signal that asked to stop, 0 for none
};

}  // namespace cli
