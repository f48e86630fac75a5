// SPDX-License-Identifier: MIT

// Checks of the RTDE connection: protocol, software, registers, modes, data rate.

#include <QStringList>
#include <QTcpSocket>
#include <algorithm>

#include "robot/doctor/detail/examiner.h"
#include "robot/realtime/cpu_latency.h"
#include "robot/receive/receiver.h"
#include "robot/receive/robot_state.h"
#include "robot/rtde/connection.h"
#include "robot/rtde/fields.h"
#include "robot/script/tcp_socket.h"

namespace tiller::doctor {
namespace {

constexpr int kHandshakeMs = 2500;
constexpr int kProbeMs = 1000;
constexpr int kListenMs = 6000;
/// Duration of the data rate measurement, in controller time [s].
constexpr double kLookSeconds = 0.5;
/// Below this fraction of the expected packets, the data rate is not sufficient for control.
constexpr double kMinShare = 0.9;
/// Number of registers used by control.script, from the start of a range.
constexpr int kIntRegisters = 11;
constexpr int kDoubleRegisters = 18;

std::vector<std::string> registersFrom(int first) {
    std::vector<std::string> names;
    for (int i = 0; i < kIntRegisters; ++i) {
        names.push_back(rtde::intRegisterName(rtde::Direction::Input, first + i));
    }
    for (int i = 0; i < kDoubleRegisters; ++i) {
        names.push_back(rtde::doubleRegisterName(rtde::Direction::Input, first + i));
    }
    return names;
}

/// True if there is any response to the first RTDE request. Any bytes count, because the text of another
/// protocol can look like the start of a package that is never completed.
bool respondsWithData(const QString& host, int port, const Deadline& deadline) {
    auto socket = script::openTcpSocket(host, port, deadline);
    if (!socket) {
        return false;
    }
    static constexpr char kAskProtocol[] = {0, 5, 'V', 0, 2};
    (*socket)->write(kAskProtocol, sizeof kAskProtocol);
    (*socket)->flush();
    while (!deadline.hasExpired() && (*socket)->state() == QAbstractSocket::ConnectedState) {
        if ((*socket)->waitForReadyRead(static_cast<int>(deadline.nextPoll().count()))) {
            return true;
        }
    }
    return (*socket)->bytesAvailable() > 0;
}

QString joined(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names) {
        list << QString::fromStdString(name);
    }
    return list.size() > 3 ? DoctorText::tr("%1 and %2 more").arg(list.first()).arg(list.size() - 1)
                           : list.join(QStringLiteral(", "));
}

void judgeSoftware(Examiner& examiner, const SoftwareVersion& version) {
    const QString text = QStringLiteral("%1.%2.%3").arg(version.major).arg(version.minor).arg(version.bugfix);
    const SoftwareVersion least = version.isCb3() ? SoftwareVersion{3, 4, 0, 0} : SoftwareVersion{5, 0, 0, 0};
    const SoftwareVersion wanted =
        version.isCb3() ? SoftwareVersion{3, 9, 0, 0} : SoftwareVersion{5, 3, 0, 0};
    if (version < least) {
        examiner.found(
            Condition::Software, Verdict::Bad, QStringLiteral("software.unsupported"), text,
            DoctorText::tr("The robot's software is too old. Update the software to %1.%2 or newer.")
                .arg(wanted.major)
                .arg(wanted.minor));
    } else if (version < wanted) {
        examiner.found(Condition::Software, Verdict::Attention, QStringLiteral("software.old"), text,
                       DoctorText::tr("Some values and the control registers are missing. Update the robot's "
                                      "software to %1.%2 or newer.")
                           .arg(wanted.major)
                           .arg(wanted.minor));
    } else {
        examiner.good(Condition::Software, text);
    }
}

void judgeModes(Examiner& examiner, RobotMode mode, SafetyMode safety) {
    if (allowsMotion(safety)) {
        examiner.good(Condition::Safety, safetyModeName(safety));
    } else {
        examiner.found(Condition::Safety, Verdict::Bad, QStringLiteral("safety.stopped"),
                       safetyModeName(safety),
                       DoctorText::tr("Inspect the arm and remove the cause. Then press “Recover…” in the "
                                      "Tiller header, or use the teach pendant."));
    }
    if (mode == RobotMode::Running) {
        examiner.good(Condition::Power, robotModeName(mode));
    } else {
        examiner.found(Condition::Power, Verdict::Attention, QStringLiteral("power.not-running"),
                       robotModeName(mode),
                       DoctorText::tr("Power on the arm and release the brakes, with the button in the "
                                      "Tiller header or on the teach pendant."));
    }
}

}  // namespace

