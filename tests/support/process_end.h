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

/// Does not return for known names. "fork" leaves a child process that keeps all connections open. Windows
/// has neither "fork" nor "closed pipe".
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
