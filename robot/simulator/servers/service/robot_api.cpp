// SPDX-License-Identifier: MIT
#include "robot/simulator/servers/service/robot_api.h"

#include <QDateTime>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>

#include "robot/core/file_reading.h"
#include "robot/simulator/controller/controller_model.h"
#include "robot/simulator/programs/program_runner.h"
#include "robot/simulator/programs/program_store.h"

namespace tiller::simulator {

namespace {

using A = RobotApi;
constexpr std::string_view kBase = "/universal-robots/robot-api";
constexpr SoftwareVersion kTwelve{10, 12, 0, 0};
const QString kDefaultProgram = QStringLiteral("Default program");
const QString kEnding = QStringLiteral(".urpx");

HttpResponse json(const QJsonObject& object, int status = 200) {
    HttpResponse response;
    response.status = status;
    response.body = QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString();
    return response;
}

HttpResponse refuse(int status, const QString& message, const QString& details = {}) {
    QJsonObject body{{QStringLiteral("message"), message}};
    if (!details.isEmpty()) {
        body[QStringLiteral("details")] = details;
    }
    return json(body, status);
}

HttpResponse mode(const QString& name) {
    return json({{QStringLiteral("mode"), name}});
}

std::optional<QJsonObject> bodyOf(const HttpRequest& request) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(request.body));
    return document.isObject() ? std::optional(document.object()) : std::nullopt;
}

HttpResponse invalid(const QString& what) {
    return refuse(422, QStringLiteral("Validation error"), what);
}

/// Returns the description stored in a program file. Handwritten files without nesting may have it at the
/// root.
QJsonObject informationOf(const QJsonObject& root) {
    const QJsonObject program = root.value(QLatin1String("program")).toObject();
    const QString key = QStringLiteral("programInformation");
    return (program.contains(key) ? program : root).value(key).toObject();
}

std::string_view withoutLastSlash(std::string_view path) {
    return path.ends_with('/') ? path.substr(0, path.size() - 1) : path;
}

HttpResponse changed(const char* state, const char* details, std::function<bool()> due) {
    HttpResponse response =
        json({{QStringLiteral("state"), QString::fromLatin1(state)},
              {QStringLiteral("message"), QStringLiteral("Program state changed: ") + QLatin1String(state)},
              {QStringLiteral("details"), QString::fromLatin1(details)}});
    response.due = std::move(due);
    return response;
}

QJsonValue milliseconds(const QDateTime& time) {
    return time.isValid() ? QJsonValue(time.toMSecsSinceEpoch()) : QJsonValue();
}

}  // namespace

const RobotApi::Route RobotApi::kRoutes[] = {
    {"GET", "/openapi.json", &A::openApi, false, false},
    {"GET", "/docs", &A::docs, false, false},
    {"PUT", "/robotstate/v1/state", &A::putRobotState, true, false},
    {"GET", "/robotstate/v1/robotmode", &A::robotMode},
    {"GET", "/robotstate/v1/safetymode", &A::safetyMode},
    {"GET", "/system/v1/controlmode", &A::controlMode},
    {"GET", "/system/v1/operationalmode", &A::operationalMode},
    {"PUT", "/program/v1/load", &A::putLoad, true, false, true},
    {"PUT", "/program/v1/loaded", &A::putLoaded, true},
    {"GET", "/program/v1/loaded", &A::loaded},
    {"PUT", "/program/v1/state", &A::putProgramState, true, false},
    {"GET", "/program/v1/state", &A::programState, false, false},
    {"GET", "/programs/v1/", &A::programs},
    {"GET", "/programs/v1/*", &A::program},
    {"POST", "/programs/v1/", &A::postProgram},
    {"PUT", "/programs/v1/", &A::putProgram},
};

bool RobotApi::exists(const Route& route) const {
    const bool twelve = plant_.options().software >= kTwelve;
    return twelve ? !route.until1012 : !route.since1012;
}

