// SPDX-License-Identifier: MIT
#pragma once

// Additional fields requested by parts of the window. They use a separate connection, so that changing the
// fields never interrupts the stream for motion.

#include <QSet>
#include <QStringList>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/clock.h"
#include "robot/receive/receiver.h"
#include "robot/station/executor/serial_executor.h"
#include "robot/station/link/sample_batch.h"

namespace tiller {

/// Creates a receiver for a connection in addition to the link, without thread priority. The receiver is not
/// started.
std::shared_ptr<receive::Receiver> extraReceiver(const QString& host, std::uint16_t port, const Clock& clock,
                                                 const std::vector<std::string>& fields);

/// Threads  GUI; the thread of the receiver has normal priority
class ExtraFieldStream {
public:
    /// cleanup  joins the threads of receivers that are no longer needed
    ExtraFieldStream(const Clock& clock, SerialExecutor& cleanup) : clock_(clock), cleanup_(cleanup) {}

    /// Receives exactly these fields of this robot from now on. May be empty.
    void follow(const QString& host, std::uint16_t port, const QStringList& fields);
    void end();
    /// Samples since the last call, stored in `into`.
    SampleBatch drain(std::vector<receive::Sample>& into);
    /// The receiver of the additional fields; null if no fields are requested.
    std::shared_ptr<const receive::Receiver> receiver() const { return receiver_; }
    /// The requested fields that the robot does not have.
    QSet<QString> absent() const;

private:
    const Clock& clock_;
    SerialExecutor& cleanup_;
    std::shared_ptr<receive::Receiver> receiver_;
    receive::Subscription stream_;
    std::uint64_t lost_ = 0;
};

}  // namespace tiller
