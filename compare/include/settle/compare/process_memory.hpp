/// \file
/// Memory of processes and of the machine, as /proc tells it.
#pragma once

#include <sys/types.h>

namespace settle::compare {

/// Private resident memory [B] of a process, its children, and theirs: what is given back when they are killed. Files
/// that are mapped and memory that is shared do not count. 0 for a process that is not there.
double memory_of(pid_t process);

/// Largest resident set so far [B] of a process, its children, and theirs. 0 for a process that is not there.
double peak_memory_of(pid_t process);

/// Memory of the machine, or what the control group of this process or its job in Slurm may have where that is less
/// [B].
double machine_memory();

} // namespace settle::compare
