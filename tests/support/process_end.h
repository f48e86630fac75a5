// SPDX-License-Identifier: MIT
#pragma once

// The ways in which a program that moves the arm can end without an external signal. Uses only the standard
// library, because the programs for ur_rtde include this header.

#ifndef _WIN32
#include <unistd.h>
#endif

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

namespace tiller::test {

/// Ends the process as named, with two exceptions: "fork" returns and leaves a child process that keeps all
/// connections open, and "closed pipe" returns if SIGPIPE is ignored. Windows has neither.
inline void endProcess(const std::string& how) {
    if (how == "exception") {
        throw std::runtime_error("exception requested by the test");
    }
    if (how == "exit") {
        std::exit(0);
    }
    if (how == "abort") {
        std::abort();
    }
    if (how == "_exit") {
        std::_Exit(0);
    }
#ifndef _WIN32
    if (how == "closed pipe") {
        int ends[2];
        if (::pipe(ends) == 0 && ::close(ends[0]) == 0) {
            (void)!::write(ends[1], "x", 1);
        }
    }
    if (how == "fork") {
        constexpr int kSeconds = 5;
        if (::fork() == 0) {
            ::sleep(kSeconds);
            ::_exit(0);
        }
        std::cout << "forked" << std::endl;
    }
#endif
}

}  // namespace tiller::test
