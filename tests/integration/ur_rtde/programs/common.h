// SPDX-License-Identifier: MIT
#pragma once

// Common code of the programs in this folder. They are typical user programs without Qt and without an
// application object, and use only the headers of the ur_rtde interface.

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

using namespace ur_rtde;
using namespace std::chrono;

inline const std::vector<double> kHome{-1.6007, -1.7271, -2.2030, -0.8080, 1.5951, -0.0310};

inline void require(bool condition, const std::string& what) {
    if (!condition) {
        std::cerr << "failed: " << what << std::endl;
        std::exit(1);
    }
}

inline bool areNear(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::abs(a[i] - b[i]) > tolerance) {
            return false;
        }
    }
    return a.size() == b.size();
}

/// Waits until `read` returns values near `place`. The data connection reports the end of a move later than
/// the control connection.
template <class Read>
bool isNear(Read read, const std::vector<double>& place, double tolerance) {
    for (int i = 0; i < 20'000 && !areNear(read(), place, tolerance); ++i) {
        std::this_thread::sleep_for(milliseconds(1));
    }
    return areNear(read(), place, tolerance);
}
