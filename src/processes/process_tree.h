// SPDX-License-Identifier: MIT
//
// The processes below a program: it may start others, and these may leave its process group or
// outlive it. While a program runs, our process adopts what loses its parent below it
// (PR_SET_CHILD_SUBREAPER), so that all of them stay our descendants and can be found in /proc.
#pragma once

#include <sys/types.h>

#include <functional>

namespace edgecase {

// Calls `start`, which starts a program in a process group of its own and stores its number;
// returns what that returns, 0 for success as posix_spawn. What the program starts is ours from
// here on.
int start_program(const std::function<int(pid_t&)>& start, pid_t& program);

// Kills the program's group, and reaps the program; kills those of its descendants that do not end
// with it, within two seconds. Returns its status as waitpid gives it. What lost its parent cannot
// be told from what other programs lost: it is killed with the last of the programs that
// start_program() started.
int end_program(pid_t program);

}  // namespace edgecase
