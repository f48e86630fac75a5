// SPDX-License-Identifier: MIT
#include "robot/dashboard/robot_service.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QVersionNumber>
#include <utility>

namespace tiller::dashboard {

namespace {

class DashboardService : public RobotService {
public:
    explicit DashboardService(std::unique_ptr<DashboardClient> client) : client_(std::move(client)) {}

    ServiceKind kind() const override { return ServiceKind::Dashboard; }
    bool isConnected() override { return client_->checkConnection(); }

    Result<void> perform(RobotCommand command, const Deadline& deadline) override {
        switch (command) {
            case RobotCommand::PowerOn:
                return client_->powerOn(deadline);
            case RobotCommand::ReleaseBrakes:
                return client_->brakeRelease(deadline);
            case RobotCommand::PowerOff:
                return client_->powerOff(deadline);
            case RobotCommand::RestartSafety:
                return client_->restartSafety(deadline);
            case RobotCommand::ClosePopups: {
                Result<void> closed = client_->closePopup(deadline);
                return closed ? client_->closeSafetyPopup(deadline) : closed;
            }
            case RobotCommand::Play:
                return client_->play(deadline);
            case RobotCommand::Pause:
                return client_->pause(deadline);
            case RobotCommand::StopProgram:
                return client_->stop(deadline);
        }
        return Error{ErrorCode::Internal, QStringLiteral("unknown command"), {}};
    }
    Result<void> unlockProtectiveStop(const Deadline& deadline) override {
        return client_->unlockProtectiveStop(deadline);
    }
    Result<void> loadProgram(const Text& name, const Deadline& deadline) override {
        return client_->loadProgram(name, deadline);
    }
    Result<QStringList> programs(const Deadline&) override {
        return Error{ErrorCode::VersionUnsupported, QStringLiteral("list the programs"), {}};
    }
    Result<ServiceReport> look(const Deadline& deadline) override {
        if (!cb3_) {
            const Result<SoftwareVersion> version = client_->polyscopeVersion(deadline);
            if (!version) {
                return version.error();
            }
            cb3_ = version->isCb3();
        }
        ServiceReport report;
        report.kind = kind();
        if (!*cb3_) {  // CB3 has no remote control switch
            const Result<bool> remote = client_->isInRemoteControl(deadline);
            if (!remote && remote.error().code != ErrorCode::Rejected) {
                return remote.error();
            }
            if (remote) {  // not supported before 5.6
                report.remoteControl = *remote;
            }
            if (const auto mode = client_->command(QStringLiteral("get operational mode"), deadline)) {
                // Other replies mean that no mode is set, or that the software does not support operational
                // modes.
                const QString word = mode->trimmed().toUpper();
                if (word == QLatin1String("MANUAL") || word == QLatin1String("AUTOMATIC")) {
                    report.operationalMode = word;
                }
            }
        }
        if (const auto program = client_->programState(deadline)) {
            report.program = program->program;
            report.programIsStopped = program->run == ProgramState::Run::Stopped;
        }
        return report;
    }

private:
    std::unique_ptr<DashboardClient> client_;
    std::optional<bool> cb3_;
};

class RobotApiService : public RobotService {
public:
    RobotApiService(const ServiceAddress& address, QVersionNumber version)
        : client_(address.host, address.robotApiPort), version_(std::move(version)) {}

    ServiceKind kind() const override { return ServiceKind::RobotApi; }
    bool isConnected() override { return !gone_; }

