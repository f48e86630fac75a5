// SPDX-License-Identifier: MIT
// Questions and settings: one at a time, through the packages that go to the robot anyway.

#include <algorithm>
#include <thread>

#include "robot/control/detail/controller_private.h"

namespace tiller::control {

using std::chrono::milliseconds;

namespace {

Error overdue(const Deadline& deadline, const QString& context) {
    return {deadline.isCancelled() ? ErrorCode::Cancelled : ErrorCode::Timeout, context,
            QStringLiteral("the control program does not answer")};
}

}  // namespace

Result<void> Controller::Private::needs(const SoftwareVersion& eSeries, const SoftwareVersion& cb3,
                                        const QString& context) const {
    const SoftwareVersion has = versionNow();
    const SoftwareVersion& least = has.isCb3() ? cb3 : eSeries;
    if (least.major > 0 && has >= least) {
        return {};
    }
    const QString since = least.major > 0
                              ? QStringLiteral("it needs %1.%2 or newer").arg(least.major).arg(least.minor)
                              : QStringLiteral("this series does not have it");
    return Error{
        ErrorCode::VersionUnsupported, context,
        QStringLiteral("software %1.%2.%3: %4").arg(has.major).arg(has.minor).arg(has.bugfix).arg(since)};
}

Result<void> Controller::Private::knows(const char* name, const QString& context) const {
    const SoftwareVersion has = versionNow();
    const std::lock_guard lock(arm);
    if (!refused.contains(QLatin1String(name))) {
        return {};
    }
    return Error{ErrorCode::VersionUnsupported, context,
                 QStringLiteral("software %1.%2.%3 has no %4")
                     .arg(has.major)
                     .arg(has.minor)
                     .arg(has.bugfix)
                     .arg(QLatin1String(name))};
}

Result<Answer> Controller::Private::exchange(const Request& request, const QString& context,
                                             const Deadline& deadline) {
    const std::int32_t number = loop.ask(request);
    for (;;) {
        const Answer answer = loop.answer();
        if (answer.number == number && loop.isInControl()) {
            switch (answer.outcome) {
                case Outcome::Done:
                    return answer;
                case Outcome::NoSolution:
                    return Error{ErrorCode::NoSolution, context, {}};
                case Outcome::NotPermitted:
                    return Error{ErrorCode::Stopped, context, QStringLiteral("a stop came first")};
                case Outcome::Unknown:
                    break;
            }
            return Error{ErrorCode::VersionUnsupported, context,
                         QStringLiteral("the control program does not know this request")};
        }
        if (!loop.isInControl()) {
            loop.withdraw();
            return Error{running ? ErrorCode::NotInControl : ErrorCode::LinkLost, context, {}};
        }
        if (deadline.hasExpired()) {
            loop.withdraw();  // it must not be served when nobody expects it any more
            return overdue(deadline, context);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
}

Result<Answer> Controller::Private::request(RequestKind kind, std::int32_t whole,
                                            std::span<const double> numbers, const QString& context,
                                            const Deadline& deadline) {
    if (!loop.isInControl()) {
        return Error{ErrorCode::NotInControl, context, {}};
    }
    std::unique_lock lock(requesting, std::defer_lock);
    while (!lock.try_lock_for(std::max(deadline.nextPoll(), milliseconds(1)))) {
        if (deadline.hasExpired()) {
            return overdue(deadline, context);
        }
    }
    constexpr std::size_t kInOnePackage = 6;
    Request asked{0, kind, whole, {}};
    std::copy_n(numbers.begin(), std::min(numbers.size(), kInOnePackage), asked.numbers.begin());
    for (std::size_t page = 0; page < stored.size() && numbers.size() > (page + 1) * kInOnePackage; ++page) {
        const auto rest = numbers.subspan((page + 1) * kInOnePackage);
        std::array<double, kInOnePackage> kept{};
        std::copy_n(rest.begin(), std::min(rest.size(), kInOnePackage), kept.begin());
        if (stored[page] == kept) {
            continue;
        }
        stored[page].reset();
        const auto place = static_cast<std::int32_t>(page * kInOnePackage);
        if (auto answer = exchange({0, RequestKind::Store, place, kept}, context, deadline); !answer) {
            return answer;
        }
        stored[page] = kept;
    }
    return exchange(asked, context, deadline);
}

}  // namespace tiller::control
