// SPDX-License-Identifier: MIT

// Checks of the host and its open ports.

#include <QHostAddress>
#include <QHostInfo>
#include <QTcpSocket>
#include <array>
#include <thread>

#include "robot/doctor/detail/examiner.h"
#include "robot/script/tcp_socket.h"

namespace tiller::doctor {
namespace {

constexpr int kConnectMs = 2000;

struct Door {
    Condition condition;
    int port;
    bool needed;  ///< required by Tiller
    const char* name;
    Error error;  ///< code None: the port is open
};

/// Checks all ports in parallel. Otherwise a firewall that drops packets would cost one timeout per port.
void tryDoors(const QString& address, std::array<Door, 5>& doors, const Deadline& deadline) {
    std::array<std::thread, 5> knocking;
    for (std::size_t i = 0; i < doors.size(); ++i) {
        knocking[i] = std::thread([&address, &door = doors[i], &deadline] {
            door.error = script::openTcpSocket(address, door.port, deadline).error();
        });
    }
    for (std::thread& thread : knocking) {
        thread.join();
    }
}

}  // namespace

bool examineAddress(Examiner& examiner) {
    const QString host = examiner.patient.host.trimmed();
    if (!QHostAddress(host).isNull()) {
        examiner.address = host;
        examiner.good(Condition::Address, host);
        return true;
    }
    const QHostInfo info = host.isEmpty() ? QHostInfo() : QHostInfo::fromName(host);
    for (const QHostAddress& known : info.addresses()) {
        if (known.protocol() == QAbstractSocket::IPv4Protocol) {
            examiner.address = known.toString();
            examiner.good(Condition::Address, QStringLiteral("%1 = %2").arg(host, examiner.address));
            return true;
        }
    }
    examiner.found(
        Condition::Address, Verdict::Bad, QStringLiteral("address.unresolved"),
        DoctorText::tr("“%1” is not a valid address, and no host with this name was found").arg(host),
        DoctorText::tr("Enter the IP address shown on the teach pendant under About, or ask your network "
                       "administrator for the host name."));
    return false;
}

void examinePorts(Examiner& examiner) {
    const Ports& p = examiner.patient.ports;
    std::array<Door, 5> doors = {{
        {Condition::RtdePort, p.rtde, true, "rtde", {}},
        {Condition::PrimaryPort, p.primary, true, "primary", {}},
        {Condition::SecondaryPort, p.secondary, false, "secondary", {}},
        {Condition::RealtimePort, p.realtime, false, "realtime", {}},
        {Condition::ServicePort, p.dashboard, true, "service", {}},
    }};
    tryDoors(examiner.address, doors, examiner.within(kConnectMs));

    int open = 0;
    int refused = 0;
    for (const Door& door : doors) {
        open += door.error.code == ErrorCode::None ? 1 : 0;
        refused += door.error.code == ErrorCode::ConnectionRefused ? 1 : 0;
    }
    if (open == 0 && refused == 0) {
        const bool silent = doors[0].error.code == ErrorCode::Timeout;
        examiner.found(
            Condition::Host, Verdict::Bad,
            silent ? QStringLiteral("host.silent") : QStringLiteral("host.unreachable"),
            silent ? DoctorText::tr("%1 does not respond").arg(examiner.address)
                   : DoctorText::tr("no network route to %1").arg(examiner.address),
            silent ? DoctorText::tr("Check that the robot is switched on, the cable is plugged in, and no "
                                    "firewall blocks the connection.")
                   : DoctorText::tr("Assign this PC an address in the robot's network (the same first three "
                                    "numbers), and check the cable."));
        return;
    }
    if (open == 0 && refused == static_cast<int>(doors.size())) {
        examiner.found(Condition::Host, Verdict::Bad, QStringLiteral("host.no-robot"),
                       DoctorText::tr("%1 responds, but provides no robot services").arg(examiner.address),
                       DoctorText::tr("Check that this is the address of the robot. A robot that has just "
                                      "been switched on may need another minute."));
        return;
    }
    examiner.good(Condition::Host, DoctorText::tr("%1 responds").arg(examiner.address));
    for (const Door& door : doors) {
        if (door.condition == Condition::ServicePort) {
            if (door.error.code == ErrorCode::None) {
                examiner.good(door.condition, DoctorText::tr("dashboard, port %1").arg(door.port));
            }
            continue;  // PolyScope X has a different service: see examineService(examiner)
        }
        if (door.error.code == ErrorCode::None) {
            examiner.good(door.condition, DoctorText::tr("port %1").arg(door.port));
            continue;
        }
        const bool wasRefused = door.error.code == ErrorCode::ConnectionRefused;
        examiner.found(
            door.condition, door.needed ? Verdict::Bad : Verdict::Attention,
            QStringLiteral("port.%1.%2")
                .arg(QLatin1String(door.name),
                     wasRefused ? QStringLiteral("refused") : QStringLiteral("silent")),
            wasRefused ? DoctorText::tr("port %1 is closed").arg(door.port)
                       : DoctorText::tr("port %1 does not respond").arg(door.port),
            wasRefused
                ? DoctorText::tr("Enable this interface on the robot under Settings > Security > Services.")
                : DoctorText::tr("A firewall may be blocking this port. Allow TCP port %1 to the robot.")
                      .arg(door.port));
    }
}

}  // namespace tiller::doctor
