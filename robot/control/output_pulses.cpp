// SPDX-License-Identifier: MIT
#include "robot/control/output_pulses.h"

#include <array>

#include "robot/control/detail/argument_check.h"
#include "robot/control/detail/controller_private.h"

namespace tiller::control {

namespace {

Error checkPulse(const QString& context, std::uint32_t mask) {
    if (mask == 0 || mask >> kPulseOutputs != 0) {
        return {ErrorCode::InvalidArgument, context,
                QStringLiteral("mask: use only digital outputs 0 to %1").arg(kPulseOutputs - 1)};
    }
    return {};
}

void note(Controller::Private& d, std::uint32_t mask, std::int64_t endNs) {
    for (std::size_t i = 0; i < d.pulseEndsNs.size(); ++i) {
        if ((mask >> i & 1U) != 0) {
            d.pulseEndsNs[i].store(endNs);
        }
    }
}

}  // namespace

Result<void> OutputPulses::begin(std::uint32_t mask, std::uint32_t values, std::chrono::milliseconds duration,
                                 Holding holding, const Deadline& deadline) {
    constexpr auto kContext = "pulse digital outputs";
    const QString context = QString::fromLatin1(kContext);
    if (const Error error = checkPulse(context, mask); error.code != ErrorCode::None) {
        return error;
    }
    const double seconds = std::chrono::duration<double>(duration).count();
    if (const Error error =
            ArgumentCheck(kContext)
                .positive("duration", seconds, std::chrono::duration<double>(kMaxPulse).count(), "s", "ms")
                .error();
        error.code != ErrorCode::None) {
        return error;
    }
    const std::array<double, 3> numbers{seconds, static_cast<double>(values & mask),
                                        holding == Holding::Held ? 1.0 : 0.0};
    auto& d = ControllerAccess::of(*controller_);
    auto begun = noAnswer(d.requests.request(RequestKind::BeginPulses, static_cast<std::int32_t>(mask),
                                             numbers, context, deadline));
    if (begun) {
        note(d, mask, d.now() + std::chrono::nanoseconds(duration).count());
    }
    return begun;
}

Result<void> OutputPulses::end(std::uint32_t mask, const Deadline& deadline) {
    const QString context = QStringLiteral("end pulses of digital outputs");
    if (const Error error = checkPulse(context, mask); error.code != ErrorCode::None) {
        return error;
    }
    auto& d = ControllerAccess::of(*controller_);
    auto ended = noAnswer(
        d.requests.request(RequestKind::EndPulses, static_cast<std::int32_t>(mask), {}, context, deadline));
    if (ended) {
        note(d, mask, 0);
    }
    return ended;
}

}  // namespace tiller::control
