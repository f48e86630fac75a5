// SPDX-License-Identifier: MIT
#include "robot/simulator/faults.h"

#include <QStringList>
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "robot/core/angles.h"
#include "robot/simulator/controller_services.h"
#include "robot/simulator/host/script_host.h"
#include "robot/simulator/programs/program_runner.h"

namespace tiller::simulator {

namespace {

/// Arguments of a fault line. Keeps the first error, which is reported once at the end.
class Words {
public:
    explicit Words(const QStringList& words) : words_(words) {}

    bool has() const { return next_ < words_.size(); }
    QString word() { return has() ? words_[next_++] : complain(QStringLiteral("an argument is missing")); }
    QString peek() const { return words_.value(next_); }
    QString rest() { return words_.mid(std::exchange(next_, words_.size())).join(' '); }
    bool choice(const char* yes, const char* no) {
        const QString given = word();
        if (given != QLatin1String(yes) && given != QLatin1String(no)) {
            complain(QStringLiteral("expected %2 or %3, not '%1'")
                         .arg(given, QLatin1String(yes), QLatin1String(no)));
        }
        return given == QLatin1String(yes);
    }
    bool on() { return choice("on", "off"); }
    double number(double least, double most) {
        const QString given = word();
        bool ok = false;
        const double value = given.toDouble(&ok);
        if (!ok || !(value >= least && value <= most)) {
            complain(QStringLiteral("'%1' is not a number from %2 to %3").arg(given).arg(least).arg(most));
            return least;
        }
        return value;
    }
    double numberOr(double otherwise, double least, double most) {
        return has() ? number(least, most) : otherwise;
    }
    int integer(int least, int most) {
        const double value = number(least, most);
        if (value != static_cast<int>(value)) {
            complain(QStringLiteral("%1 is not a whole number").arg(value));
        }
        return static_cast<int>(value);
    }
    QString complain(const QString& what) {
        if (complaint_.isEmpty()) {
            complaint_ = what;
        }
        return {};
    }
    QString complaint() {
        return complaint_.isEmpty() && has() ? QStringLiteral("unexpected argument '%1'").arg(words_[next_])
                                             : complaint_;
    }
    bool good() { return complaint().isEmpty(); }
    /// True if there is no error so far; more arguments may follow.
    bool goodSoFar() const { return complaint_.isEmpty(); }

private:
    QStringList words_;
    qsizetype next_ = 0;
    QString complaint_;
};

struct Verb {
    const char* name;
    const char* arguments;
    const char* help;
    /// Reads all words first and acts only if good() returns true.
    QString (*run)(ControllerServices& controlBox, Words& words);
};

constexpr double kMilli = 1e-3;
constexpr double kPercent = 100;

template <SafetySystem::Input input>
QString safetyInput(ControllerServices& controlBox, Words& words) {
    const bool active = words.on();
    if (words.good()) {
        controlBox.plant.safety().set(input, active);
    }
    return {};
}

template <class Change>
QString changeLink(ControllerServices& controlBox, Words& words, Change change) {
    LinkConditions conditions = controlBox.services.link().conditions();
    change(conditions, words);
    if (words.good()) {
        controlBox.services.link().set(conditions);
    }
    return {};
}

QString changeDevice(ControllerServices& controlBox, Words& words) {
    using Presence = DeviceServer::Presence;
    DeviceServer* const device = controlBox.services.device(words.word());
    const QString wanted = words.word();
    const Presence presence = wanted == QLatin1String("refuses")  ? Presence::Refuses
                              : wanted == QLatin1String("silent") ? Presence::Silent
                                                                  : Presence::Answers;
    if (words.goodSoFar() && device == nullptr) {
        words.complain(QStringLiteral("there is no device with this name"));
    } else if (presence == Presence::Answers && wanted != QLatin1String("answers")) {
        words.complain(QStringLiteral("expected answers, refuses or silent, not '%1'").arg(wanted));
    }
    if (words.good()) {
        if (const Result<void> done = controlBox.services.setPresence(*device, presence); !done) {
            words.complain(done.error().context);
        }
    }
    return {};
}

QString holdRegisters(ControllerServices& controlBox, Words& words) {
    const QString given = words.word();
    if (!words.good()) {
        return {};
    }
    QStringList names;
    if (given == QLatin1String("lower") || given == QLatin1String("upper")) {
        const int first = given == QLatin1String("lower") ? 0 : 24;
        for (int i = first; i < first + 24; ++i) {
            names << QStringLiteral("input_int_register_%1").arg(i)
                  << QStringLiteral("input_double_register_%1").arg(i);
        }
    } else {
        names = given.split(',', Qt::SkipEmptyParts);
    }
    if (!controlBox.services.rtde().holdInputs(names)) {
        words.complain(QStringLiteral("some of these inputs do not exist or are in use"));
    }
    return {};
}

QString jointNearLimit(ControllerServices& controlBox, Words& words) {
    const int joint = words.integer(1, kJointCount);
    const double margin = toRadians(words.numberOr(1.0, -10.0, 360.0));
    if (words.good()) {
        controlBox.plant.programs().stopNow();
        JointPositions q = controlBox.plant.arm().state().actualQ;
        q[joint - 1] = kJointPositionLimit - margin;
        controlBox.plant.arm().setJointPositions(q);
        controlBox.plant.safety().set(SafetySystem::Input::Recovery, margin < 0);
    }
    return {};
}

QString hand(ControllerServices& controlBox, Words& words) {
    Vector6 wrench = Vector6::Zero();
    for (int i = 0; i < 6; ++i) {
        wrench[i] = i < 3 ? words.number(-1e4, 1e4) : words.numberOr(0, -1e4, 1e4);
    }
    if (words.good()) {
        controlBox.plant.arm().environment().setHandWrench(Wrench::fromVector(wrench));
    }
    return {};
}

constexpr double kFar = 10;  ///< maximum coordinate in a fault line [m]

QString plane(ControllerServices& controlBox, Words& words) {
    arm::ContactPlane plane;
    plane.point.z() = words.number(-kFar, kFar);
    if (words.good() && !controlBox.plant.arm().environment().addPlane(plane)) {
        words.complain(QStringLiteral(
            "the maximum number of planes is reached; 'no-surfaces' removes all planes and boxes"));
    }
    return {};
}

QString box(ControllerServices& controlBox, Words& words) {
    arm::ContactBox box;
    for (int i = 0; i < 3; ++i) {
        box.T_base_box.position[i] = words.number(-kFar, kFar);
    }
    for (int i = 0; i < 3; ++i) {
        box.size[i] = words.number(0.001, kFar);
    }
    if (words.good() && !controlBox.plant.arm().environment().addBox(box)) {
        words.complain(QStringLiteral(
            "the maximum number of boxes is reached; 'no-surfaces' removes all planes and boxes"));
    }
    return {};
}

QString load(ControllerServices& controlBox, Words& words) {
    std::optional<arm::Payload> carried;
    if (words.peek() == QLatin1String("none")) {
        words.word();
    } else {
        carried.emplace();
        carried->mass = words.number(0, 1000);
        for (int i = 0; i < 3; ++i) {
            carried->centreOfGravity[i] = words.numberOr(0, -kFar, kFar);
        }
    }
    if (words.good()) {
        controlBox.plant.arm().environment().setLoad(carried);
    }
    return {};
}

QString conveyor(ControllerServices& controlBox, Words& words) {
    const int encoder = words.integer(0, 1);
    const double speed = words.number(-1e6, 1e6);
    if (words.good()) {
        controlBox.plant.arm().environment().setConveyorSpeed(encoder, speed);
    }
    return {};
}

QString answer(ControllerServices& controlBox, Words& words) {
    using urscript::RequestedType;
    ScriptHost& host = controlBox.plant.scriptHost();
    const auto asked = host.asked();
    if (!asked) {
        words.complain(QStringLiteral("no program is requesting a value"));
        return {};
    }
    urscript::RequestAnswer value;
    switch (*asked) {
        case RequestedType::Boolean:
            value = words.choice("true", "false");
            break;
        case RequestedType::Integer:
            value = std::int32_t{words.integer(std::numeric_limits<std::int32_t>::min(),
                                               std::numeric_limits<std::int32_t>::max())};
            break;
        case RequestedType::Float:
            value = words.number(-1e300, 1e300);
            break;
        case RequestedType::String:
            value = words.rest().toStdString();
            break;
    }
    if (words.good()) {
        host.answerRequest(value);
    }
    return {};
}

/// Reads all remaining words, at least one.
std::vector<std::int32_t> modbusValues(Words& words) {
    std::vector<std::int32_t> values;
    do {
        const QString given = words.peek();
        const bool word = given == QLatin1String("on") || given == QLatin1String("off");
        values.push_back(word ? (words.on() ? 1 : 0) : words.integer(0, 65535));
    } while (words.has() && words.goodSoFar());
    return values;
}

QString modbusMemory(ControllerServices& controlBox, Words& words) {
    using Kind = ModbusDevice::Kind;
    static const std::pair<const char*, Kind> kKinds[] = {{"input", Kind::Input},
                                                          {"coil", Kind::Coil},
                                                          {"input-register", Kind::InputRegister},
                                                          {"register", Kind::Register}};
    const QString given = words.word();
    const auto kind = std::ranges::find_if(
        kKinds, [&given](const auto& entry) { return given == QLatin1String(entry.first); });
    if (kind == std::end(kKinds)) {
        words.complain(
            QStringLiteral("expected input, coil, input-register or register, not '%1'").arg(given));
        return {};
    }
    const int address = words.integer(0, 65535);
    const std::vector<std::int32_t> values = modbusValues(words);
    if (words.good()) {
        controlBox.plant.scriptHost().modbus().write(kind->second, address, values);
    }
    return {};
}

void complainOf(const Result<void>& outcome, Words& words) {
    if (!outcome) {
        words.complain(outcome.error().controllerMessage);
    }
}

QString modbusSignal(ControllerServices& controlBox, Words& words) {
    const std::string name = words.word().toStdString();
    const std::vector<std::int32_t> values = modbusValues(words);
    if (words.good()) {
        complainOf(controlBox.plant.scriptHost().modbus().writeSignal(name, values), words);
    }
    return {};
}

QString modbusError(ControllerServices& controlBox, Words& words) {
    const std::string name = words.word().toStdString();
    const int code = words.integer(0, 255);
    if (words.good()) {
        complainOf(controlBox.plant.scriptHost().modbus().setDeviceError(name, code), words);
    }
    return {};
}

QString operationalMode(ControllerServices& controlBox, Words& words) {
    const QString mode = words.word();
    const bool manual = mode == QLatin1String("manual");
    const bool automatic = mode == QLatin1String("automatic");
    if (!manual && !automatic && mode != QLatin1String("none")) {
        words.complain(QStringLiteral("expected manual, automatic or none, not '%1'").arg(mode));
    }
    if (words.good()) {
        controlBox.plant.safety().setOperationalMode(manual      ? OperationalMode::Manual
                                                     : automatic ? OperationalMode::Automatic
                                                                 : OperationalMode::None);
    }
    return {};
}

QString status(ControllerServices& controlBox, Words&) {
    const Telemetry& t = controlBox.plant.telemetry();
    const LinkConditions& link = controlBox.services.link().conditions();
    return QStringLiteral(
               "robot_mode=%1 safety_mode=%2 runtime_state=%3 remote=%4 timestamp=%5 silence=%6 link=%7 "
               "delay=%8 "
               "jitter=%9 split=%10 coalesce=%11 half_open=%12 drop=%13")
        .arg(robotModeName(t.robotMode), safetyModeName(t.safetyMode), runtimeStateName(t.runtimeState))
        .arg(controlBox.plant.isRemoteControl() ? "yes" : "no")
        .arg(t.timestamp, 0, 'f', 3)
        .arg(controlBox.silent ? "on" : "off", link.lost ? "lost" : "up")
        .arg(link.delay / kMilli)
        .arg(link.jitter / kMilli)
        .arg(link.splitAt)
        .arg(link.coalesce / kMilli)
        .arg(controlBox.services.link().buried())
        .arg(link.drop * kPercent);
}

QString clear(ControllerServices& controlBox, Words& words) {
    if (words.good()) {
        controlBox.services.link().set({});
        controlBox.services.link().unbury();
        controlBox.services.rtde().releaseHeldInputs();
        controlBox.services.rtde().setMaxClients(std::numeric_limits<std::size_t>::max());
        controlBox.silent = false;
        controlBox.plant.setCalibrationError(0);
    }
    return {};
}

using Input = SafetySystem::Input;

// clang-format off
const Verb kVerbs[] = {
    {"protective-stop", "[CODE [JOINT]]", "the controller stops the arm (error code, default 157: collision; joint 1 to 6)",
     [](ControllerServices& m, Words& w) {
         constexpr double kCollision = 157;
         const auto code = static_cast<std::int32_t>(w.numberOr(kCollision, 0, 9999));
         const int joint = w.has() ? w.integer(1, kJointCount) : 0;
         if (w.good()) { m.plant.protectiveStop({code, joint, primary::ReportLevel::Warning, ""}); }
         return QString(); }},
    {"emergency-stop", "on|off", "the emergency stop button of the teach pendant", &safetyInput<Input::RobotEmergencyStop>},
    {"system-emergency-stop", "on|off", "the external emergency stop input", &safetyInput<Input::SystemEmergencyStop>},
    {"safeguard", "on|off", "on: the safeguard input is open", &safetyInput<Input::Safeguard>},
    {"automatic-safeguard", "on|off", "on: the safeguard input of mode AUTOMATIC is open", &safetyInput<Input::AutomaticModeSafeguard>},
    {"enabling-device", "off|on", "on: the three-position device is released, which stops the arm in MANUAL", &safetyInput<Input::ThreePositionEnabling>},
    {"reduced", "on|off", "the reduced-mode input", &safetyInput<Input::Reduced>},
    {"recovery", "on|off", "a joint outside its safety limits", &safetyInput<Input::Recovery>},
    {"violation", "", "a safety limit is violated: power off, requires a restart of the safety system",
     [](ControllerServices& m, Words& w) { if (w.good()) { m.plant.safety().violation(); } return QString(); }},
    {"fault", "", "the safety system finds a fault: power off, requires a restart of the safety system",
     [](ControllerServices& m, Words& w) { if (w.good()) { m.plant.safety().fault(); } return QString(); }},
    {"power-loss", "", "the power supply of the arm fails",
     [](ControllerServices& m, Words& w) { if (w.good()) { m.plant.losePower(); } return QString(); }},
    {"restart", "[SECONDS] [unconfirmed]", "the controller restarts, which takes SECONDS (default 20); unconfirmed: waits in CONFIRM_SAFETY",
     [](ControllerServices& m, Words& w) {
         const double seconds = w.numberOr(20, 0, 3600);
         const bool unconfirmed = w.has() && w.choice("unconfirmed", "confirmed");
         if (w.good()) { m.plant.restart(seconds, unconfirmed); m.services.closeClients(); }
         return QString(); }},
    {"confirm-safety", "", "the operator confirms the safety configuration",
     [](ControllerServices& m, Words& w) { if (w.good()) { m.plant.power().confirmSafety(); } return QString(); }},
    {"backdrive", "on|off", "moves joints by hand with the brakes overridden; requires IDLE",
     [](ControllerServices& m, Words& w) { const bool on = w.on(); if (w.good()) { m.plant.setBackdrive(on); } return QString(); }},
    {"script-error", "[TEXT]", "the running program fails with a runtime exception",
     [](ControllerServices& m, Words& w) {
         const QString text = w.has() ? w.rest() : QStringLiteral("injected_runtime_error");
         m.plant.failProgram(text.toStdString());
         return QString(); }},
    {"popup", "TEXT", "a popup on the teach pendant, which blocks `play`",
     [](ControllerServices& m, Words& w) {
         const QString text = w.has() ? w.rest() : w.word();
         if (w.good()) { m.plant.showPopup(text.toStdString(), true); }
         return QString(); }},
    {"close-popup", "", "presses the button of the newest popup",
     [](ControllerServices& m, Words& w) { if (w.good()) { m.plant.popups().closeNewest(); } return QString(); }},
    {"answer", "VALUE", "answers a request of a program to primary clients: true|false, a number or text", &answer},
    {"hold-registers", "lower|upper|NAME,NAME...", "another client owns these RTDE inputs", &holdRegisters},
    {"release-registers", "", "releases the inputs of 'hold-registers'",
     [](ControllerServices& m, Words& w) { if (w.good()) { m.services.rtde().releaseHeldInputs(); } return QString(); }},
    {"link", "lost|back", "unplugs the cable, or plugs it in again: no data are transferred, connections stay open",
     [](ControllerServices& m, Words& w) { return changeLink(m, w, [](LinkConditions& c, Words& r) { c.lost = r.choice("lost", "back"); }); }},
    {"silence", "on|off", "an unresponsive controller: time continues, nothing is read or sent",
     [](ControllerServices& m, Words& w) { const bool on = w.on(); if (w.good()) { m.silent = on; } return QString(); }},
    {"delay", "MS [JITTER]", "delay in each direction, plus a random jitter [ms]; 0: no delay",
     [](ControllerServices& m, Words& w) { return changeLink(m, w, [](LinkConditions& c, Words& r) {
         c.delay = r.number(0, 60'000) * kMilli; c.jitter = r.numberOr(0, 0, 60'000) * kMilli; }); }},
    {"split", "BYTES", "data arrive in two parts, the first with this number of bytes; 0: not split",
     [](ControllerServices& m, Words& w) { return changeLink(m, w, [](LinkConditions& c, Words& r) {
         c.splitAt = static_cast<std::size_t>(r.integer(0, 65'536)); }); }},
    {"coalesce", "MS", "data sent within this time [ms] arrive together; 0: no effect",
     [](ControllerServices& m, Words& w) { return changeLink(m, w, [](LinkConditions& c, Words& r) {
         c.coalesce = r.number(0, 60'000) * kMilli; }); }},
    {"drop", "PERCENT", "this percentage of the RTDE data packets is not sent, as on an overloaded controller; 0: none",
     [](ControllerServices& m, Words& w) { return changeLink(m, w, [](LinkConditions& c, Words& r) {
         c.drop = r.number(0, 100) / kPercent; }); }},
    {"half-open", "", "the controller drops all connections without notifying the clients",
     [](ControllerServices& m, Words& w) {
         if (w.good()) {
             m.services.link().setForgetting(true);
             m.services.closeClients();
             m.services.link().setForgetting(false);
         }
         return QString(); }},
    {"rtde-clients", "MAXIMUM", "the RTDE server closes further connections; existing connections stay open",
     [](ControllerServices& m, Words& w) {
         const int most = w.integer(0, 1000);
         if (w.good()) { m.services.rtde().setMaxClients(static_cast<std::size_t>(most)); }
         return QString(); }},
    {"close-clients", "", "closes all connections, and notifies the clients",
     [](ControllerServices& m, Words& w) { if (w.good()) { m.services.closeClients(); } return QString(); }},
    {"joint-near-limit", "JOINT [DEGREES]", "moves a joint (1 to 6) to this distance from the end of its range (default 1); below 0: beyond the range, in RECOVERY", &jointNearLimit},
    {"calibration", "SIZE", "the reported kinematics deviate from the arm by up to SIZE mm and mrad; 0: no deviation",
     [](ControllerServices& m, Words& w) { const double size = w.number(0, 1000); if (w.good()) { m.plant.setCalibrationError(size); } return QString(); }},
    {"remote", "on|off", "the Local/Remote switch of the teach pendant",
     [](ControllerServices& m, Words& w) { const bool on = w.on(); if (w.good()) { m.setRemoteControl(on); } return QString(); }},
    {"operational-mode", "manual|automatic|none", "", &operationalMode},
    {"freedrive-button", "on|off", "",
     [](ControllerServices& m, Words& w) { const bool on = w.on(); if (w.good()) { m.plant.setFreedriveButton(on); } return QString(); }},
    {"digital-input", "NUMBER on|off", "0-7 standard, 8-15 configurable, 16-17 tool",
     [](ControllerServices& m, Words& w) {
         const int pin = w.integer(0, kDigitalPins - 1);
         const bool on = w.on();
         if (w.good()) { Pins::setBit(m.plant.pins().digitalInputs, pin, on); }
         return QString(); }},
    {"speed", "FRACTION", "the speed slider, 0 to 1",
     [](ControllerServices& m, Words& w) { const double f = w.number(0, 1); if (w.good()) { m.plant.setSpeedSlider(f); } return QString(); }},
    {"hand", "FX FY FZ [TX TY TZ]", "a hand pushes the tool [N, Nm], base frame; zeros end the push", &hand},
    {"plane", "HEIGHT", "adds a horizontal surface at this height [m], base frame", &plane},
    {"box", "X Y Z SX SY SZ", "adds a box with its centre at this point [m], base frame, and with these edge lengths", &box},
    {"no-surfaces", "", "removes all planes and boxes",
     [](ControllerServices& m, Words& w) { if (w.good()) { m.plant.arm().environment().clearSurfaces(); } return QString(); }},
    {"load", "KG [X Y Z]|none", "actual load of the tool and its centre [m], flange frame; none: the payload of the controller", &load},
    {"conveyor", "0|1 TICKS", "speed of this encoder in ticks per second", &conveyor},
    {"gripper-object", "POSITION|none", "an object between the gripper fingers stops the fingers at this position, 0 to 255",
     [](ControllerServices& m, Words& w) {
         const QString given = w.word();
         bool ok = false;
         const int position = given.toInt(&ok);
         if (given != QLatin1String("none") && (!ok || position < 0 || position > 255)) {
             w.complain(QStringLiteral("expected none or a position from 0 to 255, not '%1'").arg(given)); }
         if (w.good()) { m.services.gripper().setObject(ok ? std::optional(position) : std::nullopt); }
         return QString(); }},
    {"modbus-signal", "NAME VALUE...", "value of a signal that a program added to the simulated Modbus device: 0 to 65535, on, off", &modbusSignal},
    {"modbus-memory", "KIND ADDRESS VALUE...", "value at an address of the Modbus device; KIND: input, coil, input-register or register", &modbusMemory},
    {"modbus-error", "NAME CODE", "error code of the device for this signal: 0 no error, 1 illegal function, 2 illegal address, 3 illegal value, 4 failure, 6 busy", &modbusError},
    {"modbus-link", "on|off", "off: the Modbus device cannot be reached",
     [](ControllerServices& m, Words& w) { const bool on = w.on(); if (w.good()) { m.plant.scriptHost().modbus().setConnected(on); } return QString(); }},
    {"device", "NAME answers|refuses|silent", "a device of --device: answers, refuses connections, or accepts connections without answering", &changeDevice},
    {"assume", "NAME=VALUE", "changes an assumption of the running controller; see 'tiller-cli simulate --assume help'",
     [](ControllerServices& m, Words& w) {
         const QString words = w.word();
         if (w.good()) {
             if (const Result<void> done = assume(m.plant.assumptions(), words); !done) { w.complain(done.error().context); } }
         return QString(); }},
    {"status", "", "shows the current modes and faults", &status},
    {"clear", "", "ends the faults silence, link, delay, split, coalesce, drop and rtde-clients, held registers and calibration errors", &clear},
};
// clang-format on

}  // namespace

Result<QString> injectFault(ControllerServices& controlBox, const QString& line) {
    QStringList words = line.simplified().split(' ', Qt::SkipEmptyParts);
    if (words.isEmpty()) {
        return Error{ErrorCode::InvalidArgument,
                     QStringLiteral("the name of the fault is missing; 'help' lists all faults"),
                     {}};
    }
    const QString name = words.takeFirst();
    if (name == QLatin1String("help")) {
        return faultHelp();
    }
    for (const Verb& verb : kVerbs) {
        if (name != QLatin1String(verb.name)) {
            continue;
        }
        Words given(words);
        const QString answer = verb.run(controlBox, given);
        if (!given.good()) {
            return Error{ErrorCode::InvalidArgument,
                         QStringLiteral("%1: %2; usage: %1 %3")
                             .arg(name, given.complaint(), QLatin1String(verb.arguments)),
                         {}};
        }
        return answer;
    }
    return Error{ErrorCode::InvalidArgument,
                 QStringLiteral("'%1' is not a known fault; 'help' lists all faults").arg(name),
                 {}};
}

std::string answerFaultLine(ControllerServices& controlBox, std::string_view line) {
    const Result<QString> done =
        injectFault(controlBox, QString::fromUtf8(line.data(), static_cast<qsizetype>(line.size())));
    if (!done) {
        return "error: " + done.error().context.toStdString() + '\n';
    }
    return done->isEmpty() ? "ok\n" : "ok " + done->toStdString() + '\n';
}

QString faultHelp() {
    QString text;
    for (const Verb& verb : kVerbs) {
        const QString usage =
            QStringLiteral("%1 %2").arg(QLatin1String(verb.name), QLatin1String(verb.arguments));
        text += QStringLiteral("  %1 %2\n").arg(usage, -40).arg(QLatin1String(verb.help));
    }
    return text;
}

}  // namespace tiller::simulator
