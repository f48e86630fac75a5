// SPDX-License-Identifier: MIT
#include "robot/dashboard/detail/dashboard_commands.h"

#include <array>
#include <optional>
#include <utility>

namespace tiller::dashboard {

namespace {

Error rejected(const QString& line, const QString& reply) {
    return {ErrorCode::Rejected, QStringLiteral("dashboard command \"%1\"").arg(line), reply};
}

/// The part of the reply that follows its documented prefix.
Result<QString> after(DashboardClient& client, const QString& line, const QString& prefix,
                      const Deadline& deadline) {
    const auto reply = client.command(line, deadline);
    if (reply && !reply->startsWith(prefix)) {
        return rejected(line, *reply);
    }
    return reply ? Result<QString>(reply->mid(prefix.size()).trimmed()) : reply;
}

Result<void> expect(DashboardClient& client, const QString& line, const QString& prefix,
                    const Deadline& deadline) {
    const auto reply = after(client, line, prefix, deadline);
    return reply ? Result<void>() : Result<void>(reply.error());
}

std::optional<bool> truth(const QString& word) {
    if (word.compare(QLatin1String("true"), Qt::CaseInsensitive) == 0) {
        return true;
    }
    if (word.compare(QLatin1String("false"), Qt::CaseInsensitive) == 0) {
        return false;
    }
    return std::nullopt;
}

constexpr std::array<std::pair<UserRole, const char*>, 5> kRoles{{{UserRole::Programmer, "programmer"},
                                                                  {UserRole::Operator, "operator"},
                                                                  {UserRole::None, "none"},
                                                                  {UserRole::Locked, "locked"},
                                                                  {UserRole::Restricted, "restricted"}}};

constexpr std::array<std::pair<OperationalMode, const char*>, 3> kModes{
    {{OperationalMode::None, "NONE"},
     {OperationalMode::Manual, "MANUAL"},
     {OperationalMode::Automatic, "AUTOMATIC"}}};

constexpr std::array<std::pair<FlightReport, const char*>, 3> kReports{
    {{FlightReport::Controller, "controller"},
     {FlightReport::Software, "software"},
     {FlightReport::System, "system"}}};

template <class Table, class Value>
QString nameOf(const Table& table, Value value) {
    for (const auto& [known, name] : table) {
        if (known == value) {
            return QString::fromLatin1(name);
        }
    }
    return {};
}

template <class Value, class Table>
Result<Value> byName(const Table& table, const QString& line, const Result<QString>& reply) {
    if (!reply) {
        return reply.error();
    }
    for (const auto& [value, name] : table) {
        if (reply->compare(QLatin1String(name), Qt::CaseInsensitive) == 0) {
            return value;
        }
    }
    return rejected(line, *reply);
}

}  // namespace

Result<bool> isRunning(DashboardClient& client, const Deadline& deadline) {
    const QString line = QStringLiteral("running");
    const auto reply = client.command(line, deadline);
    if (!reply) {
        return reply.error();
    }
    // The reply is "Program running: true", or "Robot running: True" in older software.
    const auto yes = truth(reply->section(QLatin1Char(':'), 1).trimmed());
    return yes ? Result<bool>(*yes) : Result<bool>(rejected(line, *reply));
}

Result<QString> loadedProgram(DashboardClient& client, const Deadline& deadline) {
    const QString line = QStringLiteral("get loaded program");
    const auto reply = client.command(line, deadline);
    const QString prefix = QStringLiteral("Loaded program: ");
    if (reply && reply->startsWith(QLatin1String("No program loaded"))) {
        return QString();
    }
    if (reply && !reply->startsWith(prefix)) {
        return rejected(line, *reply);
    }
    return reply ? Result<QString>(reply->mid(prefix.size()).trimmed()) : reply;
}

Result<SavedState> isProgramSaved(DashboardClient& client, const Deadline& deadline) {
    const QString line = QStringLiteral("isProgramSaved");
    const auto reply = client.command(line, deadline);
    if (!reply) {
        return reply.error();
    }
    const auto yes = truth(reply->section(QLatin1Char(' '), 0, 0));
    if (!yes) {
        return rejected(line, *reply);
    }
    return SavedState{*yes, reply->section(QLatin1Char(' '), 1).trimmed()};
}

Result<void> loadInstallation(DashboardClient& client, const Text& path, const Deadline& deadline) {
    return expect(client, QStringLiteral("load installation ") + path,
                  QStringLiteral("Loading installation: "), deadline);
}

Result<SafetyMode> safetyStatus(DashboardClient& client, const Deadline& deadline) {
    const QString line = QStringLiteral("safetystatus");
    const auto value = after(client, line, QStringLiteral("Safetystatus: "), deadline);
    if (!value) {
        return value.error();
    }
    for (int number = static_cast<int>(SafetyMode::Normal);
         number <= static_cast<int>(SafetyMode::SafetyApiSafeguardStop); ++number) {
        const auto mode = static_cast<SafetyMode>(number);
        if (safetyModeName(mode) == *value) {
            return mode;
        }
    }
    return rejected(line, *value);
}

Result<void> saveLog(DashboardClient& client, const Deadline& deadline) {
    return expect(client, QStringLiteral("saveLog"), QStringLiteral("Log saved to disk"), deadline);
}

Result<void> setUserRole(DashboardClient& client, UserRole role, const Deadline& deadline) {
    return expect(client, QStringLiteral("setUserRole ") + nameOf(kRoles, role),
                  QStringLiteral("Setting user role: "), deadline);
}

Result<UserRole> userRole(DashboardClient& client, const Deadline& deadline) {
    const QString line = QStringLiteral("getUserRole");
    return byName<UserRole>(kRoles, line, client.command(line, deadline));
}

Result<QString> version(DashboardClient& client, const Deadline& deadline) {
    const QString line = QStringLiteral("version");
    const auto reply = client.command(line, deadline);
    if (reply && (reply->isEmpty() || !reply->front().isDigit())) {
        return rejected(line, *reply);
    }
    return reply;
}

Result<void> setOperationalMode(DashboardClient& client, OperationalMode mode, const Deadline& deadline) {
    const QString line = QStringLiteral("set operational mode ") + nameOf(kModes, mode).toLower();
    const auto reply = client.command(line, deadline);
    if (!reply) {
        return reply.error();
    }
    // Two wordings are known: "Operational mode MANUAL is set" and "Setting operational mode: manual".
    const bool done = reply->startsWith(QLatin1String("Operational mode "), Qt::CaseInsensitive) ||
                      reply->startsWith(QLatin1String("Setting operational mode"), Qt::CaseInsensitive);
    return done ? Result<void>() : Result<void>(rejected(line, *reply));
}

Result<OperationalMode> operationalMode(DashboardClient& client, const Deadline& deadline) {
    const QString line = QStringLiteral("get operational mode");
    return byName<OperationalMode>(kModes, line, client.command(line, deadline));
}

Result<void> clearOperationalMode(DashboardClient& client, const Deadline& deadline) {
    const QString line = QStringLiteral("clear operational mode");
    const auto reply = client.command(line, deadline);
    if (!reply) {
        return reply.error();
    }
    const bool done = reply->contains(QLatin1String("no longer control"), Qt::CaseInsensitive);
    return done ? Result<void>() : Result<void>(rejected(line, *reply));
}

Result<QString> generateFlightReport(DashboardClient& client, FlightReport kind, const Deadline& deadline) {
    return after(client, QStringLiteral("generate flight report ") + nameOf(kReports, kind),
                 QStringLiteral("Flight Report generated with id:"), deadline);
}

Result<QString> generateSupportFile(DashboardClient& client, const Text& directory,
                                    const Deadline& deadline) {
    return after(client, QStringLiteral("generate support file ") + directory,
                 QStringLiteral("Completed successfully:"), deadline);
}

Result<void> quit(DashboardClient& client, const Deadline& deadline) {
    const auto said = expect(client, QStringLiteral("quit"), QStringLiteral("Disconnected"), deadline);
    client.close();
    return said;
}

Result<void> shutdown(DashboardClient& client, const Deadline& deadline) {
    const auto said = expect(client, QStringLiteral("shutdown"), QStringLiteral("Shutting down"), deadline);
    if (said) {
        client.close();
    }
    return said;
}

}  // namespace tiller::dashboard