HttpResponse RobotApi::run(const HttpRequest& request) {
    if (!request.path.starts_with(kBase)) {
        return refuse(404, QStringLiteral("Not found"));
    }
    const std::string_view path = std::string_view(request.path).substr(kBase.size());
    const std::string_view method = request.method == "HEAD" ? "GET" : std::string_view(request.method);
    std::string others;
    for (const Route& route : kRoutes) {
        const bool open = route.path.back() == '*';
        const std::string_view fixed = open ? route.path.substr(0, route.path.size() - 1) : route.path;
        const bool matches = open ? path.size() > fixed.size() && path.starts_with(fixed)
                                  : withoutLastSlash(path) == withoutLastSlash(fixed);
        if (!matches || !exists(route)) {
            continue;
        }
        if (route.method != method) {
            others += (others.empty() ? "" : ", ") + std::string(route.method);
            continue;
        }
        if (route.changes && !plant_.isRemoteControl()) {
            return refuse(403, QStringLiteral("Forbidden - Operation Not Allowed"),
                          QStringLiteral("The robot must be in remote mode to do this"));
        }
        return (this->*route.handler)(request, open ? std::string(path.substr(fixed.size())) : std::string());
    }
    if (others.empty()) {
        return refuse(404, QStringLiteral("Not found"));
    }
    HttpResponse response = refuse(405, QStringLiteral("Method not allowed"));
    response.headers.emplace_back("Allow", others);
    return response;
}

// ---- description ----------------------------------------------------------------------------------------

HttpResponse RobotApi::openApi(const HttpRequest&, const std::string&) {
    const bool twelve = plant_.options().software >= kTwelve;
    QJsonObject paths;
    for (const Route& route : kRoutes) {
        if (!exists(route)) {
            continue;
        }
        QString path = QString::fromUtf8(route.path.data(), static_cast<qsizetype>(route.path.size()));
        path.replace('*', QStringLiteral("{name}"));
        QJsonObject methods = paths.value(path).toObject();
        const QString method =
            QString::fromUtf8(route.method.data(), static_cast<qsizetype>(route.method.size())).toLower();
        methods[method] = QJsonObject{
            {QStringLiteral("responses"),
             QJsonObject{{QStringLiteral("200"),
                          QJsonObject{{QStringLiteral("description"), QStringLiteral("done")}}}}}};
        paths[path] = methods;
    }
    return json(
        {{QStringLiteral("openapi"), QStringLiteral("3.1.0")},
         {QStringLiteral("info"), QJsonObject{{QStringLiteral("title"), QStringLiteral("Robot API")},
                                              {QStringLiteral("version"),
                                               twelve ? QStringLiteral("3.1.4") : QStringLiteral("3.0.0")}}},
         {QStringLiteral("servers"),
          QJsonArray{QJsonObject{{QStringLiteral("url"), QString::fromUtf8(kBase.data())}}}},
         {QStringLiteral("paths"), paths}});
}

HttpResponse RobotApi::docs(const HttpRequest&, const std::string&) {
    HttpResponse response;
    response.contentType = "text/plain; charset=utf-8";
    for (const Route& route : kRoutes) {
        if (exists(route)) {
            response.body +=
                std::string(route.method) + ' ' + std::string(kBase) + std::string(route.path) + '\n';
        }
    }
    return response;
}

// ---- robot ----------------------------------------------------------------------------------------------