void examineRegisters(Examiner& examiner) {
    if (!examiner.isGood(Condition::RtdePort)) {
        return;
    }
    rtde::ConnectionOptions options;
    options.host = examiner.address;
    options.port = static_cast<std::uint16_t>(examiner.patient.ports.rtde);
    options.request.outputs = {"timestamp"};
    options.request.start = false;
    options.request.inputs = {{registersFrom(rtde::kFirstUpperRegister), false}, {registersFrom(0), false}};
    const auto opened = rtde::Connection::open(options, examiner.within(kHandshakeMs));
    if (!opened) {
        const ErrorCode code = opened.error().code;
        const bool mute =
            code == ErrorCode::Timeout &&
            !respondsWithData(examiner.address, examiner.patient.ports.rtde, examiner.within(kProbeMs));
        examiner.found(
            Condition::Protocol, Verdict::Bad,
            mute ? QStringLiteral("rtde.mute") : QStringLiteral("rtde.not-rtde"),
            mute
                ? DoctorText::tr("the RTDE port accepts connections but does not respond")
                : DoctorText::tr("the service on port %1 does not use RTDE").arg(examiner.patient.ports.rtde),
            mute ? DoctorText::tr("Too many RTDE clients are connected, or the controller has stopped "
                                  "responding. Close other programs, then restart the controller.")
                 : DoctorText::tr("Check the address. The address may belong to another device, or another "
                                  "program may be using the port."));
        return;
    }
    const rtde::Connection& connection = **opened;
    examiner.good(Condition::Protocol,
                  DoctorText::tr("protocol version %1").arg(static_cast<int>(connection.protocol())));
    examiner.version = connection.version();
    judgeSoftware(examiner, *examiner.version);

    const auto& inUse = connection.session().inUse();
    const auto& recipes = connection.inputs();
    if (inUse.size() < 2 || recipes.size() < 2) {
        return;
    }
    if (!inUse[0].empty()) {
        examiner.found(
            Condition::UpperRegisters, Verdict::Bad, QStringLiteral("registers.upper.taken"),
            DoctorText::tr("another program uses %1").arg(joined(inUse[0])),
            DoctorText::tr(
                "Close the other program that controls this robot (another Tiller window, ROS, ur_rtde)."));
    } else if (!recipes[0].isValid()) {
        examiner.found(Condition::UpperRegisters, Verdict::Attention,
                       QStringLiteral("registers.upper.absent"),
                       DoctorText::tr("this software version has no registers 24 to 47"),
                       DoctorText::tr("Update the robot's software to 3.9, 5.3 or newer."));
    } else {
        examiner.good(Condition::UpperRegisters, DoctorText::tr("registers 24 to 47 are free"));
    }
    if (!inUse[1].empty()) {
        examiner.found(Condition::LowerRegisters, Verdict::Attention, QStringLiteral("registers.lower.taken"),
                       DoctorText::tr("a fieldbus adapter or another program uses %1").arg(joined(inUse[1])),
                       DoctorText::tr("No action needed for jogging. To use these registers, disable "
                                      "EtherNet/IP, PROFINET or MODBUS in the robot's installation."));
    } else {
        examiner.good(Condition::LowerRegisters, DoctorText::tr("registers 0 to 23 are free"));
    }
}

