// SPDX-License-Identifier: MIT
// Part of tiller._native: settings, queries and output pulses of the controller. None of these functions
// starts a motion.
#include <algorithm>
#include <cstdint>

#include "robot/control/arm_queries.h"
#include "robot/control/compliance.h"
#include "robot/control/output_pulses.h"
#include "robot/control/tool_setup.h"
#include "robot/python/native_objects.h"

namespace tiller::python {

namespace {

using namespace control;
using SharedController = std::shared_ptr<NativeController>;
using Three = std::array<double, 3>;

Eigen::Vector3d vectorOf(const Three& v) {
    return {v[0], v[1], v[2]};
}

/// Defines a function whose only argument is the timeout, e.g. a query.
template <class Access, class Method>
void defineCall(ControllerClass& cls, const char* name, Method method) {
    cls.def(name, [method](const SharedController& self, const Seconds& seconds) {
        return waited(seconds,
                      [&](const Deadline& deadline) { return (Access(self->controller).*method)(deadline); });
    });
}

/// Like defineCall(), with poses and joint values as arrays.
template <class Access, class Method>
void defineNumbers(ControllerClass& cls, const char* name, Method method) {
    cls.def(name, [method](const SharedController& self, const Seconds& seconds) -> Six {
        return waited(seconds,
                      [&](const Deadline& deadline) { return (Access(self->controller).*method)(deadline); })
            .array();
    });
}

void defineSettings(ControllerClass& cls) {
    cls.def("set_target_payload", [](const SharedController& self, double mass, const Three& cog,
                                     const Six& inertia, const Seconds& seconds) {
        waited(seconds, [&](const Deadline& deadline) {
            return ToolSetup(self->controller).setTargetPayload(mass, vectorOf(cog), inertia, deadline);
        });
    });
    cls.def("set_gravity", [](const SharedController& self, const Three& direction, const Seconds& seconds) {
        waited(seconds, [&](const Deadline& deadline) {
            return ToolSetup(self->controller).setGravity(vectorOf(direction), deadline);
        });
    });
    cls.def("use_external_sensor", [](const SharedController& self, double mass, const Three& offset,
                                      const Three& cog, const Seconds& seconds) {
        const ExternalSensor sensor{mass, vectorOf(offset), vectorOf(cog)};
        waited(seconds, [&](const Deadline& deadline) {
            return ToolSetup(self->controller).useExternalSensor(sensor, deadline);
        });
    });
    defineCall<ToolSetup>(cls, "use_own_sensor", &ToolSetup::useOwnSensor);
    cls.def("set_external_wrench", [](const SharedController& self, const Six& wrench) {
        taken(ToolSetup(self->controller).setExternalWrench(wrenchOf(wrench)));
    });
    cls.def("set_watchdog", [](const SharedController& self, double minFrequency, const Seconds& seconds) {
        waited(seconds, [&](const Deadline& deadline) {
            return ToolSetup(self->controller).setWatchdog(minFrequency, deadline);
        });
    });
    cls.def("kick_watchdog",
            [](const SharedController& self) { taken(ToolSetup(self->controller).kickWatchdog()); });
    defineCall<ToolSetup>(cls, "trigger_protective_stop", &ToolSetup::triggerProtectiveStop);
    cls.def("set_force_damping", [](const SharedController& self, double damping, const Seconds& seconds) {
        waited(seconds, [&](const Deadline& deadline) {
            return Compliance(self->controller).setForceDamping(damping, deadline);
        });
    });
    cls.def("set_force_gain_scaling",
            [](const SharedController& self, double scaling, const Seconds& seconds) {
                waited(seconds, [&](const Deadline& deadline) {
                    return Compliance(self->controller).setForceGainScaling(scaling, deadline);
                });
            });
}

void defineArmQueries(ControllerClass& cls) {
    cls.def("has_inverse_kinematics", [](const SharedController& self, const Six& pose,
                                         const std::optional<Six>& near, const Seconds& seconds) {
        InverseOptions options;
        if (near) {
            options.near = JointPositions(*near);
        }
        return waited(seconds, [&](const Deadline& deadline) {
            return ArmQueries(self->controller)
                .hasInverseKinematics(Pose::fromArray(pose), options, deadline);
        });
    });
    cls.def("pose_is_within_safety_limits",
            [](const SharedController& self, const Six& pose, const Seconds& seconds) {
                return waited(seconds, [&](const Deadline& deadline) {
                    return ArmQueries(self->controller).isWithinSafetyLimits(Pose::fromArray(pose), deadline);
                });
            });
    cls.def("joints_are_within_safety_limits",
            [](const SharedController& self, const Six& q, const Seconds& seconds) {
                return waited(seconds, [&](const Deadline& deadline) {
                    return ArmQueries(self->controller).isWithinSafetyLimits(JointPositions(q), deadline);
                });
            });
    cls.def("tool_contact", [](const SharedController& self, const Six& direction, const Seconds& seconds) {
        return waited(seconds, [&](const Deadline& deadline) {
            return ArmQueries(self->controller).toolContact(twistOf(direction), deadline);
        });
    });
    cls.def("joint_positions_history", [](const SharedController& self, int steps, const Seconds& seconds) {
        return waited(seconds,
                      [&](const Deadline& deadline) {
                          return ArmQueries(self->controller).jointPositionsHistory(steps, deadline);
                      })
            .array();
    });
    defineNumbers<ArmQueries>(cls, "joint_torques", &ArmQueries::jointTorques);
    defineNumbers<ArmQueries>(cls, "target_waypoint", &ArmQueries::targetWaypoint);
    defineNumbers<ArmQueries>(cls, "tcp_offset", &ArmQueries::tcpOffset);
    defineNumbers<ArmQueries>(cls, "flange_pose", &ArmQueries::flangePose);
    defineCall<ArmQueries>(cls, "is_steady", &ArmQueries::isSteady);
    defineCall<ArmQueries>(cls, "step_time", &ArmQueries::stepTime);
    defineCall<ArmQueries>(cls, "freedrive_status", &ArmQueries::freedriveStatus);
    cls.def("start_contact_detection",
            [](const SharedController& self, const Six& direction, const Seconds& seconds) {
                waited(seconds, [&](const Deadline& deadline) {
                    return Compliance(self->controller).startContactDetection(twistOf(direction), deadline);
                });
            });
    defineCall<Compliance>(cls, "has_contact", &Compliance::hasContact);
    defineCall<Compliance>(cls, "end_contact_detection", &Compliance::endContactDetection);
    cls.def("joint_limits", [](const NativeController& self) {
        const JointLimits limits = self.controller.jointLimits();
        return py::make_tuple(limits.minPosition, limits.maxPosition, limits.maxSpeed);
    });
}

}  // namespace

void defineSetup(ControllerClass& cls) {
    defineSettings(cls);
    defineArmQueries(cls);
    cls.def("begin_pulses", [](const SharedController& self, std::uint32_t mask, std::uint32_t values,
                               double duration, bool held, const Seconds& seconds) {
        const std::chrono::milliseconds milliseconds(
            static_cast<std::int64_t>(std::clamp(duration * 1000 + 0.5, 0.0, 1e9)));
        waited(seconds, [&](const Deadline& deadline) {
            return OutputPulses(self->controller)
                .begin(mask, values, milliseconds, held ? Holding::Held : Holding::Free, deadline);
        });
    });
    cls.def("end_pulses", [](const SharedController& self, std::uint32_t mask, const Seconds& seconds) {
        waited(seconds,
               [&](const Deadline& deadline) { return OutputPulses(self->controller).end(mask, deadline); });
    });
}

}  // namespace tiller::python