// The response is sent when the robot has completed the request, because clients then query the new state or
// request the next step at once.
HttpResponse RobotApi::putRobotState(const HttpRequest& request, const std::string&) {
    const auto body = bodyOf(request);
    const QString action = body ? body->value(QLatin1String("action")).toString() : QString();
    const auto done = [&action](std::function<bool()> due) {
        HttpResponse response = json(
            {{QStringLiteral("message"), QStringLiteral("Robot state change requested: %1").arg(action)}});
        response.due = std::move(due);
        return response;
    };
    SafetySystem& safety = plant_.safety();
    const PowerSystem& power = plant_.power();
    if (action == QLatin1String("POWER_ON") || action == QLatin1String("BRAKE_RELEASE")) {
        if (safety.blocksPower() || (!power.isPowered() && power.mode() != RobotMode::PowerOff)) {
            return refuse(409, QStringLiteral("Not possible now"), safetyModeName(safety.mode()));
        }
        if (action == QLatin1String("POWER_ON")) {
            plant_.powerOn();
            return done(
                [&power] { return power.mode() == RobotMode::Idle || power.mode() == RobotMode::Running; });
        }
        plant_.releaseBrakes();
        return done([&power] { return power.mode() == RobotMode::Running; });
    }
    if (action == QLatin1String("POWER_OFF")) {
        plant_.power().powerOff();
        return done([&power] { return power.mode() == RobotMode::PowerOff; });
    }
    if (action == QLatin1String("UNLOCK_PROTECTIVE_STOP")) {
        if (!safety.isProtectiveStopped()) {
            return refuse(409, QStringLiteral("Not possible now"),
                          QStringLiteral("There is no protective stop"));
        }
        safety.unlockProtectiveStop(false);  // no delay: the vendor's client unlocks within one second
        return done([&safety] { return !safety.isProtectiveStopped(); });
    }
    if (action == QLatin1String("RESTART_SAFETY")) {
        plant_.restartSafety();
        return done({});
    }
    return invalid(
        QStringLiteral("action: must be POWER_ON, POWER_OFF, BRAKE_RELEASE, UNLOCK_PROTECTIVE_STOP or "
                       "RESTART_SAFETY"));
}

HttpResponse RobotApi::robotMode(const HttpRequest&, const std::string&) {
    return mode(robotModeName(plant_.power().mode()));
}

HttpResponse RobotApi::safetyMode(const HttpRequest&, const std::string&) {
    const SafetyMode now = plant_.safety().mode();
    const bool emergency =
        plant_.safety().isEmergencyStopped() && now != SafetyMode::Fault && now != SafetyMode::Violation;
    return json({{QStringLiteral("mode"), emergency ? QStringLiteral("EMERGENCY_STOP") : safetyModeName(now)},
                 {QStringLiteral("message"), safetyModeName(plant_.safety().status())}});
}

HttpResponse RobotApi::controlMode(const HttpRequest&, const std::string&) {
    return mode(plant_.isRemoteControl() ? QStringLiteral("REMOTE") : QStringLiteral("LOCAL"));
}

HttpResponse RobotApi::operationalMode(const HttpRequest&, const std::string&) {
    // A mode is always reported. Without a mode selector, programs can run.
    return mode(plant_.safety().operationalMode() == OperationalMode::Manual ? QStringLiteral("MANUAL")
                                                                             : QStringLiteral("AUTOMATIC"));
}

// ---- program --------------------------------------------------------------------------------------------

QString RobotApi::loadedName() const {
    return store_.isLoaded() ? QFileInfo(store_.path()).completeBaseName() : kDefaultProgram;
}

const char* RobotApi::stateName() const {
    const ProgramRunner& runner = plant_.programs();
    return !runner.isFileProgram() ? "STOPPED" : runner.isPaused() ? "PAUSED" : "PLAYING";
}

HttpResponse RobotApi::putLoad(const HttpRequest& request, const std::string&) {
    const auto body = bodyOf(request);
    return body ? loadProgram(*body, "programName")
                : invalid(QStringLiteral("the body is not a JSON object"));
}

HttpResponse RobotApi::putLoaded(const HttpRequest& request, const std::string&) {
    const auto body = bodyOf(request);
    return body ? loadProgram(*body, "name") : invalid(QStringLiteral("the body is not a JSON object"));
}

