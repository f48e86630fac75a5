// SPDX-License-Identifier: MIT
// Collision check and examination of moves, for tiller/collision.py.

#include "robot/collision/move_check.h"
#include "robot/python/native_objects.h"

namespace tiller::python {

namespace {

using collision::CollisionCheck;
using collision::Contact;
using collision::MoveLimit;

struct NativeCollisionCheck {
    const RobotModel* model;
    Pose tcp;
    std::shared_ptr<const CollisionCheck> check;
};

/// Python type: (name, pose, size).
using BoxRow = std::tuple<std::string, Six, std::array<double, 3>>;
/// Python type: (name, pose).
using PlaneRow = std::tuple<std::string, Six>;

/// Converts to (link, other link or None, name of the object or None, position on the path, joints,
/// distance).
py::object contactTuple(const NativeCollisionCheck& self, const Contact& contact) {
    const collision::Surroundings& around = self.check->surroundings();
    const auto index = static_cast<std::size_t>(contact.other);
    py::object link = py::none();
    py::object name = py::none();
    if (contact.with == Contact::With::Arm) {
        link = py::int_(contact.other);
    } else if (contact.with == Contact::With::Obstacle) {
        name = string(around.obstacles[index].name);
    } else {
        name = string(around.borders[index].name);
    }
    return py::make_tuple(contact.link, link, name, contact.at, contact.q.array(), contact.distance);
}

py::object contactOrNone(const NativeCollisionCheck& self, const std::optional<Contact>& contact) {
    return contact ? contactTuple(self, *contact) : py::none();
}

std::vector<JointPositions> wayOf(const std::vector<Six>& rows) {
    return {rows.begin(), rows.end()};
}

const char* limitName(MoveLimit::Kind kind) {
    switch (kind) {
        case MoveLimit::Kind::OutOfReach:
            return "out_of_reach";
        case MoveLimit::Kind::JointRange:
            return "joint_range";
        case MoveLimit::Kind::Singularity:
            return "singularity";
        case MoveLimit::Kind::NearSingularity:
            return "near_singularity";
        case MoveLimit::Kind::Collision:
            return "collision";
    }
    return "";
}

py::dict examine(const NativeCollisionCheck& self, const Six& start, const Six& target, bool linear,
                 double speed, double acceleration) {
    const auto report = [&] {
        const GilReleased released;
        const collision::Move move{JointPositions(start), JointPositions(target), linear, speed,
                                   acceleration};
        return collision::examineMove(*self.model, *self.check, self.tcp, move, 1.0);
    }();
    py::dict result;
    result["duration"] = report.duration;
    result["limit"] = py::none();
    result["ends"] = false;
    result["fraction"] = 1.0;
    result["joint"] = py::none();
    result["contact"] = py::none();
    if (const auto& limit = report.limit; limit) {
        result["limit"] = limitName(limit->kind);
        result["ends"] = limit->ends();
        result["fraction"] = limit->share;
        if (limit->kind == MoveLimit::Kind::JointRange) {
            result["joint"] = limit->joint;
        }
        if (limit->kind == MoveLimit::Kind::Collision) {
            result["contact"] = contactTuple(self, limit->contact);
        }
    }
    return result;
}

}  // namespace

void defineCollision(py::module_& module) {
    py::class_<NativeCollisionCheck, std::shared_ptr<NativeCollisionCheck>>(module, "CollisionCheck")
        .def(py::init([](const std::string& model, const std::vector<BoxRow>& boxes,
                         const std::vector<PlaneRow>& planes, const Six& tcp, double toolRadius,
                         double safetyDistance) {
                 const RobotModel& arm = robotModel(modelNamed(model));
                 collision::Surroundings around;
                 for (const auto& [name, pose, size] : boxes) {
                     around.obstacles.push_back(
                         {QString::fromStdString(name), Pose::fromArray(pose), {size[0], size[1], size[2]}});
                 }
                 for (const auto& [name, pose] : planes) {
                     around.borders.push_back({QString::fromStdString(name), Pose::fromArray(pose)});
                 }
                 const Pose offset = Pose::fromArray(tcp);
                 const GilReleased released;
                 return std::make_shared<NativeCollisionCheck>(NativeCollisionCheck{
                     &arm, offset,
                     std::make_shared<CollisionCheck>(arm, collision::ToolBody{offset, toolRadius},
                                                      std::move(around), safetyDistance)});
             }),
             py::arg("model"), py::arg("boxes"), py::arg("planes"), py::arg("tcp"), py::arg("tool_radius"),
             py::arg("safety_distance"))
        .def(
            "at",
            [](const NativeCollisionCheck& self, const Six& q) {
                return contactOrNone(self, self.check->at(JointPositions(q)));
            },
            py::arg("q"))
        .def(
            "along",
            [](const NativeCollisionCheck& self, const std::vector<Six>& path) {
                const auto found = [&] {
                    const GilReleased released;
                    return self.check->obstruction(wayOf(path));
                }();
                return contactOrNone(self, found);
            },
            py::arg("path"))
        .def("examine", &examine, py::arg("start"), py::arg("target"), py::arg("linear"), py::arg("speed"),
             py::arg("acceleration"));
    module.def(
        "set_collision_check",
        [](NativeController& controller, const std::shared_ptr<NativeCollisionCheck>& check) {
            controller.controller.setCollisionCheck(check ? check->check : nullptr);
        },
        py::arg("controller"), py::arg("check"));
}

}  // namespace tiller::python
