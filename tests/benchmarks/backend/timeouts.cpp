// SPDX-License-Identifier: MIT
// Accuracy of deadlines and cancels with a robot that does not respond, and the time until connections and
// objects are closed and destroyed.
#include <QTextStream>
#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include "robot/dashboard/service_worker.h"
#include "robot/ur_rtde/dashboard_client.h"
#include "robot/ur_rtde/rtde_control_interface.h"
#include "robot/ur_rtde/rtde_io_interface.h"
#include "robot/ur_rtde/rtde_receive_interface.h"
#include "tests/benchmarks/backend/report.h"
#include "tests/integration/control/blocking_calls.h"

namespace tiller::benchmark {

namespace {

using namespace std::chrono_literals;
using SteadyTime = std::chrono::steady_clock;

constexpr double kDeadlineLimitMs = 60;
constexpr double kCancelLimitMs = 20;
constexpr double kEndLimitMs = 250;

double msSince(SteadyTime::time_point begin) {
    return std::chrono::duration<double, std::milli>(SteadyTime::now() - begin).count();
}

struct Worst {
    double ms = 0;
    QString of;
    void add(double late, const char* name) {
        if (late > ms) {
            ms = late;
            of = QString::fromLatin1(name);
        }
    }
    QString named(const QString& what) const { return QStringLiteral("%1, worst: %2").arg(what, of); }
};

void deadlines(Report& report) {
    Worst late;
    Worst slow;
    int wrong = 0;
    const auto calls = test::blockingCalls();
    for (const test::BlockingCall& call : calls) {
        {
            test::MuteWorld world;
            wrong += world.begin().ok() ? 0 : 1;
            constexpr auto kTime = 100ms;
            const auto begin = SteadyTime::now();
            const Error error = call.run(world, Deadline::after(kTime));
            late.add(msSince(begin) - 100, call.name);
            wrong += error.code == ErrorCode::Timeout ? 0 : 1;
        }
        test::MuteWorld world;
        wrong += world.begin().ok() ? 0 : 1;
        const CancelToken token;
        SteadyTime::time_point cancelled;
        std::thread impatient([&] {
            std::this_thread::sleep_for(100ms);
            cancelled = SteadyTime::now();
            token.cancel();
        });
        const Error error = call.run(world, Deadline::never(token));
        const auto end = SteadyTime::now();
        impatient.join();
        slow.add(std::chrono::duration<double, std::milli>(end - cancelled).count(), call.name);
        wrong += error.code == ErrorCode::Cancelled ? 0 : 1;
    }
    report.add(QStringLiteral("calls, each with a deadline and with a cancel"),
               static_cast<double>(calls.size()), QString());
    report.add(QStringLiteral("of them ended otherwise"), wrong, QString(), 0.0);
    report.add(late.named(QStringLiteral("after the deadline")), late.ms, QStringLiteral("ms"),
               kDeadlineLimitMs);
    report.add(slow.named(QStringLiteral("after the cancel")), slow.ms, QStringLiteral("ms"), kCancelLimitMs);
}

void ends(Report& report) {
    const auto measure = [&](const char* what, const std::function<void()>& end) {
        const auto begin = SteadyTime::now();
        end();
        report.add(QString::fromLatin1(what), msSince(begin), QStringLiteral("ms"), kEndLimitMs);
    };
    {
        test::MuteWorld world;
        if (world.begin().ok()) {
            measure("Controller::release", [&] { world.controller().release(); });
            measure("~Controller", [&] { world.cell.controller.reset(); });
        }
    }
    {
        test::MuteWorld world;
        receive::ReceiverOptions options;
        options.host = world.host();
        options.port = static_cast<std::uint16_t>(world.mute.port());
        auto receiver = std::make_unique<receive::Receiver>(options);
        receiver->start().value();
        std::this_thread::sleep_for(50ms);
        measure("~Receiver while it shakes hands", [&] { receiver.reset(); });
        script::PrimaryClientOptions listening;
        listening.host = world.host();
        listening.port = world.mute.port();
        auto primary = std::make_unique<script::PrimaryClient>(listening);
        primary->start();
        std::this_thread::sleep_for(50ms);
        measure("~PrimaryClient", [&] { primary.reset(); });
        auto worker = std::make_unique<dashboard::ServiceWorker>(
            dashboard::ServiceAddress{world.host(), world.greets.port(), world.mute.port()});
        worker->start();
        QObject context;
        worker->post([](auto& service, auto& deadline) { return service.look(deadline); }, &context,
                     [](const auto&) {});
        std::this_thread::sleep_for(50ms);
        measure("~ServiceWorker while it asks", [&] { worker.reset(); });
    }
    simulator::SimulatorOptions options;
    options.listenAddress = QStringLiteral("127.0.8.101");
    options.poweredOn = true;
    options.fastTransitions = true;
    simulator::Simulator robot(options);
    if (const auto started = robot.start(); !started) {
        report.cannot(QStringLiteral("ends of the ur_rtde interface"), started.error().toString());
        return;
    }
    const std::string host = options.listenAddress.toStdString();
    auto control = std::make_unique<ur_rtde::RTDEControlInterface>(host);
    auto receive = std::make_unique<ur_rtde::RTDEReceiveInterface>(host);
    auto io = std::make_unique<ur_rtde::RTDEIOInterface>(host);
    ur_rtde::DashboardClient dashboard(host);
    dashboard.connect();
    robot.silence(true);
    std::this_thread::sleep_for(50ms);
    measure("RTDEControlInterface::disconnect", [&] { control->disconnect(); });
    measure("~RTDEControlInterface", [&] { control.reset(); });
    measure("RTDEReceiveInterface::disconnect", [&] { receive->disconnect(); });
    measure("~RTDEReceiveInterface", [&] { receive.reset(); });
    measure("RTDEIOInterface::disconnect", [&] { io->disconnect(); });
    measure("~RTDEIOInterface", [&] { io.reset(); });
    measure("DashboardClient::disconnect", [&] { dashboard.disconnect(); });
    robot.stop();
}

}  // namespace

void measureTimeout(Report& report) {
    report.begin(QStringLiteral("a peer that says nothing any more"));
    QTextStream(stderr) << "deadlines and cancels...\n";
    deadlines(report);
    ends(report);
}

}  // namespace tiller::benchmark