HttpResponse RobotApi::loadProgram(const QJsonObject& body, const char* key) {
    const QString name = body.value(QLatin1String(key)).toString();
    if (name.isEmpty()) {
        return invalid(QLatin1String(key) + QStringLiteral(": a program's name"));
    }
    const auto done = [&] {
        plant_.programs().stopNow();
        return json({{QString::fromLatin1(key), name},
                     {QStringLiteral("message"), QStringLiteral("Program loaded")}});
    };
    if (name == kDefaultProgram && !QFileInfo::exists(store_.pathOf(name + kEnding))) {
        store_.unload();
        return done();
    }
    const bool exists = !store_.pathOf(name + kEnding).isEmpty();
    const Result<void> loaded = exists ? store_.load(name + kEnding) : Result<void>();
    if (!exists || loaded.error().code == ErrorCode::FileNotReadable) {
        return refuse(404, QStringLiteral("Program not found"), name);
    }
    if (!loaded) {
        const QString why = loaded.error().context;
        plant_.appendToLog(
            QStringLiteral("Error while loading program: %1: %2").arg(name, why).toStdString());
        return refuse(500, QStringLiteral("The program cannot be read"),
                      QStringLiteral("%1: %2").arg(name, why));
    }
    return done();
}

HttpResponse RobotApi::loaded(const HttpRequest&, const std::string&) {
    return json({{QStringLiteral("name"), loadedName()}});
}

HttpResponse RobotApi::play(bool resuming) {
    ProgramRunner& runner = plant_.programs();
    const auto notNow = [](const QString& why) {
        return refuse(409, QStringLiteral("Not possible now"), why);
    };
    if (plant_.power().mode() != RobotMode::Running || !allowsMotion(plant_.safety().mode())) {
        return notNow(QStringLiteral("The robot is not ready to move"));
    }
    const bool paused = runner.isPaused() || runner.state() == RuntimeState::Pausing;
    if (resuming != paused) {
        return notNow(paused ? QStringLiteral("The program is paused")
                             : QStringLiteral("The program is not paused"));
    }
    if (resuming) {
        runner.resume();
        return changed("PLAYING", "Resume successful",
                       [&runner] { return runner.state() == RuntimeState::Playing || !runner.isActive(); });
    }
    if (runner.state() == RuntimeState::Stopping || runner.isStopRequested()) {
        runner.stopNow();
    }
    if (runner.isActive()) {
        return notNow(QStringLiteral("A program is running"));
    }
    // The default program of a controller has no nodes.
    const Result<std::string> text =
        store_.isLoaded() ? store_.script() : Result<std::string>("def Default_program():\nend\n");
    if (!text) {
        plant_.appendToLog("Error while loading program: " + store_.name() + ": " +
                           text.error().context.toStdString());
    }
    if (!text || !runner.submitText(*text)) {
        return notNow(QStringLiteral("The program has errors"));
    }
    return changed("PLAYING", "Play successful",
                   [&runner, before = runner.starts()] { return runner.starts() != before; });
}

HttpResponse RobotApi::putProgramState(const HttpRequest& request, const std::string&) {
    const auto body = bodyOf(request);
    const QString action = body ? body->value(QLatin1String("action")).toString() : QString();
    ProgramRunner& runner = plant_.programs();
    if (action == QLatin1String("play") || action == QLatin1String("resume")) {
        return play(action == QLatin1String("resume"));
    }
    if (action == QLatin1String("pause")) {
        if (runner.state() != RuntimeState::Playing) {
            return refuse(409, QStringLiteral("Not possible now"), QStringLiteral("No program is playing"));
        }
        runner.pause();
        return changed("PAUSED", "Pause successful",
                       [&runner] { return runner.isPaused() || !runner.isActive(); });
    }
    if (action == QLatin1String("stop")) {
        runner.requestStop();
        return changed("STOPPED", "Stop successful",
                       [&runner] { return !runner.isActive() && !runner.isStopRequested(); });
    }
    return invalid(QStringLiteral("action: play, pause, resume or stop"));
}

