// SPDX-License-Identifier: MIT
// Part of tiller._native: control of the arm, motions, streams, jogs and packet loops.
//
// As in C++, a motion continues when its handle is deleted. Streams and jogs end, because they can no longer
// be refreshed. All of them end when the controller is destroyed (every handle keeps it alive) or when the
// heartbeat of this process is missing.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

#include "robot/control/arm_queries.h"
#include "robot/control/compliance.h"
#include "robot/control/motions.h"
#include "robot/control/packet_loop.h"
#include "robot/control/programs.h"
#include "robot/control/tool_setup.h"
#include "robot/python/native_objects.h"

namespace tiller::python {

namespace {

using namespace control;
using SharedController = std::shared_ptr<NativeController>;

/// A motion and its controller, which must outlive the motion.
class NativeMotion {
public:
    NativeMotion(SharedController controller, Motion motion)
        : controller_(std::move(controller)), motion_(std::move(motion)) {}

    /// Ends the motion and waits for standstill. No effect in a forked child.
    void stop(const Seconds& seconds) const {
        if (controller_->isOwn()) {
            waited(seconds, [this](const Deadline& deadline) { return motion_.stop(deadline); });
        }
    }
    void wait(const Seconds& seconds) const {
        refuseOfParent(*controller_);
        waited(seconds, [this](const Deadline& deadline) { return motion_.wait(deadline); });
    }
    bool cancel() const { return controller_->isOwn() && motion_.cancel(StopCause::ApiCall); }
    bool isActive() const { return motion_.isActive(); }
    std::string kind() const { return toString(motion_.kind()); }
    std::string cause() const { return toString(motion_.state().cause); }
    py::dict progress() const {
        const MotionProgress now = motion_.progress();
        py::dict result;
        result["active"] = now.phase == MotionPhase::Active;
        result["cause"] = toString(now.cause);
        result["fraction"] = now.fraction;
        result["waypoint"] = now.waypoint;
        result["waypoints"] = now.waypoints;
        result["executing"] = now.executing;
        result["speed_fraction"] = now.speedFraction;
        result["speed_scaling"] = now.speedScaling;
        return result;
    }
    py::object plan() const {
        if (!motion_.plan()) {
            return py::none();
        }
        py::dict result;
        result["duration"] = motion_.plan()->duration.count();
        result["speed"] = motion_.plan()->speed;
        result["limiter"] = toString(motion_.plan()->limiter.kind);
        result["scale"] = motion_.plan()->limiter.scale;
        return result;
    }
    const Motion& motion() const { return motion_; }

private:
    SharedController controller_;
    Motion motion_;
};

/// Converts seconds from Python. The range is checked together with the other options.
std::chrono::milliseconds milliseconds(double seconds) {
    constexpr double kFarOff = 1e6;
    const double result = std::isnan(seconds) ? -1 : std::clamp(seconds, -kFarOff, kFarOff);
    return std::chrono::milliseconds(std::llround(result * 1000));
}

std::unique_ptr<NativeMotion> handle(const SharedController& controller, Result<Motion> motion) {
    return std::make_unique<NativeMotion>(controller, taken(std::move(motion)));
}

/// A setpoint stream that ends with this object.
template <class Setpoints, class Target>
struct NativeStream {
    NativeStream(const SharedController& controller, Setpoints s)
        : setpoints(std::move(s)), motion(controller, setpoints.motion()) {}
    ~NativeStream() { motion.cancel(); }
    NativeStream(const NativeStream&) = delete;
    NativeStream& operator=(const NativeStream&) = delete;
    Setpoints setpoints;
    NativeMotion motion;