void examineData(Examiner& examiner) {
    if (!examiner.isGood(Condition::Protocol)) {
        return;
    }
    receive::ReceiverOptions options;
    options.host = examiner.address;
    options.port = static_cast<std::uint16_t>(examiner.patient.ports.rtde);
    options.priority = examiner.patient.priority;
    receive::Receiver receiver(options);
    receive::Subscription stream = receiver.subscribe();
    receive::Sample sample(receiver.layout());
    if (const auto started = receiver.start(); !started) {
        examiner.found(Condition::DataRate, Verdict::Bad, QStringLiteral("rate.none"),
                       started.error().toString(), {});
        return;
    }
    const Deadline deadline = examiner.within(kListenMs);
    double first = 0;
    double last = 0;
    int packages = 0;
    while (last - first < kLookSeconds && stream.next(sample, deadline)) {
        last = receive::RobotState(sample).timestamp();
        first = packages == 0 ? last : first;
        ++packages;
    }
    const realtime::PriorityReport priority = receiver.priority();
    receiver.stop();
    if (packages == 0) {
        examiner.found(Condition::DataRate, Verdict::Bad, QStringLiteral("rate.none"),
                       DoctorText::tr("the robot accepts the subscription but sends no data"),
                       DoctorText::tr("Close other RTDE programs, then restart the robot's controller."));
        return;
    }
    // Uses the controller's timestamps, so that the load of this PC has no effect.
    const double wanted = receiver.version().maxFrequency();
    const double rate = last > first ? (packages - 1) / (last - first) : 0;
    const QString detail =
        DoctorText::tr("%1 of %2 packets per second").arg(rate, 0, 'f', 0).arg(wanted, 0, 'f', 0);
    if (rate < kMinShare * wanted) {
        examiner.found(Condition::DataRate, Verdict::Bad, QStringLiteral("rate.low"), detail,
                       DoctorText::tr("Packets are missing. Use a cable instead of a wireless link, and "
                                      "close other programs that put load on the robot or this PC."));
    } else {
        examiner.good(Condition::DataRate, detail);
    }
    if (priority.ok()) {
        examiner.good(Condition::Privilege, DoctorText::tr("priority %1").arg(priority.granted));
    } else {
        examiner.found(Condition::Privilege, Verdict::Attention, QStringLiteral("privilege.none"),
                       DoctorText::tr("the system does not grant this user real-time priority"),
                       priority.advice);
    }
    // Relevant only with the permission for real-time priority, which is reported first.
    const QString latency = realtime::CpuLatency::advice();
    if (priority.ok() && latency.isEmpty()) {
        examiner.good(Condition::WakeUpLatency,
                      DoctorText::tr("real-time loops can keep the CPUs out of deep sleep states"));
    } else if (priority.ok()) {
        examiner.found(Condition::WakeUpLatency, Verdict::Attention, QStringLiteral("latency.none"),
                       DoctorText::tr("CPUs may enter deep sleep states, which delay real-time loops"),
                       latency);
    }
    const receive::RobotState robot(sample);
    judgeModes(examiner, robot.robotMode(), robot.safetyMode());
    if (!robot.has("tcp_offset") || !robot.has("payload")) {
        return;  // not reported by older software
    }
    const bool noTool = robot.tcpOffset().position.norm() < 1e-6;
    const bool noPayload = robot.payloadMass() < 1e-6;
    const QString tool = DoctorText::tr("TCP %1 mm from the flange, payload %2 kg")
                             .arg(robot.tcpOffset().position.norm() * 1e3, 0, 'f', 1)
                             .arg(robot.payloadMass(), 0, 'f', 2);
    if (noTool || noPayload) {
        examiner.found(
            Condition::ToolAndPayload, Verdict::Attention, QStringLiteral("payload.unset"), tool,
            DoctorText::tr("If a tool is mounted, set the TCP and the payload in the robot's installation: a "
                           "wrong payload causes protective stops and makes the arm drift in Freedrive."));
    } else {
        examiner.good(Condition::ToolAndPayload, tool);
    }
}

}  // namespace tiller::doctor