    Result<void> perform(RobotCommand command, const Deadline& deadline) override {
        switch (command) {
            case RobotCommand::PowerOn:
                return noted(client_.powerOn(deadline));
            case RobotCommand::ReleaseBrakes:
                return noted(client_.brakeRelease(deadline));
            case RobotCommand::PowerOff:
                return noted(client_.powerOff(deadline));
            case RobotCommand::RestartSafety:
                return noted(client_.restartSafety(deadline));
            case RobotCommand::ClosePopups:
                return Error{ErrorCode::VersionUnsupported, QStringLiteral("close popups"), {}};
            case RobotCommand::Play: {
                // The Robot API does not accept "play" for a paused program.
                const auto state = client_.programState(deadline);
                const bool paused = state && *state == ProgramState::Run::Paused;
                return noted(
                    client_.runProgram(paused ? QStringLiteral("resume") : QStringLiteral("play"), deadline));
            }
            case RobotCommand::Pause:
                return noted(client_.runProgram(QStringLiteral("pause"), deadline));
            case RobotCommand::StopProgram:
                return noted(client_.runProgram(QStringLiteral("stop"), deadline));
        }
        return Error{ErrorCode::Internal, QStringLiteral("unknown command"), {}};
    }
    Result<void> unlockProtectiveStop(const Deadline& deadline) override {
        return noted(client_.unlockProtectiveStop(deadline));
    }
    Result<void> loadProgram(const Text& name, const Deadline& deadline) override {
        QString bare = name;
        if (bare.endsWith(QLatin1String(".urpx"), Qt::CaseInsensitive)) {
            bare.chop(5);
        }
        if (version_ >= kAsksAndLoads) {
            return noted(client_.loadProgram(bare, deadline));
        }
        const auto loaded = client_.request("PUT", QStringLiteral("/program/v1/load"),
                                            {{QStringLiteral("programName"), bare}}, deadline);
        return noted(loaded ? Result<void>() : Result<void>(loaded.error()));
    }
    Result<QStringList> programs(const Deadline& deadline) override {
        const auto reply = noted(client_.request("GET", QStringLiteral("/programs/v1/"), {}, deadline));
        if (!reply) {
            return reply.error();
        }
        QStringList names;
        for (const QJsonValue& program : (*reply)[QLatin1String("programs")].toArray()) {
            names << program.toObject()[QLatin1String("name")].toString();
        }
        names.removeAll(QString());
        return names;
    }
    Result<ServiceReport> look(const Deadline& deadline) override {
        ServiceReport report;
        report.kind = kind();
        if (version_ < kAsksAndLoads) {
            // This version does not support queries. Only check whether the API still responds.
            const auto state = noted(client_.programState(deadline));
            return state ? Result<ServiceReport>(report) : Result<ServiceReport>(state.error());
        }
        const auto remote = noted(client_.isInRemoteControl(deadline));
        if (!remote) {
            return remote.error();
        }
        report.remoteControl = *remote;
        const auto word = [&](const char* path, const char* key) {
            const auto reply = client_.request("GET", QLatin1String(path), {}, deadline);
            return reply ? (*reply)[QLatin1String(key)].toString() : QString();
        };
        report.operationalMode = word("/system/v1/operationalmode", "mode");
        report.program = word("/program/v1/loaded", "name");
        const auto run = client_.programState(deadline);
        report.programIsStopped = run && *run == ProgramState::Run::Stopped;
        return report;
    }

private:
    /// First version of the API that supports queries and the changed load command.
    static inline const QVersionNumber kAsksAndLoads{3, 1, 4};

    template <class T>
    Result<T> noted(Result<T> result) {
        const ErrorCode code = result ? ErrorCode::None : result.error().code;
        gone_ = code == ErrorCode::ConnectionRefused || code == ErrorCode::HostUnreachable ||
                code == ErrorCode::ConnectionClosed || code == ErrorCode::Timeout;
        return result;
    }

    RobotApiClient client_;
    QVersionNumber version_;
    bool gone_ = false;
};

}  // namespace

ServiceAddress serviceAt(const Text& host, int portOffset) {
    return {host, kDashboardPort + portOffset, kRobotApiPort + portOffset};
}

Result<std::unique_ptr<RobotService>> openService(const ServiceAddress& address, const Deadline& deadline) {
    auto dashboard = std::make_unique<DashboardClient>(address.host, address.dashboardPort);
    // A firewall may drop the packets, so reserve time for the other port.
    const auto connected = dashboard->connect(Deadline::after(deadline.remaining() / 2, deadline.token()));
    if (connected) {
        return std::unique_ptr<RobotService>(std::make_unique<DashboardService>(std::move(dashboard)));
    }
    const ErrorCode code = connected.error().code;
    if (code == ErrorCode::ConnectionRefused || code == ErrorCode::Timeout) {
        const RobotApiClient api(address.host, address.robotApiPort);
        if (const auto version = api.apiVersion(deadline)) {
            return std::unique_ptr<RobotService>(
                std::make_unique<RobotApiService>(address, QVersionNumber::fromString(*version)));
        }
    }
    return connected.error();
}

}  // namespace tiller::dashboard