    void send(const Six& target) {
        if constexpr (std::is_same_v<Target, Twist>) {
            taken(setpoints.send(twistOf(target)));
        } else if constexpr (std::is_same_v<Target, Pose>) {
            taken(setpoints.send(Pose::fromArray(target)));
        } else {
            taken(setpoints.send(Target(target)));
        }
    }
};
using NativeJointServo = NativeStream<JointServo, JointPositions>;
using NativePoseServo = NativeStream<PoseServo, Pose>;
using NativeCircularServo = NativeStream<CircularServo, Pose>;
using NativeJointSpeed = NativeStream<JointSpeed, JointVelocities>;
using NativeToolSpeed = NativeStream<ToolSpeed, Twist>;
using NativeJointTorque = NativeStream<JointTorque, JointTorques>;

template <class Stream>
void defineStream(py::module_& module, const char* name) {
    py::class_<Stream>(module, name)
        .def("send", &Stream::send, py::arg("target"))
        .def("is_active", [](const Stream& self) { return self.motion.isActive(); })
        .def("cause", [](const Stream& self) { return self.motion.cause(); })
        .def("cancel", [](const Stream& self) { return self.motion.cancel(); })
        .def(
            "stop", [](const Stream& self, const Seconds& seconds) { self.motion.stop(seconds); },
            py::arg("timeout"));
}

/// A jog that ends with this object, or 100 ms after its last refresh.
class NativeJog {
public:
    NativeJog(const SharedController& controller, const JogTarget& target)
        : jog_(taken(Motions(controller->controller).startJog(target))), motion_(controller, jog_) {}
    NativeJog(const NativeJog&) = delete;
    NativeJog& operator=(const NativeJog&) = delete;
    ~NativeJog() { motion_.cancel(); }

