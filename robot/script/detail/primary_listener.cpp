// SPDX-License-Identifier: MIT
#include "robot/script/detail/primary_listener.h"

#include <span>

namespace tiller::script {

using native_socket::Status;

native_socket::Transfer sendStopProgram(native_socket::Descriptor descriptor) {
    return native_socket::send(
        descriptor, {reinterpret_cast<const std::uint8_t*>(kStopProgram.data()), kStopProgram.size()});
}

void ListenerThread::end() {
    if (!thread_.joinable()) {
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        cancel.cancel();
    }
    changed_.notify_all();
    thread_.join();
}

Status PrimaryReader::read(native_socket::Descriptor descriptor, std::chrono::milliseconds atMost,
                           const Clock& clock) {
    lastBytes_ = 0;
    if (!heardNs_) {
        heardNs_ = clock.nowNs();
    }
    if (!native_socket::waitReadable(descriptor, atMost)) {
        const std::chrono::nanoseconds silent(clock.nowNs() - *heardNs_);
        return silent > kPrimaryTimeout ? Status::Failed : Status::WouldBlock;
    }
    const auto got = native_socket::receive(descriptor, bytes_);
    if (got.status == Status::Ok) {
        heardNs_ = clock.nowNs();
        lastBytes_ = got.bytes;
        understands_ = parser_.feed(std::span(bytes_).first(got.bytes), clock.nowNs());
    }
    return got.status;
}

Error PrimaryReader::notUnderstood(const QString& context) {
    return {ErrorCode::ProtocolError, context, QStringLiteral("an invalid packet length")};
}

}  // namespace tiller::script
