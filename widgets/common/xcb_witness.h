// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The second witness on X11: a connection of its own to the display server, on which a thread of its own asks
// for the pointer's buttons and the map of keys. A server that hangs does not answer, one that is gone closes
// the connection; in both cases nobody waits for it here, and the window hears that nothing was said. The
// numbers of the keys are those of the window's events.

#include <array>
#include <atomic>
#include <mutex>
#include <thread>

#include "widgets/common/hold_witness.h"

namespace tiller {

/// Threads  one of its own, normal priority: connects, asks, waits for answers. What it heard crosses to the
///          GUI thread under a lock that is held for some copies only.
class XcbWitness final : public HoldWitness {
public:
    /// Connects in the background, to the display the window is on.
    XcbWitness();
    ~XcbWitness() override;
    XcbWitness(const XcbWitness&) = delete;
    XcbWitness& operator=(const XcbWitness&) = delete;

    bool isThere() const override { return there_.load(); }
    void want(bool wanted) override;
    Word leftButton() const override;
    Word key(KeyCode code) const override;
    std::int64_t waitingNs() const override;
    QString description() const override;

    /// Between two questions.
    static constexpr int kAskMs = 10;

private:
    static constexpr std::size_t kKeys = 256;

    class Link;
    void run();
    void wake();
    void note(std::int64_t askedNs, bool button, const std::array<bool, kKeys>& keys);

    std::atomic<bool> there_{false};
    std::atomic<bool> wanted_{false};
    std::atomic<bool> quit_{false};
    std::atomic<std::int64_t> waitingSinceNs_{0};  ///< 0: no question waits
    int wakeRead_ = -1;
    int wakeWrite_ = -1;

    mutable std::mutex heard_;
    std::int64_t askedNs_ = 0;
    std::int64_t buttonNs_ = 0;
    std::array<std::int64_t, kKeys> keyNs_{};

    std::thread thread_;
};

}  // namespace tiller