HttpResponse RobotApi::programState(const HttpRequest&, const std::string&) {
    return json({{QStringLiteral("state"), QString::fromLatin1(stateName())}});
}

// ---- programs -------------------------------------------------------------------------------------------

HttpResponse RobotApi::programs(const HttpRequest&, const std::string&) {
    QJsonArray all;
    for (const QString& fileName : store_.list(kEnding)) {
        const QFileInfo file(store_.pathOf(fileName));
        const QJsonValue changed = milliseconds(file.lastModified());
        const QDateTime born = file.birthTime();
        QJsonObject entry{{QStringLiteral("createdDate"), born.isValid() ? milliseconds(born) : changed},
                          {QStringLiteral("description"), QString()},
                          {QStringLiteral("lastModifiedDate"), changed},
                          {QStringLiteral("lastSavedDate"), changed},
                          {QStringLiteral("name"), file.completeBaseName()},
                          {QStringLiteral("programState"), QStringLiteral("FINAL")}};
        if (const auto content = readWholeFile(file.filePath(), kLargestProgram)) {
            const QJsonObject own = informationOf(QJsonDocument::fromJson(*content).object());
            for (const char* key :
                 {"createdDate", "description", "lastModifiedDate", "lastSavedDate", "programState"}) {
                if (own.contains(QLatin1String(key))) {
                    entry[QLatin1String(key)] = own.value(QLatin1String(key));
                }
            }
        }
        all.append(entry);
    }
    return json({{QStringLiteral("programs"), all}, {QStringLiteral("message"), QJsonValue()}});
}

HttpResponse RobotApi::program(const HttpRequest&, const std::string& name) {
    const QString path = store_.pathOf(QString::fromStdString(name) + kEnding);
    const auto content = path.isEmpty() ? std::nullopt : std::optional(readWholeFile(path, kLargestProgram));
    if (!content || !*content) {
        return refuse(404, QStringLiteral("Program not found"), QString::fromStdString(name));
    }
    HttpResponse response;
    response.body = (*content)->toStdString();
    return response;
}

HttpResponse RobotApi::postProgram(const HttpRequest& request, const std::string&) {
    return store(request, false);
}

HttpResponse RobotApi::putProgram(const HttpRequest& request, const std::string&) {
    return store(request, true);
}

HttpResponse RobotApi::store(const HttpRequest& request, bool mustExist) {
    const auto file = fileOfForm(request.header("content-type"), request.body, "file");
    if (!file) {
        return invalid(QStringLiteral("file: missing; send the program as multipart/form-data"));
    }
    const QByteArray content = QByteArray::fromStdString(file->content);
    const QJsonDocument document = QJsonDocument::fromJson(content);
    if (!document.isObject()) {
        return refuse(400, QStringLiteral("Bad upload"), QStringLiteral("the file is not a program (JSON)"));
    }
    // The name in the program overrides the file name.
    const QJsonObject root = document.object();
    QString name = informationOf(root).value(QLatin1String("name")).toString();
    name = name.isEmpty() ? root.value(QLatin1String("name")).toString() : name;
    name = name.isEmpty() ? QFileInfo(QString::fromStdString(file->fileName)).completeBaseName() : name;
    const QString path = store_.pathOf(name + kEnding);
    const bool exists = !path.isEmpty() && QFileInfo::exists(path);
    if (mustExist && !exists) {
        return refuse(404, QStringLiteral("Program not found"), name);
    }
    if (!mustExist && exists) {
        return refuse(400, QStringLiteral("The program already exists"), name);
    }
    if (mustExist && store_.isLoaded() && loadedName() == name) {
        return refuse(409, QStringLiteral("The program is loaded"), name);
    }
    if (!store_.save(name + kEnding, content)) {
        return refuse(400, QStringLiteral("Bad upload"), QStringLiteral("'%1' cannot be stored").arg(name));
    }
    return json({{QStringLiteral("programName"), name}});
}

}  // namespace tiller::simulator
