// SPDX-License-Identifier: MIT
#pragma once

// The Robot API of PolyScope X: action and response for each method and path. Source: Robot API documentation
// and tests of the manufacturer's client library.

#include <QJsonObject>
#include <string>
#include <string_view>

#include "robot/simulator/net/http_message.h"

namespace tiller::simulator {

class ControllerModel;
class ProgramStore;

/// Threads  the simulator thread
class RobotApi {
public:
    RobotApi(ControllerModel& plant, ProgramStore& store) : plant_(plant), store_(store) {}

    /// If a request takes time, the response is delayed until the request is completed. See
    /// HttpResponse::due.
    HttpResponse run(const HttpRequest& request);

private:
    using Handler = HttpResponse (RobotApi::*)(const HttpRequest& request, const std::string& rest);
    struct Route {
        std::string_view method;
        std::string_view path;  ///< path relative to the base; final '*': the handler gets the rest
        Handler handler;
        bool changes = false;   ///< refused in local control
        bool since1012 = true;  ///< true: exists from 10.12 on; false: from 10.11 on
        bool until1012 = false;
    };
    static const Route kRoutes[];
    bool exists(const Route& route) const;

    HttpResponse openApi(const HttpRequest&, const std::string&);
    HttpResponse docs(const HttpRequest&, const std::string&);
    HttpResponse putRobotState(const HttpRequest& request, const std::string&);
    HttpResponse robotMode(const HttpRequest&, const std::string&);
    HttpResponse safetyMode(const HttpRequest&, const std::string&);
    HttpResponse controlMode(const HttpRequest&, const std::string&);
    HttpResponse operationalMode(const HttpRequest&, const std::string&);
    HttpResponse putLoad(const HttpRequest& request, const std::string&);
    HttpResponse putLoaded(const HttpRequest& request, const std::string&);
    HttpResponse loaded(const HttpRequest&, const std::string&);
    HttpResponse putProgramState(const HttpRequest& request, const std::string&);
    HttpResponse programState(const HttpRequest&, const std::string&);
    HttpResponse programs(const HttpRequest&, const std::string&);
    HttpResponse program(const HttpRequest&, const std::string& name);
    HttpResponse postProgram(const HttpRequest& request, const std::string&);
    HttpResponse putProgram(const HttpRequest& request, const std::string&);

    HttpResponse loadProgram(const QJsonObject& body, const char* key);
    HttpResponse play(bool resuming);
    HttpResponse store(const HttpRequest& request, bool mustExist);
    QString loadedName() const;
    const char* stateName() const;

    ControllerModel& plant_;
    ProgramStore& store_;
};

}  // namespace tiller::simulator
