// SPDX-License-Identifier: MIT
#pragma once

// Software version of the controller, as reported by RTDE and the dashboard.

#include <compare>
#include <cstdint>
#include <ostream>

namespace tiller {

struct SoftwareVersion {
    std::uint32_t major = 0;
    std::uint32_t minor = 0;
    std::uint32_t bugfix = 0;
    std::uint32_t build = 0;

    friend auto operator<=>(const SoftwareVersion&, const SoftwareVersion&) = default;

    /// Writes the version, e.g. "5.21.1.0".
    friend std::ostream& operator<<(std::ostream& out, const SoftwareVersion& v) {
        return out << v.major << '.' << v.minor << '.' << v.bugfix << '.' << v.build;
    }

    bool isCb3() const { return major > 0 && major < 5; }  ///< Software 3.x.
    bool isPolyScopeX() const { return major >= 10; }      ///< Software 10.x.
    /// Control period [s]: 8 ms on CB3, 2 ms on later controllers.
    double controlPeriod() const { return isCb3() ? 0.008 : 0.002; }
    /// Maximum RTDE rate [Hz].
    double maxFrequency() const { return isCb3() ? 125.0 : 500.0; }
};

}  // namespace tiller