    bool refresh() const { return jog_.refresh(); }
    bool refresh(const JogTarget& target) const { return jog_.refresh(target); }
    const NativeMotion& motion() const { return motion_; }

private:
    Jog jog_;
    NativeMotion motion_;
};

enum class JogAxes { Base, Tool, Custom, Joints };
constexpr std::array<std::pair<const char*, JogAxes>, 4> kJogFrames{{{"base", JogAxes::Base},
                                                                     {"tool", JogAxes::Tool},
                                                                     {"custom", JogAxes::Custom},
                                                                     {"joints", JogAxes::Joints}}};

JogTarget jogTarget(const std::string& frame, const Six& velocity, const Six& customFrame,
                    double contactForce) {
    JogTarget target;
    target.contactForce = contactForce;
    const JogAxes axes = named("frame", frame, kJogFrames);
    if (axes == JogAxes::Joints) {
        target.kind = JogTarget::Kind::Joint;
        target.qd = JointVelocities(velocity);
        return target;
    }
    target.frame = axes == JogAxes::Tool     ? JogFrame::Tool
                   : axes == JogAxes::Custom ? JogFrame::Custom
                                             : JogFrame::Base;
    target.twist = twistOf(velocity);
    target.T_base_frame = Pose::fromArray(customFrame);
    return target;
}

/// waited  time spent waiting for the interpreter lock, which increases the age of the data [s]
py::dict cycleDict(const CycleState& cycle, double waited) {
    py::dict result;
    const auto array = [](const Six& v) { return py::array_t<double>(6, v.data()); };
    result["cycle"] = cycle.cycle;
    result["fresh"] = cycle.fresh && cycle.age + waited <= 2 * cycle.period;
    result["age"] = cycle.age + waited;
    result["missed"] = cycle.missed;
    result["time"] = cycle.time;
    result["period"] = cycle.period;
    result["q"] = array(cycle.q.array());
    result["qd"] = array(cycle.qd.array());
    result["tcp_pose"] = array(cycle.tcpPose.array());
    const Vector6 speed = cycle.tcpSpeed.vector();
    result["tcp_speed"] = py::array_t<double>(6, speed.data());
    result["speed_fraction"] = cycle.speedFraction;
    result["speed_scaling"] = cycle.speedScaling;
    if (const receive::Sample* packet = cycle.packet; packet != nullptr) {
        result["packet"] = py::make_tuple(
            packet->sequence, packet->hostTimeNs, packet->connection, packet->lostBefore,
            py::array_t<double>(static_cast<py::ssize_t>(packet->values.size()), packet->values.data()));
    }
    return result;
}

/// Position of each field in the values of the packets: maps the name to (first, count).
py::dict layoutDict(const CycleState& cycle) {
    py::dict result;
    if (cycle.packet != nullptr && cycle.packet->layout) {
        for (const auto& entry : cycle.packet->layout->entries()) {
            result[entry.name.c_str()] = py::make_tuple(entry.first, entry.count);
        }
    }
    return result;
}

enum class LoopKind { ServoJ, ServoL, SpeedJ, SpeedL, Torque };
constexpr std::array<std::pair<const char*, LoopKind>, 5> kLoopKinds{{{"servo_j", LoopKind::ServoJ},
                                                                      {"servo_l", LoopKind::ServoL},
                                                                      {"speed_j", LoopKind::SpeedJ},
                                                                      {"speed_l", LoopKind::SpeedL},
                                                                      {"torque", LoopKind::Torque}}};

/// Marks a controller as running a packet loop. Only one loop is possible, because there is only one control
/// thread.
class LoopClaim {
public:
    explicit LoopClaim(const SharedController& controller) : controller_(controller) {
        if (controller_->runsLoop.exchange(true)) {
            raise({ErrorCode::InvalidArgument, QStringLiteral("run a packet loop"),
                   QStringLiteral("another packet_loop() of this robot is already running")});
        }
    }
    ~LoopClaim() { controller_->runsLoop = false; }
    LoopClaim(const LoopClaim&) = delete;
    LoopClaim& operator=(const LoopClaim&) = delete;

private:
    const SharedController& controller_;
};

/// Runs a loop whose targets come from a Python callable. An exception ends the loop: the arm stops, and the
/// caller receives the exception.
py::dict packetLoop(const SharedController& controller, const std::string& name, const py::function& callback,
                    bool atOnce, const Seconds& seconds) {
    refuseInCallback();
    refuseOfParent(*controller);
    const LoopKind kind = named("kind", name, kLoopKinds);
    const LoopClaim claim(controller);
    std::exception_ptr thrown;
    CycleReport report;
    std::chrono::duration<double> longestWait{0};
    std::optional<py::dict> layout;  // accessed with the interpreter lock
    const auto ask = [&](const CycleState& cycle) -> std::optional<Six> {
        if (isParked()) {
            return std::nullopt;
        }
        const auto before = std::chrono::steady_clock::now();
        const py::gil_scoped_acquire locked;
        const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - before;
        longestWait = std::max(longestWait, waited);
        const InCallback callbackRuns;
        try {
            if (!layout) {
                layout = layoutDict(cycle);
            }
            const py::object answer = callback(cycleDict(cycle, waited.count()), *layout);
            return answer.is_none() ? std::nullopt : std::optional(answer.cast<Six>());
        } catch (...) {
            thrown = std::current_exception();
            return std::nullopt;
        }
    };
    const CancelToken token([] { return isInterrupted(); });
    const Deadline deadline =
        seconds ? Deadline::after(std::chrono::duration<double>(*seconds), token) : Deadline::never(token);
    Result<void> result;
    {
        const GilReleased released;
        PacketLoop loop(controller->controller, atOnce ? Pacing::AtOnce : Pacing::Even);
        const auto as = [&ask](auto make) {
            return [&ask, make](const CycleState& cycle) {
                const auto six = ask(cycle);
                return six ? std::optional(make(*six)) : std::nullopt;
            };
        };
        if (kind == LoopKind::ServoJ) {
            result = loop.servoJ(as([](const Six& v) { return JointPositions(v); }), {}, deadline, &report);
        } else if (kind == LoopKind::ServoL) {
            result = loop.servoL(as([](const Six& v) { return Pose::fromArray(v); }), {}, deadline, &report);
        } else if (kind == LoopKind::SpeedJ) {
            result = loop.speedJ(as([](const Six& v) { return JointVelocities(v); }), {}, deadline, &report);
        } else if (kind == LoopKind::Torque) {
            result = loop.torque(as([](const Six& v) { return JointTorques(v); }), {}, deadline, &report);
        } else {
            result = loop.speedL(as([](const Six& v) { return twistOf(v); }), {}, deadline, &report);
        }
    }
    if (thrown) {
        std::rethrow_exception(thrown);
    }
    if (PyErr_Occurred() != nullptr) {
        throw py::error_already_set();
    }
    constexpr std::chrono::duration<double, std::milli> kNoticeable(1);
    if (!result && result.error().code == ErrorCode::Stopped && longestWait > kNoticeable) {
        Error error = result.error();
        error.controllerMessage +=
            QStringLiteral("; a call waited up to %1 ms for other Python threads")
                .arg(std::chrono::duration<double, std::milli>(longestWait).count(), 0, 'f', 1);
        result = error;
    }
    taken(result);
    py::dict summary;
    summary["cycles"] = report.cycles;
    summary["missed"] = report.missed;
    summary["stale"] = report.stale;
    summary["late"] = report.late;
    summary["overruns"] = report.overruns;
    summary["fast_wake_ups"] = report.fastWakeUps;
    summary["longest_call"] = static_cast<double>(report.calls.maxNs()) * 1e-9;
    summary["longest_wait"] = longestWait.count();
    return summary;
}

py::dict statusDict(const NativeController& self) {
    const ControllerStatus status = self.controller.status();
    py::dict result;
    result["in_control"] = status.inControl;
    result["loss"] = toString(status.loss);
    result["fresh"] = status.fresh;
    result["robot_mode"] = toString(status.fresh ? status.robotMode : RobotMode::Disconnected);
    result["safety_mode"] = toString(status.fresh ? status.safetyMode : SafetyMode::Undefined);
    result["moving"] = status.moving;
    result["force_mode"] = status.forceMode;
    result["executing"] = status.executing;
    result["limiter"] = toString(status.limiter.kind);
    result["limiter_joint"] = status.limiter.joint;
    result["limiter_scale"] = status.limiter.scale;
    result["last_cause"] = toString(status.lastCause);
    result["last_stop_ms"] = status.lastStop.durationMs;
    result["last_stop_mm"] = status.lastStop.distanceMm;
    result["round_trip_ms"] = status.roundTripMs;
    result["speed_fraction"] = status.speedFraction;
    result["speed_scaling"] = status.speedScaling;
    return result;
}

/// Python type: (True for a pose, numbers).
using PathPlace = std::tuple<bool, Six>;
/// Python type: (kind, target, via or None, speed or None, acceleration or None, blend).
using PathRow = std::tuple<std::string, PathPlace, std::optional<PathPlace>, std::optional<double>,
                           std::optional<double>, double>;
constexpr std::array<std::pair<const char*, PathEntry::Kind>, 4> kPathKinds{{{"j", PathEntry::Kind::MoveJ},
                                                                             {"l", PathEntry::Kind::MoveL},
                                                                             {"p", PathEntry::Kind::MoveP},
                                                                             {"c", PathEntry::Kind::MoveC}}};

/// speedCap  [m/s]: upper limit of the default speeds
MotionPath pathOf(const std::vector<PathRow>& rows, double speedCap) {
    MotionPath path;
    const auto place = [](const PathPlace& given) {
        const auto& [isPose, numbers] = given;
        return isPose ? PathEntry::Target(Pose::fromArray(numbers))
                      : PathEntry::Target(JointPositions(numbers));
    };
    for (const auto& [kind, target, via, speed, acceleration, blend] : rows) {
        PathEntry entry;
        entry.kind = named("kind", kind, kPathKinds);
        entry.target = place(target);
        if (via) {
            entry.via = place(*via);
        }
        // The defaults are the same as in MoveParameters.
        const bool turnsJoints = entry.kind == PathEntry::Kind::MoveJ;
        entry.speed = speed.value_or(turnsJoints ? 1.05 : std::min(0.25, speedCap));
        entry.acceleration = acceleration.value_or(turnsJoints ? 1.4 : 1.2);
        entry.blend = blend;
        path.push_back(entry);
    }
    return path;
}

void defineMotions(ControllerClass& cls) {
    const auto parameters = [](std::optional<double> speed, double acceleration, double heartbeatTimeout) {
        return MoveParameters{.speed = speed,
                              .acceleration = acceleration,
                              .holding = Holding::Free,
                              .heartbeatTimeout = milliseconds(heartbeatTimeout)};
    };
    cls.def("move_j", [parameters](const SharedController& self, const Six& q, double speed,
                                   double acceleration, double heartbeatTimeout) {
        return handle(self, Motions(self->controller)
                                .moveJ(JointPositions(q), parameters(speed, acceleration, heartbeatTimeout)));
    });
    cls.def("move_j_to_pose", [parameters](const SharedController& self, const Six& pose, double speed,
                                           double acceleration, double heartbeatTimeout) {
        return handle(
            self, Motions(self->controller)
                      .moveJToPose(Pose::fromArray(pose), parameters(speed, acceleration, heartbeatTimeout)));
    });
    cls.def("move_l", [parameters](const SharedController& self, const Six& pose, std::optional<double> speed,
                                   double acceleration, double heartbeatTimeout) {
        return handle(self,
                      Motions(self->controller)
                          .moveL(Pose::fromArray(pose), parameters(speed, acceleration, heartbeatTimeout)));
    });
    cls.def("move_l_to_joints", [parameters](const SharedController& self, const Six& q,
                                             std::optional<double> speed, double acceleration,
                                             double heartbeatTimeout) {
        return handle(
            self, Motions(self->controller)
                      .moveLToJoints(JointPositions(q), parameters(speed, acceleration, heartbeatTimeout)));
    });
    cls.def("move_path", [](const SharedController& self, const std::vector<PathRow>& rows,
                            const Seconds& seconds, double heartbeatTimeout) {
        const MotionPath path = pathOf(rows, self->controller.limits().tcpSpeed);
        return handle(self, waited(seconds, [&](const Deadline& deadline) {
                          return Motions(self->controller)
                              .movePath(path, deadline, Holding::Free, milliseconds(heartbeatTimeout));
                      }));
    });
    cls.def("move_until_contact", [](const SharedController& self, const Six& twist, const Six& direction,
                                     double acceleration, const Seconds& seconds) {
        return handle(self, waited(seconds, [&](const Deadline& deadline) {
                          return Motions(self->controller)
                              .moveUntilContact(twistOf(twist), deadline,
                                                {.direction = twistOf(direction),
                                                 .acceleration = acceleration,
                                                 .holding = Holding::Free});
                      }));
    });
    cls.def("stop_j", [](const SharedController& self, double deceleration) {
        return handle(self, Motions(self->controller).stopJ(deceleration));
    });
    cls.def("stop_l", [](const SharedController& self, double deceleration) {
        return handle(self, Motions(self->controller).stopL(deceleration));
    });
    cls.def("servo_j", [](const SharedController& self, double lookahead, double gain) {
        return std::make_unique<NativeJointServo>(
            self, taken(Motions(self->controller).startServoJ({.lookahead = lookahead, .gain = gain})));
    });
    cls.def("servo_l", [](const SharedController& self, double lookahead, double gain) {
        return std::make_unique<NativePoseServo>(
            self, taken(Motions(self->controller).startServoL({.lookahead = lookahead, .gain = gain})));
    });
    cls.def("servo_c", [](const SharedController& self, double speed, double acceleration, double blend) {
        return std::make_unique<NativeCircularServo>(
            self, taken(Motions(self->controller).startServoC({speed, acceleration, blend})));
    });
    cls.def("speed_j", [](const SharedController& self, double acceleration) {
        return std::make_unique<NativeJointSpeed>(
            self, taken(Motions(self->controller).startSpeedJ({.acceleration = acceleration})));
    });
    cls.def("speed_l", [](const SharedController& self, double acceleration) {
        return std::make_unique<NativeToolSpeed>(
            self, taken(Motions(self->controller).startSpeedL({.acceleration = acceleration})));
    });
    cls.def("torque", [](const SharedController& self, const std::optional<Six>& viscousScale,
                         const std::optional<Six>& coulombScale) {
        TorqueParameters friction;
        friction.viscousScale = viscousScale.value_or(friction.viscousScale);
        friction.coulombScale = coulombScale.value_or(friction.coulombScale);
        return std::make_unique<NativeJointTorque>(self,
                                                   taken(Motions(self->controller).startTorque(friction)));
    });
    cls.def("jog", [](const SharedController& self, const std::string& frame, const Six& velocity,
                      const Six& customFrame, double contactForce) {
        return std::make_unique<NativeJog>(self, jogTarget(frame, velocity, customFrame, contactForce));
    });
    cls.def("packet_loop", &packetLoop);
    cls.def("freedrive", [](const SharedController& self) {
        return handle(self, Compliance(self->controller).startFreedrive());
    });
}

void defineQueries(ControllerClass& cls) {
    cls.def("inverse_kinematics", [](const SharedController& self, const Six& pose,
                                     const std::optional<Six>& near, const Seconds& seconds) {
        InverseOptions options;
        if (near) {
            options.near = JointPositions(*near);
        }
        return waited(seconds,
                      [&](const Deadline& deadline) {
                          return ArmQueries(self->controller)
                              .inverseKinematics(Pose::fromArray(pose), options, deadline);
                      })
            .array();
    });
    cls.def("forward_kinematics", [](const SharedController& self, const Six& q, const Seconds& seconds) {
        return waited(seconds,
                      [&](const Deadline& deadline) {
                          return ArmQueries(self->controller)
                              .forwardKinematics(JointPositions(q), std::nullopt, deadline);
                      })
            .array();
    });
    cls.def("set_payload", [](const SharedController& self, double mass,
                              const std::optional<std::array<double, 3>>& cog, const Seconds& seconds) {
        const auto centre =
            cog ? std::optional(Eigen::Vector3d((*cog)[0], (*cog)[1], (*cog)[2])) : std::nullopt;
        waited(seconds, [&](const Deadline& deadline) {
            return ToolSetup(self->controller).setPayload(mass, centre, deadline);
        });
    });
    cls.def("set_tcp", [](const SharedController& self, const Six& tcp, const Seconds& seconds) {
        waited(seconds, [&](const Deadline& deadline) {
            return ToolSetup(self->controller).setTcp(Pose::fromArray(tcp), deadline);
        });
    });
    cls.def("zero_force_sensor", [](const SharedController& self, const Seconds& seconds) {
        waited(seconds, [&](const Deadline& deadline) {
            return ToolSetup(self->controller).zeroForceSensor(deadline);
        });
    });
    cls.def("force_mode",
            [](const SharedController& self, const Six& frame, const std::array<bool, 6>& compliant,
               const Six& wrench, int type, const Six& limits, std::uint64_t stops, const Seconds& seconds) {
                ForceMode mode;
                mode.taskFrame = Pose::fromArray(frame);
                mode.compliant = compliant;
                mode.wrench = wrenchOf(wrench);
                mode.type = static_cast<ForceMode::Type>(type);
                mode.limits = limits;
                waited(seconds, [&](const Deadline& deadline) {
                    return Compliance(self->controller, stops).setForceMode(mode, deadline);
                });
            });
    cls.def("end_force_mode", [](const SharedController& self, const Seconds& seconds) {
        waited(seconds,
               [&](const Deadline& deadline) { return Compliance(self->controller).endForceMode(deadline); });
    });
    cls.def("start_function", [](const SharedController& self, const std::string& name,
                                 const std::string& body, const Seconds& seconds) {
        return handle(self, waited(seconds, [&](const Deadline& deadline) {
                          return Programs(self->controller).startFunction(name, body, deadline);
                      }));
    });
    cls.def("run_script", [](const SharedController& self, const std::string& program, const Seconds& seconds,
                             bool unattended) {
        const auto supervision = unattended ? Supervision::Unattended : Supervision::Heartbeat;
        waited(seconds, [&](const Deadline& deadline) {
            return Programs(self->controller).runScript(program, deadline, supervision);
        });
    });
}

}  // namespace

void defineControl(py::module_& module) {
    py::class_<NativeMotion>(module, "Motion")
        .def("wait", &NativeMotion::wait, py::arg("timeout"))
        .def("cancel", &NativeMotion::cancel)
        .def("is_active", &NativeMotion::isActive)
        .def("kind", &NativeMotion::kind)
        .def("cause", &NativeMotion::cause)
        .def("progress", &NativeMotion::progress)
        .def("plan", &NativeMotion::plan);
    py::class_<NativeJog>(module, "Jog")
        .def("refresh", [](const NativeJog& self) { return self.refresh(); })
        .def("change",
             [](const NativeJog& self, const std::string& frame, const Six& velocity, const Six& customFrame,
                double contactForce) {
                 return self.refresh(jogTarget(frame, velocity, customFrame, contactForce));
             })
        .def("cancel", [](const NativeJog& self) { return self.motion().cancel(); })
        .def(
            "stop", [](const NativeJog& self, const Seconds& seconds) { self.motion().stop(seconds); },
            py::arg("timeout"))
        .def("is_active", [](const NativeJog& self) { return self.motion().isActive(); })
        .def("cause", [](const NativeJog& self) { return self.motion().cause(); });
    defineStream<NativeJointServo>(module, "JointServo");
    defineStream<NativePoseServo>(module, "PoseServo");
    defineStream<NativeCircularServo>(module, "CircularServo");
    defineStream<NativeJointSpeed>(module, "JointSpeed");
    defineStream<NativeToolSpeed>(module, "ToolSpeed");
    defineStream<NativeJointTorque>(module, "JointTorque");

    ControllerClass cls(module, "Controller");
    cls.def(py::init([](const std::string& host, int portOffset, bool upperRegisters, int priority,
                        double speedCap, SharedClock clock, const std::vector<std::string>& fields) {
                ControllerOptions options;
                options.host = host;
                options.portOffset = portOffset;
                options.registers = upperRegisters ? RegisterRange::Upper : RegisterRange::Lower;
                options.priority = priority;
                options.fields = fields;
                auto made = sharedOwn<NativeController>(options, std::move(clock));
                taken(made->controller.setSpeedCap(speedCap));
                return made;
            }),
            py::arg("host"), py::arg("port_offset"), py::arg("upper_registers"), py::arg("priority"),
            py::arg("speed_cap"), py::arg("clock"), py::arg("fields"));
    cls.def("take_control", [](const SharedController& self, const Seconds& seconds) {
        waited(seconds, [&](const Deadline& deadline) { return self->controller.takeControl(deadline); });
    });
    cls.def(
        "release", [](NativeController& self) { self.release(); }, py::call_guard<WaitingCall>());
    cls.def("stops", [](const NativeController& self) { return self.controller.stops(); });
    cls.def("is_busy", [](const NativeController& self) {
        const ControllerStatus status = self.controller.status();
        return status.motion != kNoMotion || status.moving || status.forceMode;
    });
    cls.def("stop", [](NativeController& self) { self.controller.stop(StopCause::ApiCall); });
    cls.def("status", &statusDict);
    cls.def("speed_cap", [](const NativeController& self) { return self.controller.limits().tcpSpeed; });
    cls.def("set_speed_cap",
            [](NativeController& self, double cap) { taken(self.controller.setSpeedCap(cap)); });
    defineMotions(cls);
    defineQueries(cls);
    defineSetup(cls);
}

}  // namespace tiller::python
