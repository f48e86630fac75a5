// SPDX-License-Identifier: MIT
#pragma once

// All backend calls with a deadline, and a peer that does not respond. Used by the test of deadlines and by
// the benchmark of their accuracy.

#include <vector>

#include "robot/control/arm_queries.h"
#include "robot/control/compliance.h"
#include "robot/control/motions.h"
#include "robot/control/packet_loop.h"
#include "robot/control/programs.h"
#include "robot/control/tool_setup.h"
#include "robot/dashboard/dashboard_client.h"
#include "robot/dashboard/detail/dashboard_commands.h"
#include "robot/io/input_registers.h"
#include "robot/io/outputs.h"
#include "robot/io/robotiq_client.h"
#include "robot/receive/receiver.h"
#include "robot/rtde/connection.h"
#include "robot/script/primary_client.h"
#include "robot/script/script_client.h"
#include "tests/integration/control/cell.h"
#include "tests/support/raw_peer.h"

namespace tiller::test {

/// A controlled robot that has stopped responding, and servers that accept clients and send nothing.
struct MuteWorld {
    // a software version with all functions
    Cell cell{[](simulator::SimulatorOptions& options) { options.software = {5, 25, 1, 0}; }};
    RawPeer mute{[](RawPeer::Link& link) { link.beMute(); }};
    RawPeer greets{[](RawPeer::Link& link) {
        link.send("Connected: Universal Robots Dashboard Server\n");
        link.beMute();
    }};
    /// Never reads. The system accepts data until its buffers are full.
    RawPeer unresponsive{[](RawPeer::Link& link) {
        while (!link.isOver()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }};

    std::vector<std::shared_ptr<void>> kept;

    Result<void> begin() {
        if (const auto taken = cell.takeControl(); !taken) {
            return taken;
        }
        cell.robot.silence(true);  // from here on, the robot neither steps nor sends packets
        return {};
    }
    control::Controller& controller() { return *cell.controller; }
    QString host() const { return QStringLiteral("127.0.0.1"); }
};

struct BlockingCall {
    const char* name;
    std::function<Error(MuteWorld&, const Deadline&)> run;
};

inline std::vector<BlockingCall> blockingCalls() {
    using namespace tiller::control;
    using D = const Deadline&;
    std::vector<BlockingCall> all;
    const auto add = [&](const char* name, std::function<Error(MuteWorld&, const Deadline&)> run) {
        all.push_back({name, std::move(run)});
    };
    const auto query = [&](const char* name, auto ask) {
        add(name, [ask](MuteWorld& w, D d) { return ask(ArmQueries(w.controller()), d).error(); });
    };
    query("inverseKinematics", [](ArmQueries q, D d) { return q.inverseKinematics({}, {}, d); });
    query("hasInverseKinematics", [](ArmQueries q, D d) { return q.hasInverseKinematics({}, {}, d); });
    query("forwardKinematics", [](ArmQueries q, D d) { return q.forwardKinematics({}, {}, d); });
    query("isWithinSafetyLimits, pose", [](ArmQueries q, D d) { return q.isWithinSafetyLimits(Pose(), d); });
    query("isWithinSafetyLimits, joints",
          [](ArmQueries q, D d) { return q.isWithinSafetyLimits(JointPositions(), d); });
    query("jointTorques", [](ArmQueries q, D d) { return q.jointTorques(d); });
    query("isSteady", [](ArmQueries q, D d) { return q.isSteady(d); });
    query("toolContact", [](ArmQueries q, D d) { return q.toolContact({}, d); });
    query("targetWaypoint", [](ArmQueries q, D d) { return q.targetWaypoint(d); });
    query("jointPositionsHistory", [](ArmQueries q, D d) { return q.jointPositionsHistory(0, d); });
    query("stepTime", [](ArmQueries q, D d) { return q.stepTime(d); });
    query("tcpOffset", [](ArmQueries q, D d) { return q.tcpOffset(d); });
    query("flangePose", [](ArmQueries q, D d) { return q.flangePose(d); });
    query("freedriveStatus", [](ArmQueries q, D d) { return q.freedriveStatus(d); });

    const auto setting = [&](const char* name, auto ask) {
        add(name, [ask](MuteWorld& w, D d) { return ask(ToolSetup(w.controller()), d).error(); });
    };
    setting("setPayload", [](ToolSetup s, D d) { return s.setPayload(1, {}, d); });
    setting("setTargetPayload", [](ToolSetup s, D d) { return s.setTargetPayload(1, {0, 0, 0}, {}, d); });
    setting("setTcp", [](ToolSetup s, D d) { return s.setTcp({}, d); });
    setting("setGravity", [](ToolSetup s, D d) { return s.setGravity({0, 0, 9.82}, d); });
    setting("zeroForceSensor", [](ToolSetup s, D d) { return s.zeroForceSensor(d); });
    setting("useExternalSensor", [](ToolSetup s, D d) { return s.useExternalSensor({}, d); });
    setting("useExternalSensorLegacy", [](ToolSetup s, D d) { return s.useExternalSensorLegacy({}, d); });
    setting("useOwnSensor", [](ToolSetup s, D d) { return s.useOwnSensor(d); });
    setting("setWatchdog", [](ToolSetup s, D d) { return s.setWatchdog(10, d); });
    setting("triggerProtectiveStop", [](ToolSetup s, D d) { return s.triggerProtectiveStop(d); });

    const auto yielding = [&](const char* name, auto ask) {
        add(name, [ask](MuteWorld& w, D d) { return ask(Compliance(w.controller()), d).error(); });
    };
    yielding("setForceMode", [](Compliance c, D d) {
        ForceMode mode;
        mode.limits = {1, 1, 1, 1, 1, 1};
        return c.setForceMode(mode, d);
    });
    yielding("endForceMode", [](Compliance c, D d) { return c.endForceMode(d); });
    yielding("setForceDamping", [](Compliance c, D d) { return c.setForceDamping(0.5, d); });
    yielding("setForceGainScaling", [](Compliance c, D d) { return c.setForceGainScaling(1, d); });
    yielding("startContactDetection", [](Compliance c, D d) { return c.startContactDetection({}, d); });
    yielding("hasContact", [](Compliance c, D d) { return c.hasContact(d); });
    yielding("endContactDetection", [](Compliance c, D d) { return c.endContactDetection(d); });

    const auto sending = [&](const char* name, auto ask) {
        add(name, [ask](MuteWorld& w, D d) { return ask(Programs(w.controller()), d).error(); });
    };
    sending("startFunction", [](Programs p, D d) {
        return p.startFunction(QStringLiteral("f"), QStringLiteral("sync()"), d);
    });
    sending("runScript",
            [](Programs p, D d) { return p.runScript(QStringLiteral("def f():\n  sync()\nend\n"), d); });
    sending("endControlProgram", [](Programs p, D d) { return p.endControlProgram(d); });
    sending("reupload", [](Programs p, D d) { return p.reupload(d); });
    add("movePath", [](MuteWorld& w, D d) {
        return Motions(w.controller())
            .movePath({{PathEntry::Kind::MoveJ, w.cell.robot.truth().q, {}, 0.5, 1.4, 0}}, d)
            .error();
    });
    add("takeControl of a mute robot", [](MuteWorld& w, D d) {
        ControllerOptions options;
        options.host = w.host();
        options.primaryPort = w.mute.port();
        options.rtdePort = w.mute.port();
        options.priority = 0;
        return Controller(options).takeControl(d).error();
    });

    add("packet loop servoJ", [](MuteWorld& w, D d) {
        const auto hold = [](const CycleState& state) { return std::optional(state.q); };
        return PacketLoop(w.controller()).servoJ(hold, {}, d).error();
    });
    add("packet loop servoL", [](MuteWorld& w, D d) {
        const auto hold = [](const CycleState& state) { return std::optional(state.tcpPose); };
        return PacketLoop(w.controller()).servoL(hold, {}, d).error();
    });
    add("packet loop speedJ", [](MuteWorld& w, D d) {
        const auto hold = [](const CycleState&) { return std::optional(JointVelocities()); };
        return PacketLoop(w.controller()).speedJ(hold, {}, d).error();
    });
    add("packet loop speedL", [](MuteWorld& w, D d) {
        const auto hold = [](const CycleState&) { return std::optional(Twist()); };
        return PacketLoop(w.controller()).speedL(hold, {}, d).error();
    });
    add("packet loop torque", [](MuteWorld& w, D d) {
        const auto none = [](const CycleState&) { return std::optional(JointTorques()); };
        return PacketLoop(w.controller()).torque(none, {}, d).error();
    });
    add("Motion::wait", [](MuteWorld& w, D d) {
        const auto motion = Motions(w.controller()).startSpeedJ({}, Holding::Free);
        return motion ? motion->motion().wait(d).error() : motion.error();
    });

    add("Outputs::connect", [](MuteWorld& w, D d) {
        io::Outputs outputs({w.host(), static_cast<std::uint16_t>(w.mute.port())},
                            {[] { return io::Report(); }});
        return outputs.connect(d).error();
    });
    add("Outputs::setSpeedSlider", [](MuteWorld& w, D d) {
        io::Outputs outputs({w.host(), static_cast<std::uint16_t>(w.mute.port())},
                            {[] { return io::Report(); }});
        return outputs.setSpeedSlider(0.5, d).error();
    });
    add("InputRegisters::connect", [](MuteWorld& w, D d) {
        io::InputRegistersOptions options;
        options.host = w.host();
        options.port = static_cast<std::uint16_t>(w.mute.port());
        options.ints = {30};
        return io::InputRegisters(options).connect(d).error();
    });

    const auto gripping = [&](const char* name, auto ask) {
        add(name, [ask](MuteWorld& w, D d) {
            io::RobotiqClient client(w.host(), w.mute.port());
            const auto connected = client.connect(Deadline::after(std::chrono::seconds(60)));
            return connected ? ask(client, d).error() : connected.error();
        });
    };
    using Gripper = io::RobotiqClient;
    gripping("RobotiqClient::get", [](Gripper& c, D d) { return c.get("POS", d); });
    gripping("RobotiqClient::set", [](Gripper& c, D d) { return c.set({{"SPE", 1}}, d); });
    gripping("RobotiqClient::look", [](Gripper& c, D d) { return c.look(d); });
    gripping("RobotiqClient::beginActivation", [](Gripper& c, D d) { return c.beginActivation(d); });
    gripping("RobotiqClient::move", [](Gripper& c, D d) { return c.move(0, 0, 0, d); });

    const auto asking = [&](const char* name, auto ask) {
        add(name, [ask](MuteWorld& w, D d) {
            dashboard::DashboardClient client(w.host(), w.greets.port());
            const auto connected = client.connect(Deadline::after(std::chrono::seconds(60)));
            return connected ? ask(client, d).error() : connected.error();
        });
    };
    using Dashboard = dashboard::DashboardClient;
    add("DashboardClient::connect",
        [](MuteWorld& w, D d) { return Dashboard(w.host(), w.mute.port()).connect(d).error(); });
    asking("DashboardClient::powerOn", [](Dashboard& c, D d) { return c.powerOn(d); });
    asking("DashboardClient::robotMode", [](Dashboard& c, D d) { return c.robotMode(d); });
    asking("DashboardClient::programState", [](Dashboard& c, D d) { return c.programState(d); });
    asking("DashboardClient::command", [](Dashboard& c, D d) { return c.command(QStringLiteral("x"), d); });
    asking("dashboard::safetyStatus", [](Dashboard& c, D d) { return dashboard::safetyStatus(c, d); });
    asking("dashboard::generateFlightReport", [](Dashboard& c, D d) {
        return dashboard::generateFlightReport(c, dashboard::FlightReport::System, d);
    });

    add("PrimaryClient::waitForState", [](MuteWorld& w, D d) {
        script::PrimaryClientOptions options;
        options.host = w.host();
        options.port = w.mute.port();
        const auto client = std::make_shared<script::PrimaryClient>(options);
        w.kept.push_back(client);  // destruction of the object must not be part of the measured call
        client->start();
        return client->waitForState(d).error();
    });
    add("ScriptClient::send to a peer that is not reading", [](MuteWorld& w, D d) {
        script::ScriptClient client(w.host(), w.unresponsive.port());
        const auto connected = client.connect(Deadline::after(std::chrono::seconds(60)));
        return connected ? client.send(QString(8'000'000, QLatin1Char('x')), d).error() : connected.error();
    });
    add("rtde::Connection::open", [](MuteWorld& w, D d) {
        rtde::ConnectionOptions options;
        options.host = w.host();
        options.port = static_cast<std::uint16_t>(w.mute.port());
        return rtde::Connection::open(options, d).error();
    });
    return all;
}

}  // namespace tiller::test
