// SPDX-License-Identifier: MIT
#include "robot/realtime/cpu_latency.h"

#include <mutex>

#ifdef __linux__
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#endif

namespace tiller::realtime {

#ifdef __linux__

namespace {

constexpr const char* kDevice = "/dev/cpu_dma_latency";

/// The request shared by all objects of the process.
struct LatencyRequest {
    std::mutex mutex;
    int holders = 0;
    int file = -1;
};

LatencyRequest& latencyRequest() {
    static LatencyRequest request;
    return request;
}

}  // namespace

CpuLatency::CpuLatency() {
    LatencyRequest& request = latencyRequest();
    const std::lock_guard lock(request.mutex);
    if (request.holders++ == 0) {
        request.file = ::open(kDevice, O_WRONLY | O_CLOEXEC);
        const std::int32_t microseconds = 0;
        if (request.file >= 0 &&
            ::write(request.file, &microseconds, sizeof microseconds) != sizeof microseconds) {
            ::close(request.file);
            request.file = -1;
        }
    }
    granted_ = request.file >= 0;
}

CpuLatency::~CpuLatency() {
    LatencyRequest& request = latencyRequest();
    const std::lock_guard lock(request.mutex);
    if (--request.holders == 0 && request.file >= 0) {
        ::close(request.file);
        request.file = -1;
    }
}

QString CpuLatency::advice() {
    if (::access(kDevice, W_OK) == 0) {
        return {};
    }
    if (errno == ENOENT) {
        return QStringLiteral(
                   "This system has no %1 (for example, in a container): wake-up times depend on the sleep "
                   "states of its CPUs.")
            .arg(QLatin1String(kDevice));
    }
    return QStringLiteral(
        "To permit fast wake-ups, create the file /etc/udev/rules.d/99-tiller.rules with the line "
        "KERNEL==\"cpu_dma_latency\", GROUP=\"realtime\", MODE=\"0660\", add this user to the group "
        "\"realtime\", and restart.");
}

#else

// On other systems, the power plan controls the sleep states.
CpuLatency::CpuLatency() : granted_(false) {}
CpuLatency::~CpuLatency() = default;

QString CpuLatency::advice() {
    return QStringLiteral(
        "This system does not support requests for fast wake-ups; select its high-performance power plan.");
}

#endif

}  // namespace tiller::realtime
