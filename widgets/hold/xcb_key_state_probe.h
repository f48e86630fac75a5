// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Key-state check on X11. A separate thread queries the pointer buttons and the keymap over a separate
// connection to the display server. A hanging server does not respond, and a terminated server closes the
// connection. In neither case is the GUI thread blocked, but it receives no new results. Key numbers are the
// same as in window events.

#include <array>
#include <atomic>
#include <mutex>
#include <thread>

#include "widgets/hold/key_state_probe.h"

namespace tiller {

/// Threads  A separate thread with normal priority connects, sends queries and waits for replies. The GUI
/// thread receives the results under a lock that is held only while copying.
class XcbKeyStateProbe final : public KeyStateProbe {
public:
    /// Connects to the display of the window in the background.
    XcbKeyStateProbe();
    ~XcbKeyStateProbe() override;
    XcbKeyStateProbe(const XcbKeyStateProbe&) = delete;
    XcbKeyStateProbe& operator=(const XcbKeyStateProbe&) = delete;

    bool isThere() const override { return there_.load(); }
    void want(bool wanted) override;
    void query() override;
    Word leftButton() const override;
    Word key(KeyCode code) const override;
    std::int64_t waitingNs() const override;
    QString description() const override;

    /// Period of the queries [ms].
    static constexpr int kAskMs = 10;

private:
    static constexpr std::size_t kKeys = 256;

    class Link;
    void run();
    void wake();
    void note(std::int64_t askedNs, bool button, const std::array<bool, kKeys>& keys);

    std::atomic<bool> there_{false};
    std::atomic<bool> wanted_{false};
    std::atomic<bool> once_{false};  ///< set by query() for one additional query
    std::atomic<bool> quit_{false};
    std::atomic<std::int64_t> waitingSinceNs_{0};  ///< time of the pending query; 0: none
    int wakeRead_ = -1;
    int wakeWrite_ = -1;

    mutable std::mutex heard_;
    std::int64_t askedNs_ = 0;
    std::int64_t buttonNs_ = 0;
    std::array<std::int64_t, kKeys> keyNs_{};

    std::thread thread_;
};

}  // namespace tiller
