#pragma once

namespace emtr {

/// Returns how many threads, at most `wanted`, the system gives to this process now beside those
/// that run, by making them and ending them again. An OpenMP runtime that fails to make a thread
/// ends the process, so a region may ask only for threads that are known to be there. Where the
/// system has too few, half of those that it gave are returned: the stacks of all would leave no
/// memory for the work.
int probe_threads(int wanted);

/// Returns whether a new thread can have its first allocations: where it gets no heap of its own,
/// each is some pages. Asks the system, as the C library may have room left in a heap that it does
/// not share.
bool room_to_begin();

}  // namespace emtr
